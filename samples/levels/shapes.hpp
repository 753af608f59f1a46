// Building blocks of the levels. Texture coordinates are metres; closed shapes face outwards.
#pragma once

#include <functional>

#include "mesh_builder.hpp"

namespace tyndall::levels {

enum class Mapping {
  kUpright,  ///< v falls with y: courses of stone stay level
  kGrain,    ///< u runs along the longest side: wood
};

/// A box whose edges are cut at 45 degrees by `chamfer` metres (0: a plain box): edges that catch light.
void chamferBox(MeshBuilder& b, const glm::vec3& min, const glm::vec3& max, float chamfer,
                Mapping mapping = Mapping::kGrain);

/// A chamfered beam of cross-section width (across) by height (towards `up`) between two points.
void beam(MeshBuilder& b, const glm::vec3& from, const glm::vec3& to, float width, float height, float chamfer = 0.02f,
          const glm::vec3& up = {0, 1, 0});

/// Turns a profile of (radius, y), from bottom to top, about the y axis. A point given twice makes a hard edge.
void lathe(MeshBuilder& b, const std::vector<glm::vec2>& profile, int sides);

/// A tube along a path with one radius per point; `cap` closes both ends.
void tube(MeshBuilder& b, const std::vector<glm::vec3>& path, const std::vector<float>& radii, int sides,
          bool cap = false);

/// A bar of rectangular section along a path in a plane: `width` in the plane, `depth` along the plane's normal.
/// `closed` joins the last point to the first.
void bar(MeshBuilder& b, const std::vector<glm::vec3>& path, const glm::vec3& planeNormal, float width, float depth,
         bool closed = false);

/// A smooth surface p(u, v), u and v in [0, 1]; the front is where dp/du x dp/dv points. `metres`: its size, for the
/// texture coordinates (v of the texture runs against v of the surface, so images stand upright).
void surface(MeshBuilder& b, int columns, int rows, const glm::vec2& metres,
             const std::function<glm::vec3(float u, float v)>& point);

/// A flat card for cut-out textures, image upright: `right` and `up` are its full edges, `base` the middle of its
/// lower edge. `normal` may differ from the geometric one (foliage is shaded like the crown it belongs to);
/// the card is turned so that its front is on the side of `normal`. `uvMin`, `uvMax`: part of the image, in tiles.
void card(MeshBuilder& b, const glm::vec3& base, const glm::vec3& right, const glm::vec3& up, const glm::vec3& normal,
          const glm::vec2& uvMin = {0, 0}, const glm::vec2& uvMax = {1, 1});

/// Rotation whose -Z looks along `forward` (cameras, lights) with +Y near `up`.
glm::quat lookRotation(const glm::vec3& forward, const glm::vec3& up = {0, 1, 0});
/// Translation then rotation about +Y (radians), then uniform scale.
glm::mat4 placed(const glm::vec3& at, float yaw = 0, float scale = 1);

}  // namespace tyndall::levels
