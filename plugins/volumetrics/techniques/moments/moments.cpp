// moments4 and moments6: layout and uniforms. Kernels: stages/slices, stages/rectify, moments_prefix, moments_evaluate.
#include <array>

#include "layout_builder.hpp"
#include "stages/debug_views.hpp"
#include "stages/prefix.hpp"
#include "stages/suns.hpp"
#include "technique.hpp"
#include "techniques/moments/storage.hpp"

namespace volumetrics {
namespace {

constexpr std::array kReads = {TY_RECTIFY_READS, TY_PREFIX_READS, "volumetrics.overestimation",
                               "volumetrics.precision"};

/// Views of the single moments, from the stored combinations of them.
void addMomentViews(LayoutBuilder& builder, const RectifyStage& stage, const std::vector<TySpecialization>& constants,
                    const std::vector<std::uint32_t>& images, int moments) {
  const std::uint32_t shown = builder.image("moments", TY_FORMAT_RGBA32_FLOAT, stage.slices, stage.rows, 2, true);
  builder.compute({"debug moments",
                   "moments_debug.comp",
                   {sampledAt(0, images[0]), sampledAt(1, images[1]), storageAt(2, shown)},
                   groups8(stage.slices),
                   groups8(stage.rows),
                   1,
                   kEachLight,
                   constants});
  for (int i = 0; i < moments; ++i)
    builder.debugView(
        "moment_" + std::to_string(i + 1),
        "Prefix average of the depth's power " + std::to_string(i + 1) + " (depth in [-1, 1]), first reference ray",
        TY_SOURCE_IMAGE, shown, static_cast<std::uint32_t>(i / 4), static_cast<std::uint32_t>(i % 4),
        i % 2 == 0 ? -1.0f : 0.0f, 1.0f, TY_VIEW_ROWS);
}

template <int kMoments>
void addClass(const LayoutContext& context, LayoutBuilder& builder, const LightClass& lights, bool add) {
  const Settings& settings = context.settings;
  const MomentStorage storage = momentStorage(kMoments, static_cast<Precision>(settings.precision));
  beginClass(context, builder, lights);
  const RectifyStage stage = addRectify(context, builder, lights, storage.depth, true);

  const auto rays = static_cast<std::uint32_t>(settings.reference_rays);
  PrefixTechnique technique{"moments_prefix.comp", "moments_evaluate.comp"};
  technique.vectors = kMoments == 4 ? 1 : 2;
  technique.compensated = storage.compensated;
  technique.prefixConstants = {{0, kMoments}, {2, storage.quantise ? 1u : 0u}, {4, storage.threeAndThree ? 1u : 0u}};
  technique.evaluateConstants = technique.prefixConstants;
  technique.images = {prefixImage(context, builder, stage, "moments_a", storage.first, rays),
                      storage.second == TY_FORMAT_UNKNOWN
                          ? unusedImage(builder, "moments_b", TY_FORMAT_RG16_UNORM)
                          : prefixImage(context, builder, stage, "moments_b", storage.second, rays)};
  addPrefix(context, builder, stage, technique, add);

  const float low = storage.quantise ? 0.0f : -1.0f;
  builder.debugView("prefix_a", "Stored prefix of the moments, first image, first three channels, first reference ray",
                    TY_SOURCE_IMAGE, technique.images[0], 0, 4, low, 1.0f, TY_VIEW_ROWS);
  if (storage.second != TY_FORMAT_UNKNOWN)
    builder.debugView("prefix_b", "Stored prefix of the moments, second image, first reference ray", TY_SOURCE_IMAGE,
                      technique.images[1], 0, 4, low, 1.0f, TY_VIEW_ROWS);
  addMomentViews(builder, stage, technique.prefixConstants, technique.images, kMoments);
  addRowViews(context, builder, stage);
}

template <int kMoments>
void layout(const LayoutContext& context, LayoutBuilder& builder) {
  addRowLayout(context, builder, addClass<kMoments>);
}

template <int kMoments>
void prepare(const FrameContext& context) {
  prepareRectify(context);
  const MomentStorage storage = momentStorage(kMoments, static_cast<Precision>(context.settings.precision));
  auto& frame = context.block<RectifiedBlock>(kFrameBlock);
  frame.overestimation = context.settings.overestimation;
  frame.momentBias = storage.bias;
  frame.biasTarget = storage.evenTarget;
}

constexpr std::array kTechniques = {
    Technique{"moments4", "Prefiltered moments (4)",
              "Prefix sums of four moments over rectified rows; one look-up a pixel and reference ray.", kReads,
              layout<4>, prepare<4>, true},
    Technique{"moments6", "Prefiltered moments (6)",
              "Prefix sums of six moments over rectified rows; one look-up a pixel and reference ray.", kReads,
              layout<6>, prepare<6>, true}};

}  // namespace

std::span<const Technique> momentsTechniques() { return kTechniques; }

}  // namespace volumetrics
