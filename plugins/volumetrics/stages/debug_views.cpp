#include "stages/debug_views.hpp"

#include "stages/suns.hpp"

namespace volumetrics {

void addDifferenceView(const LayoutContext& context, LayoutBuilder& builder, std::uint32_t frameBlock,
                       std::uint32_t sunBlock, std::uint32_t localBlock, std::uint32_t cookieBlock) {
  const std::uint32_t width = context.structure.width, height = context.structure.height;
  const std::uint32_t dense = builder.image("dense march", TY_FORMAT_RGBA32_FLOAT, width, height);
  const std::uint32_t difference = builder.image("difference", TY_FORMAT_RGBA32_FLOAT, width, height);
  const bool local = localBlock != TY_NONE && context.localLights() > 0;
  const bool add = context.directionalLights != 1 || local;
  if (add)
    builder.compute({"debug clear",
                     "clear.comp",
                     {uniformAt(0, frameBlock), sceneDepthAt(1), storageAt(2, dense)},
                     groups8(width),
                     groups8(height),
                     1,
                     0,
                     {}});
  if (context.directionalLights > 0)
    builder.compute({"debug dense march",
                     "debug_march.comp",
                     {uniformAt(0, frameBlock), uniformAt(1, sunBlock), sceneDepthAt(2), shadowMapAt(3),
                      storageAt(4, dense, add ? TY_ACCESS_STORAGE_READ_WRITE : TY_ACCESS_STORAGE_WRITE),
                      uniformAt(5, cookieBlock), lightCookieAt(6, context.sunCookies > 0)},
                     groups8(width),
                     groups8(height),
                     1,
                     kSuns,
                     {{0, add ? 0u : 1u}, {1, context.sunCookies > 0 ? 1u : 0u}}});
  if (local)
    builder.compute({"debug dense march local",
                     "debug_march_local.comp",
                     {uniformAt(0, frameBlock), uniformAt(1, localBlock), sceneDepthAt(2), shadowMapAt(3),
                      storageAt(4, dense, TY_ACCESS_STORAGE_READ_WRITE), uniformAt(5, cookieBlock),
                      lightCookieAt(6, context.localCookies > 0)},
                     groups8(width),
                     groups8(height),
                     1,
                     kLocalLights,
                     {{1, context.localCookies > 0 ? 1u : 0u}}});
  builder.compute({"debug difference",
                   "debug_difference.comp",
                   {outputAt(0, TY_ACCESS_SAMPLED), sampledAt(1, dense), storageAt(2, difference)},
                   groups8(width),
                   groups8(height),
                   1,
                   0,
                   {}});
  builder.debugView("dense_march", "Dense march of every light through its shadow map, RGB radiance", TY_SOURCE_IMAGE,
                    dense, 0, 4, 0.0f, 1.0f, TY_VIEW_REFERENCE);
  builder.debugView("difference", "Absolute difference to the dense march, RGB radiance, ten times as bright",
                    TY_SOURCE_IMAGE, difference, 0, 4, 0.0f, 0.1f);
}

void addRowViews(const LayoutContext& context, LayoutBuilder& builder, const RectifyStage& stage) {
  const auto rays = static_cast<std::uint32_t>(context.settings.reference_rays);
  const std::uint32_t width = context.structure.width, height = context.structure.height;
  const std::uint32_t pixels = builder.image("rays", TY_FORMAT_RGBA32_FLOAT, width, height);
  builder.compute({"debug rays",
                   "debug_rays.comp",
                   {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), sceneDepthAt(2),
                    bufferAt(3, stage.sliceBuffer, TY_ACCESS_STORAGE_READ), shadowMapAt(4), storageAt(5, pixels),
                    sampledAt(6, stage.rectified), sampledAt(7, stage.projective), unshadowedAt21(stage)},
                   groups8(width),
                   groups8(height),
                   1,
                   kEachLight,
                   {{1, rays}, {8, stage.filtered ? 1u : 0u}}});
  builder.debugView("slice", "Slice of each pixel, 0 to 1 over all slices (of the last sun)", TY_SOURCE_IMAGE, pixels,
                    0, 0, 0.0f, 1.0f);
  builder.debugView("inclination", "Inclination of each pixel's ray, 0 to pi (of the last sun)", TY_SOURCE_IMAGE,
                    pixels, 0, 1, 0.0f, 1.0f);
  builder.debugView("reference_ray_error",
                    "Mean visibility by the reference rays minus by the ray's own weights, absolute, on the rectified "
                    "map; white = 0.1",
                    TY_SOURCE_IMAGE, pixels, 0, 2, 0.0f, 0.1f);
  builder.debugView("row_visibility",
                    "Mean visibility of the rectified row up to the surface, by the ray's own weights", TY_SOURCE_IMAGE,
                    pixels, 0, 3, 0.0f, 1.0f);

  const std::uint32_t weights = builder.image("weights", TY_FORMAT_R32_FLOAT, stage.slices, stage.rows, rays, true);
  builder.compute({"debug weights",
                   "debug_weights.comp",
                   {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock),
                    bufferAt(2, stage.sliceBuffer, TY_ACCESS_STORAGE_READ), storageAt(3, weights)},
                   groups8(stage.slices),
                   groups8(stage.rows),
                   rays,
                   kEachLight,
                   {{1, rays}}});
  for (std::uint32_t k = 0; k < rays; ++k)
    builder.debugView("weights_" + std::to_string(k),
                      "Weight of each column for reference ray " + std::to_string(k) +
                          ", relative to an even share; black 0, white 2",
                      TY_SOURCE_IMAGE, weights, k, 0, 0.0f, 2.0f, TY_VIEW_ROWS);

  const std::uint32_t places = builder.image("row places", TY_FORMAT_RGBA32_FLOAT, width, height);
  builder.compute({"debug row places",
                   "debug_places.comp",
                   {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), sceneDepthAt(2),
                    bufferAt(3, stage.sliceBuffer, TY_ACCESS_STORAGE_READ), shadowMapAt(4), storageAt(5, places),
                    sampledAt(6, stage.rectified), unshadowedAt21(stage)},
                   groups8(width),
                   groups8(height),
                   1,
                   kEachLight,
                   {}});
  builder.debugView("row_place",
                    "Where the end of each pixel's ray lies in the maps of rows: slice and column, 0 to 1, inclination "
                    "(rad), depth (of the last light)",
                    TY_SOURCE_IMAGE, places, 0, 4, 0.0f, 1.0f, TY_VIEW_ROW_PLACE);
  const std::uint32_t lightRays =
      builder.image("light rays", TY_FORMAT_RGBA32_FLOAT, stage.slices, stage.rows, 3, true);
  builder.compute(
      {"debug light rays",
       "debug_light_rays.comp",
       {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), bufferAt(2, stage.sliceBuffer, TY_ACCESS_STORAGE_READ),
        sampledAt(3, stage.rectified), sampledAt(4, stage.projective), storageAt(5, lightRays)},
       groups8(stage.slices),
       groups8(stage.rows),
       1,
       kEachLight,
       {{8, stage.filtered ? 1u : 0u}}});
  builder.debugView("light_ray_start",
                    "World point (m) of the light ray of each texel of the rows, nearer to the light than what is seen "
                    "of it (of the last light)",
                    TY_SOURCE_IMAGE, lightRays, 0, 4, -10.0f, 10.0f, TY_VIEW_LIGHT_RAY_START);
  builder.debugView(
      "light_ray_end",
      "World point (m) of the first blocker on the light ray of each texel of the rows, or its last point in view",
      TY_SOURCE_IMAGE, lightRays, 1, 4, -10.0f, 10.0f, TY_VIEW_LIGHT_RAY_END);
  builder.debugView("row_depths",
                    "Depth of the first blocker of each texel of the rows, whichever rectification the view has; white "
                    "= none (of the last light)",
                    TY_SOURCE_IMAGE, lightRays, 2, 0, 0.0f, 1.0f, TY_VIEW_ROW_DEPTHS);
}

void addRowLayout(const LayoutContext& context, LayoutBuilder& builder,
                  void (*addClass)(const LayoutContext&, LayoutBuilder&, const LightClass&, bool)) {
  addRowBlocks(context, builder);
  const bool add = beginLights(context, builder, kFrameBlock, mayFade(context));
  for (const LightClass& lights : lightClasses(context)) addClass(context, builder, lights, add);
  if (context.structure.light_count > 0)
    addDifferenceView(context, builder, kFrameBlock, kLightBlock, kLocalBlock, kCookieBlock);
}

}  // namespace volumetrics
