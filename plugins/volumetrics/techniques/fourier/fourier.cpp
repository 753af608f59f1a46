// fourier: layout and uniforms. Kernels: stages/slices, stages/rectify, fourier_basis, fourier_prefix,
// fourier_evaluate.
#include <array>

#include "layout_builder.hpp"
#include "stages/debug_views.hpp"
#include "stages/prefix.hpp"
#include "stages/suns.hpp"
#include "technique.hpp"

namespace volumetrics {
namespace {

constexpr std::array kReads = {TY_RECTIFY_READS,          TY_PREFIX_READS,
                               "volumetrics.basis_count", "volumetrics.bases_per_thread",
                               "volumetrics.precision",   "volumetrics.basis_evaluation"};

enum class BasisEvaluation { kFused, kSeparate };

void addClass(const LayoutContext& context, LayoutBuilder& builder, const LightClass& lights, bool add) {
  const Settings& settings = context.settings;
  beginClass(context, builder, lights);
  const RectifyStage stage = addRectify(context, builder, lights, DepthBits::k16, true);

  const auto rays = static_cast<std::uint32_t>(settings.reference_rays);
  const std::uint32_t layers = (static_cast<std::uint32_t>(settings.basis_count) + 3) / 4;
  const std::uint32_t vectors = (static_cast<std::uint32_t>(settings.bases_per_thread) + 3) / 4;
  const bool separate = static_cast<BasisEvaluation>(settings.basis_evaluation) == BasisEvaluation::kSeparate;
  const TyFormat format =
      static_cast<Precision>(settings.precision) == Precision::kFull ? TY_FORMAT_RGBA16_UNORM : TY_FORMAT_RGBA8_UNORM;

  // With the basis evaluated in the filter this pass and its image exist for debug views alone, and run only for them.
  const std::uint32_t basis = builder.image("basis", format, stage.slices, stage.rows, layers, true);
  builder.compute({separate ? "basis" : "debug basis",
                   "fourier_basis.comp",
                   {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), sampledAt(3, stage.rectified),
                    sampledAt(4, stage.projective), storageAt(6, basis)},
                   groups8(stage.slices),
                   groups8(stage.rows),
                   layers,
                   kEachLight,
                   {{8, stage.filtered ? 1u : 0u}}});

  PrefixTechnique technique{"fourier_prefix.comp", "fourier_evaluate.comp"};
  technique.vectors = vectors;
  technique.groups = (layers + vectors - 1) / vectors;
  technique.compensated = format == TY_FORMAT_RGBA16_UNORM;
  technique.prefixConstants = {{0, vectors}, {2, layers}, {4, separate ? 1u : 0u}};
  technique.evaluateConstants = {{2, layers}};
  technique.images = {prefixImage(context, builder, stage, "prefix", format, layers * rays)};
  // The rectified map stands in where the shader never reads the stored basis.
  technique.extra = {sampledAt(7, separate ? basis : stage.rectified)};
  addPrefix(context, builder, stage, technique, add);

  for (int i = 0; i < settings.basis_count; ++i) {
    const std::string function =
        std::string(i % 2 == 0 ? "sin " : "cos ") + std::to_string(i / 2 * 2 + 1) + " pi depth";
    const auto layer = static_cast<std::uint32_t>(i / 4), channel = static_cast<std::uint32_t>(i % 4);
    builder.debugView("basis_" + std::to_string(i), "Basis function " + function + " of every texel", TY_SOURCE_IMAGE,
                      basis, layer, channel, 0.0f, 1.0f, TY_VIEW_ROWS);
    builder.debugView("prefix_" + std::to_string(i), "Prefix average of " + function + ", first reference ray",
                      TY_SOURCE_IMAGE, technique.images[0], layer, channel, 0.0f, 1.0f, TY_VIEW_ROWS);
  }
  addRowViews(context, builder, stage);
}

void layout(const LayoutContext& context, LayoutBuilder& builder) { addRowLayout(context, builder, addClass); }

void prepare(const FrameContext& context) {
  prepareRectify(context);
  context.block<RectifiedBlock>(kFrameBlock).basisCount = context.settings.basis_count;
}

constexpr std::array kTechniques = {Technique{"fourier", "Prefiltered Fourier basis",
                                              "Prefix sums of a Fourier expansion of the shadow test over rectified "
                                              "rows; a dot product a pixel and reference ray.",
                                              kReads, layout, prepare, true}};

}  // namespace

std::span<const Technique> fourierTechniques() { return kTechniques; }

}  // namespace volumetrics
