#include "debug_views.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace tyndall::render {

namespace {

constexpr std::uint32_t kRgb = 4, kNormal = 5;  // debug_view.frag's channels beyond R G B A

// The farthest corner of what casts shadows, so that the grey of "depth" spans the level rather than the far plane.
float levelDepth(const FrameData& frame) {
  float farthest = 0;
  for (const glm::vec3& corner : boxCorners(frame.draws.casters, frame.view.eye)) {
    farthest = std::max(farthest, glm::distance(corner, frame.view.eye));
  }
  return farthest > 0 ? std::min(farthest, frame.view.zfar) : frame.view.zfar;
}

}  // namespace

std::vector<DebugViewInfo> Renderer::debugViews() {
  return {{"depth", "distance along the ray, black at the eye, white at the level's far end"},
          {"normal", "shading normal, world space"},
          {"base_color", "base colour"},
          {"roughness", "roughness, 0 black to 1 white"},
          {"metallic", "metallic, 0 black to 0.5 grey; unlit surfaces white"},
          {"occlusion", "occlusion map, 0 black to 1 white"},
          {"emissive", "emitted radiance times exposure, without tone map"},
          {"lighting", "surface radiance times exposure, without medium and tone map"},
          {"shadow_map", "the first shadowed light's map (first face), black nearest the light"},
          {"scatter", "in-scattered radiance times exposure, without tone map"},
          {"transmittance", "transmittance from the eye to the surface, 0 black to 1 white"}};
}

bool isEngineDebugView(const std::string& name) {
  const std::vector<DebugViewInfo> views = Renderer::debugViews();
  return std::any_of(views.begin(), views.end(), [&](const DebugViewInfo& view) { return view.name == name; });
}

Result<Effect::DebugImage> engineDebugImage(Graph& graph, const PassTools& tools, const FrameData& frame,
                                            const std::string& name, ImageRef scatter, float exposure) {
  const float white = 1 / std::max(exposure, 1e-6f);
  if (name == "depth") {
    Result<ImageRef> distance = addDistancePass(graph, tools, frame.view, frame.depth);
    if (!distance) return distance.error();
    return Effect::DebugImage{*distance, {}, 0, 0, levelDepth(frame)};
  }
  if (name == "normal") return Effect::DebugImage{frame.normal, {}, kNormal, 0, 1};
  if (name == "base_color") return Effect::DebugImage{frame.base, {}, kRgb, 0, 1};
  if (name == "occlusion") return Effect::DebugImage{frame.base, {}, 3, 0, 1};
  if (name == "metallic") return Effect::DebugImage{frame.normal, {}, 2, 0, 1};
  if (name == "roughness") return Effect::DebugImage{frame.normal, {}, 3, 0, 1};
  if (name == "emissive") return Effect::DebugImage{frame.emissive, {}, kRgb, 0, white};
  if (name == "lighting") return Effect::DebugImage{frame.color, {}, kRgb, 0, white};
  if (name == "shadow_map") {
    if (frame.shadowedLights.empty()) return Effect::DebugImage{{}, {}, 0, 1, 2};  // nothing shadows: all white
    return Effect::DebugImage{frame.shadowedLights.front().shadowMap, {}, 0, 0, 1};
  }
  if (name == "scatter") return Effect::DebugImage{scatter, {}, kRgb, 0, white};
  TY_ASSERT(name == "transmittance", "unknown debug view '" + name + "'");
  if (!scatter) return Effect::DebugImage{{}, {}, 3, 1, 2};  // no medium: all light passes
  return Effect::DebugImage{scatter, {}, 3, 0, 1};
}

}  // namespace tyndall::render
