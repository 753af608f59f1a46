// The camera's matrices. Computed in double, so that a far plane of kilometres costs no precision.
#include <cmath>

#include "base/assert.hpp"
#include "render/frame.hpp"

namespace tyndall::render {

View makeView(const scene::CameraView& camera, std::uint32_t width, std::uint32_t height, const scene::Bounds& level) {
  TY_ASSERT(width > 0 && height > 0, "a view of " + std::to_string(width) + "x" + std::to_string(height));
  View view;
  view.width = width;
  view.height = height;
  view.znear = camera.camera.znear;
  view.zfar = scene::farPlane(camera, level);
  TY_ASSERT(view.znear > 0 && view.zfar > view.znear,
            "planes at " + std::to_string(view.znear) + " and " + std::to_string(view.zfar) + " m");

  const double n = view.znear, f = view.zfar;
  const double tangentY = std::tan(0.5 * static_cast<double>(camera.camera.yfov));
  const double tangentX = tangentY * width / height;
  glm::dmat4 clipFromView(0);
  clipFromView[0][0] = 1 / tangentX;
  clipFromView[1][1] = -1 / tangentY;  // Vulkan's y points down
  clipFromView[2][2] = n / (f - n);    // reversed: depth 1 at n, 0 at f
  clipFromView[2][3] = -1;
  clipFromView[3][2] = n * f / (f - n);
  glm::dmat4 viewFromClip(0);
  viewFromClip[0][0] = tangentX;
  viewFromClip[1][1] = -tangentY;
  viewFromClip[3][2] = -1;
  viewFromClip[2][3] = (f - n) / (n * f);
  viewFromClip[3][3] = 1 / f;

  view.clipFromView = glm::mat4(clipFromView);
  view.viewFromClip = glm::mat4(viewFromClip);
  view.worldFromView = camera.worldFromView;
  view.viewFromWorld = glm::mat4(glm::inverse(glm::dmat4(camera.worldFromView)));
  view.eye = glm::vec3(camera.worldFromView[3]);
  return view;
}

}  // namespace tyndall::render
