// moments4 and moments6: layout and uniforms. Kernels: stages/slices, stages/rectify, moments_prefix, moments_evaluate.
#include <array>

#include "layout_builder.hpp"
#include "stages/rectify.hpp"
#include "stages/suns.hpp"
#include "technique.hpp"
#include "techniques/moments/storage.hpp"

namespace volumetrics {
namespace {

constexpr std::uint32_t kFrameBlock = 0, kSunBlock = 1;
enum class RowFilter { kNearest, kLinear, kMipmapped };

constexpr std::array kReads = {TY_RECTIFY_READS, "volumetrics.overestimation", "volumetrics.precision"};

template <int kMoments>
void layout(const LayoutContext& context, LayoutBuilder& builder) {
  const Settings& settings = context.settings;
  const MomentStorage storage = momentStorage(kMoments, static_cast<Precision>(settings.precision));
  const auto slices = static_cast<std::uint32_t>(settings.slices);
  const auto columns = static_cast<std::uint32_t>(settings.columns);
  const auto rays = static_cast<std::uint32_t>(settings.reference_rays);
  const bool bounds = settings.prefix_bounds != 0;
  const bool linearRows = static_cast<RowFilter>(settings.row_filter) == RowFilter::kLinear;

  builder.uniform("frame", sizeof(RectifiedBlock), false);
  builder.uniform("sun", sizeof(RectifiedSunBlock), true);
  const bool add = beginSuns(context, builder, kFrameBlock);
  if (context.directionalLights == 0) return;
  const RectifyStage rectify = addRectify(context, builder, kFrameBlock, kSunBlock, storage.rectified);

  // A shader needs something bound even where a specialization never reads it: then a single texel.
  const std::uint32_t first = builder.image("moments_a", storage.first, slices, columns, rays, true);
  const std::uint32_t second = storage.second == TY_FORMAT_UNKNOWN
                                   ? builder.image("moments_b", TY_FORMAT_RG16_UNORM, 1, 1, 1, true)
                                   : builder.image("moments_b", storage.second, slices, columns, rays, true);
  const std::uint32_t range = bounds ? builder.image("prefix_bounds", TY_FORMAT_RG16_UNORM, slices, columns)
                                     : builder.image("prefix_bounds", TY_FORMAT_RG16_UNORM, 1, 1);

  // "auto" stands for the first variant until the host has timed both.
  const bool block = static_cast<PrefixScheme>(settings.prefix_scheme) == PrefixScheme::kBlock;
  const std::vector<TySpecialization> variant = {{0, kMoments},
                                                 {1, rays},
                                                 {2, storage.quantise ? 1u : 0u},
                                                 {3, bounds ? 1u : 0u},
                                                 {4, storage.threeAndThree ? 1u : 0u}};
  ComputePass prefix{"prefix", "moments_prefix.comp",
                     {uniformAt(0, kFrameBlock), uniformAt(1, kSunBlock),
                      bufferAt(2, rectify.sliceBuffer, TY_ACCESS_STORAGE_READ), sampledAt(3, rectify.rectified),
                      storageAt(4, first), storageAt(5, second), storageAt(6, range)},
                     block ? groups8(slices) : (slices + 31) / 32, 1, 1, true, variant};
  prefix.specializations.push_back({10, block ? 8u : 32u});
  prefix.specializations.push_back({11, block ? 8u : 1u});
  builder.compute(std::move(prefix));

  ComputePass evaluate{"evaluate", "moments_evaluate.comp",
                       {uniformAt(0, kFrameBlock), uniformAt(1, kSunBlock), sceneDepthAt(2),
                        bufferAt(3, rectify.sliceBuffer, TY_ACCESS_STORAGE_READ),
                        sampledAt(4, first, TY_SAMPLER_LINEAR_CLAMP), sampledAt(5, second, TY_SAMPLER_LINEAR_CLAMP),
                        sampledAt(6, range),
                        outputAt(7, add ? TY_ACCESS_STORAGE_READ_WRITE : TY_ACCESS_STORAGE_WRITE)},
                       groups8(context.structure.width), groups8(context.structure.height), 1, true, variant};
  evaluate.specializations.push_back({5, linearRows ? 1u : 0u});
  evaluate.specializations.push_back({6, add ? 0u : 1u});
  builder.compute(std::move(evaluate));

  const float low = storage.quantise ? 0.0f : -1.0f;
  builder.debugView("moments", "Prefix of the moments, first three channels, first reference ray", TY_SOURCE_IMAGE, first, 0, 4,
                    low, 1.0f);
  if (storage.second != TY_FORMAT_UNKNOWN)
    builder.debugView("moments_high", "Prefix of the remaining moments, first reference ray", TY_SOURCE_IMAGE, second, 0, 4, low,
                      1.0f);
  if (bounds) {
    builder.debugView("prefix_min", "Prefix minimum of the inclination of the first blocker: rays below it are lit",
                      TY_SOURCE_IMAGE, range, 0, 0, 0.0f, 1.0f);
    builder.debugView("prefix_max", "Prefix maximum of the inclination of the first blocker: rays above it are shadowed",
                      TY_SOURCE_IMAGE, range, 0, 1, 0.0f, 1.0f);
  }
  builder.tunable(prefixSchemeIndex(), static_cast<double>(PrefixScheme::kAuto),
                  {static_cast<double>(PrefixScheme::kRow), static_cast<double>(PrefixScheme::kBlock)}, {"prefix"});
}

template <int kMoments>
void prepare(const FrameContext& context) {
  prepareRectify(context, kFrameBlock, kSunBlock);
  const MomentStorage storage = momentStorage(kMoments, static_cast<Precision>(context.settings.precision));
  auto& frame = context.block<RectifiedBlock>(kFrameBlock);
  frame.overestimation = context.settings.overestimation;
  frame.momentBias = storage.bias;
  frame.biasTarget = storage.evenTarget;
}

constexpr std::array kTechniques = {
    Technique{"moments4", "Prefiltered moments (4)",
              "Prefix sums of four moments over rectified rows; one look-up a pixel and reference ray.", kReads, layout<4>,
              prepare<4>},
    Technique{"moments6", "Prefiltered moments (6)",
              "Prefix sums of six moments over rectified rows; one look-up a pixel and reference ray.", kReads, layout<6>,
              prepare<6>}};

}  // namespace

std::span<const Technique> momentsTechniques() { return kTechniques; }

}  // namespace volumetrics
