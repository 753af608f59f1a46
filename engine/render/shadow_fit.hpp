// Where shadow maps look: pure CPU geometry. Stored depth is clip z: 0 nearest the light, 1 beyond every caster.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <glm/glm.hpp>

#include "render/frame.hpp"
#include "scene/scene.hpp"

namespace tyndall::render {

using Corners = std::array<glm::vec3, 8>;

/// Corners of a box; of an empty one, eight times `fallback`.
Corners boxCorners(const scene::Bounds& box, const glm::vec3& fallback);

struct ShadowFit {
  std::array<glm::mat4, 6> clipFromWorld{};
  std::uint32_t faceCount = 1;
  /// False when no caster can shadow anything between the eye and the far plane: the map stays clear.
  bool useful = false;
  /// Metres per texel: of the map's larger side (directional), or at 1 m along a face's axis (spot, point).
  double texelSize = 0;
  /// Far over near distance of the map, less 1: what makes its depth linear. 0: orthographic, linear already.
  float depthCurve = 0;
  std::string note;  ///< what the map cannot cover, or ""
};

/// A sun's map: the part of the view's frustum, from the eye to the far plane, that casters can shadow. Seen along the
/// light, that is the intersection of two convex polygons - frustum and casters' box - and the map is the smallest
/// rectangle around it (turned as needed), two texels wider on each side. Whatever lies outside is out of view or lit.
ShadowFit fitDirectional(const View& view, const glm::vec3& direction, const scene::Bounds& casters,
                         std::uint32_t size);

/// A spot light's map: the outer cone, from the nearest caster to the range or the farthest caster.
ShadowFit fitSpot(const scene::LightView& light, const scene::Bounds& casters, std::uint32_t size);

/// A point light's six faces +X -X +Y -Y +Z -Z of 90 degrees each.
ShadowFit fitPoint(const scene::LightView& light, const scene::Bounds& casters, std::uint32_t size);

ShadowFit fitShadow(const View& view, const scene::LightView& light, const scene::Bounds& casters, std::uint32_t size);

}  // namespace tyndall::render
