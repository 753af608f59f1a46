// ray_march: layout and uniforms. The march itself is ray_march.comp.glsl.
#include <array>

#include "geometry/camera_rays.hpp"
#include "layout_builder.hpp"
#include "stages/debug_views.hpp"
#include "stages/suns.hpp"
#include "technique.hpp"
#include "techniques/ray_march/ray_march_blocks.h"

namespace volumetrics {
namespace {

constexpr std::array kReads = {"volumetrics.enabled", "volumetrics.technique", "volumetrics.placement", "volumetrics.steps",
                               "volumetrics.jitter", "volumetrics.march_spacing", "medium.sigma_t", "medium.albedo", "medium.g"};

void layout(const LayoutContext& context, LayoutBuilder& builder) {
  builder.uniform("frame", sizeof(RayMarchBlock), false);
  builder.uniform("sun", sizeof(SunBlock), true);
  const bool add = beginSuns(context, builder, kFrameBlock);
  if (context.directionalLights == 0) return;
  builder.compute({"march", "ray_march.comp",
                   {uniformAt(0, kFrameBlock), uniformAt(1, kSunBlock), sceneDepthAt(2), shadowMapAt(3),
                    outputAt(4, add ? TY_ACCESS_STORAGE_READ_WRITE : TY_ACCESS_STORAGE_WRITE)},
                   groups8(context.structure.width), groups8(context.structure.height), 1, true, {{0, add ? 0u : 1u}}});
  addDifferenceView(context, builder, kFrameBlock, kSunBlock);
}

void prepare(const FrameContext& context) {
  auto& frame = context.block<RayMarchBlock>(kFrameBlock);
  frame.rays = rayBlock(*context.frame.view, context.settings);
  frame.march.steps = context.settings.steps;
  frame.march.jitter = context.settings.jitter;
  frame.march.march_spacing = context.settings.march_spacing;
  for (std::uint32_t i = 0; i < context.frame.light_count; ++i)
    if (context.frame.lights[i].kind == TY_LIGHT_DIRECTIONAL)
      context.block<SunBlock>(kSunBlock, i) = sunBlock(context.frame.lights[i], frame.rays.eye);
}

constexpr std::array kTechniques = {
    Technique{"ray_march", "Ray march", "One march per pixel through the shadow map: the plain reference.", kReads, layout, prepare}};

}  // namespace

std::span<const Technique> ray_marchTechniques() { return kTechniques; }

}  // namespace volumetrics
