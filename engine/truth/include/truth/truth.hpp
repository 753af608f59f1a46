// The ray-traced reference: single scattering by Embree, in double precision, sharing no code with the renderer, the
// plugin or shaders/. Slow and plain on purpose: it judges the rest.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "base/result.hpp"
#include "scene/scene.hpp"

namespace tyndall::truth {

/// Homogeneous medium. sigma_t 1/m, >= 0; albedo in [0, 1]; g in (-1, 1), forward positive.
struct Medium {
  double sigma_t = 0.03;
  double albedo = 0.9;
  double g = 0.5;
};

struct Settings {
  std::uint32_t width = 320;
  std::uint32_t height = 180;
  double seconds = 0;  ///< time of the animations
  Medium medium;
  /// Shadow rays per view ray and light, at the midpoints of strata of the part of the ray that can be lit and
  /// shadowed: of equal transmittance for a directional light, of equal angle as seen from a spot or point light.
  std::uint32_t samples = 1024;
  unsigned threads = 0;  ///< 0: all cores
  /// Called now and then, from the calling thread, with the share done in [0, 1]; return false to cancel.
  std::function<bool(double)> progress;
};

struct Picture {
  std::uint32_t width = 0, height = 0;
  std::vector<glm::vec4> scatter;  ///< R,G,B in-scattered radiance, A transmittance to the surface; row 0 on top
  /// Along the ray, metres, to the first opaque surface beyond the near plane, else the far plane; row 0 on top.
  std::vector<float> distance;
};

/// Renders the in-scattered radiance seen from `camera`. Opaque and MASK surfaces (alpha of the full-resolution
/// base-colour texture, bilinear unless its sampler magnifies with kNearest, against the cutoff) end rays and cast
/// shadows; BLEND surfaces do neither. Back faces of single-sided materials: not seen by view rays, but they cast
/// shadows. Directional, spot and point lights, with their cookies from the full-resolution image.
Result<Picture> render(const scene::Scene& scene, const scene::CameraView& camera,
                       const std::vector<scene::LightView>& lights, const Settings& settings);

}  // namespace tyndall::truth
