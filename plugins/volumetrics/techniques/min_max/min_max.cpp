// min_max: layout and uniforms. Kernels: stages/slices, stages/rectify, min_max_low, min_max_high, min_max_evaluate.
#include <array>
#include <bit>

#include "layout_builder.hpp"
#include "stages/debug_views.hpp"
#include "stages/suns.hpp"
#include "technique.hpp"

namespace volumetrics {
namespace {

constexpr std::array kReads = {TY_RECTIFY_READS};
constexpr std::uint32_t kChunk = 64;  // tree.glsl

void addClass(const LayoutContext& context, LayoutBuilder& builder, const LightClass& suns, bool add) {
  // 16 bit hold resampled depths exactly as the map does; rasterised ones are 32-bit, and bounds must not be rounded.
  const bool epipolar = static_cast<Rectification>(context.settings.rectification) == Rectification::kEpipolar;
  beginClass(context, builder, suns);
  const RectifyStage stage = addRectify(context, builder, suns, epipolar ? DepthBits::k16 : DepthBits::k32, false);
  const TyFormat format = epipolar ? TY_FORMAT_RG16_UNORM : TY_FORMAT_RG32_FLOAT;
  const std::uint32_t chunks = (stage.rows + kChunk - 1) / kChunk;
  const std::uint32_t low = builder.image("min_max_low", format, stage.slices, chunks * kChunk);
  const std::uint32_t high = builder.image("min_max_high", format, stage.slices, std::bit_ceil(chunks));
  builder.compute(
      {"min-max low",
       "min_max_low.comp",
       {uniformAt(1, kLightBlock), sampledAt(3, stage.rectified), sampledAt(4, stage.projective), storageAt(5, low)},
       (stage.slices + 31) / 32,
       chunks,
       1,
       kEachLight,
       {}});
  builder.compute({"min-max high",
                   "min_max_high.comp",
                   {uniformAt(1, kLightBlock), sampledAt(3, low), storageAt(5, high)},
                   (stage.slices + 31) / 32,
                   1,
                   1,
                   kEachLight,
                   {}});
  const auto evaluate = [&](const char* name, const TyBinding& result, bool first, bool steps) {
    builder.compute(
        {name,
         "min_max_evaluate.comp",
         {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), sceneDepthAt(2),
          bufferAt(3, stage.sliceBuffer, TY_ACCESS_STORAGE_READ), shadowMapAt(4), result, sampledAt(6, stage.rectified),
          sampledAt(7, stage.projective), sampledAt(8, low), sampledAt(9, high), unshadowedAt21(stage)},
         groups8(context.structure.width),
         groups8(context.structure.height),
         1,
         kEachLight,
         {{5, static_cast<std::uint32_t>(context.settings.row_filter)}, {6, first ? 1u : 0u}, {7, steps ? 1u : 0u}}});
  };
  evaluate("evaluate", outputAt(5, add ? TY_ACCESS_STORAGE_READ_WRITE : TY_ACCESS_STORAGE_WRITE), !add, false);

  const std::uint32_t steps =
      builder.image("steps", TY_FORMAT_RGBA32_FLOAT, context.structure.width, context.structure.height);
  evaluate("debug steps", storageAt(5, steps), true, true);
  builder.debugView("steps", "Tree nodes visited by each pixel's ray, both rows together; white = 256", TY_SOURCE_IMAGE,
                    steps, 0, 0, 0.0f, 256.0f);
  builder.debugView("tree_min", "Minimum depth of the min-max trees, levels 1 to 6 from top to bottom", TY_SOURCE_IMAGE,
                    low, 0, 0, 0.0f, 1.0f);
  builder.debugView("tree_max", "Maximum depth of the min-max trees, levels 1 to 6 from top to bottom", TY_SOURCE_IMAGE,
                    low, 0, 1, 0.0f, 1.0f);
  addRowViews(context, builder, stage);
}

void layout(const LayoutContext& context, LayoutBuilder& builder) {
  addRowBlocks(context, builder);
  const bool add = beginSuns(context, builder, kFrameBlock, mayFade(context));
  if (context.directionalLights == 0) return;
  LightClass suns;  // cookies of suns are left out
  suns.fading = mayFade(context);
  if (suns.fading) addClass(context, builder, suns, add);
  suns.fading = false;
  addClass(context, builder, suns, add);
  addDifferenceView(context, builder, kFrameBlock, kLightBlock, TY_NONE, kCookieBlock);
}

void prepare(const FrameContext& context) { prepareRectify(context); }

constexpr std::array kTechniques = {
    Technique{"min_max", "Min-max trees",
              "Walks 1D min-max trees over rectified rows: exact on its map, as many steps as the depths are complex.",
              kReads, layout, prepare}};

}  // namespace

std::span<const Technique> min_maxTechniques() { return kTechniques; }

}  // namespace volumetrics
