// ray_march: layout and uniforms. The march itself is ray_march.comp.glsl.
#include <array>

#include "geometry/camera_rays.hpp"
#include "layout_builder.hpp"
#include "stages/debug_views.hpp"
#include "stages/local_lights.hpp"
#include "stages/suns.hpp"
#include "technique.hpp"
#include "techniques/ray_march/ray_march_blocks.h"

namespace volumetrics {
namespace {

constexpr std::array kReads = {"volumetrics.enabled", "volumetrics.technique", "volumetrics.placement",
                               "volumetrics.steps",   "volumetrics.jitter",    "volumetrics.march_spacing",
                               "medium.sigma_t",      "medium.albedo",         "medium.g"};

void layout(const LayoutContext& context, LayoutBuilder& builder) {
  builder.uniform("frame", sizeof(RayMarchBlock), false);
  builder.uniform("sun", sizeof(SunBlock), true);
  builder.uniform("local light", sizeof(LocalBlock), true);
  builder.uniform("cookie", sizeof(CookieBlock), true);
  const bool add = beginLights(context, builder, kFrameBlock);
  const std::uint32_t x = groups8(context.structure.width), y = groups8(context.structure.height);
  if (context.directionalLights > 0)
    builder.compute({"march",
                     "ray_march.comp",
                     {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), sceneDepthAt(2), shadowMapAt(3),
                      outputAt(4, add ? TY_ACCESS_STORAGE_READ_WRITE : TY_ACCESS_STORAGE_WRITE),
                      uniformAt(5, kCookieBlock), lightCookieAt(6, context.sunCookies > 0)},
                     x,
                     y,
                     1,
                     kSuns,
                     {{0, add ? 0u : 1u}, {1, context.sunCookies > 0 ? 1u : 0u}}});
  if (context.localLights() > 0)
    builder.compute({"march local",
                     "ray_march_local.comp",
                     {uniformAt(0, kFrameBlock), uniformAt(1, kLocalBlock), sceneDepthAt(2), shadowMapAt(3),
                      outputAt(4, TY_ACCESS_STORAGE_READ_WRITE), uniformAt(5, kCookieBlock),
                      lightCookieAt(6, context.localCookies > 0)},
                     x,
                     y,
                     1,
                     kLocalLights,
                     {{0, add ? 0u : 1u}, {1, context.localCookies > 0 ? 1u : 0u}}});
  if (context.structure.light_count > 0)
    addDifferenceView(context, builder, kFrameBlock, kLightBlock, kLocalBlock, kCookieBlock);
}

void prepare(const FrameContext& context) {
  auto& frame = context.block<RayMarchBlock>(kFrameBlock);
  frame.rays = rayBlock(*context.frame.view, context.settings);
  frame.march.steps = context.settings.steps;
  frame.march.jitter = context.settings.jitter;
  frame.march.march_spacing = context.settings.march_spacing;
  for (std::uint32_t i = 0; i < context.frame.light_count; ++i)
    context.block<CookieBlock>(kCookieBlock, i) = cookieBlock(context.frame.lights[i], frame.rays.eye);
  for (std::uint32_t i = 0; i < context.frame.light_count; ++i)
    if (context.frame.lights[i].kind == TY_LIGHT_DIRECTIONAL)
      context.block<SunBlock>(kLightBlock, i) = sunBlock(context.frame.lights[i], frame.rays.eye);
  prepareLocalLights(context, kLocalBlock, frame.rays);
}

constexpr std::array kTechniques = {
    Technique{"ray_march", "Ray march", "One march per pixel and light through its shadow map: the plain reference.",
              kReads, layout, prepare, true}};

}  // namespace

std::span<const Technique> ray_marchTechniques() { return kTechniques; }

}  // namespace volumetrics
