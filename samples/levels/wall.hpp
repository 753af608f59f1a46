// A thick wall with one opening, closed on all sides that can be seen. Built in its own frame: s along the wall,
// y up, and z towards the room (the inner face lies at z = 0, the outer at z = -thickness).
#pragma once

#include "mesh_builder.hpp"

namespace tyndall::levels {

/// The hole at one face as columns: at x = s it reaches from y = low to z = high. Inner and outer faces may differ
/// (a splayed reveal) but have the same number of columns.
using Outline = std::vector<glm::vec3>;

/// A pointed (equilateral) arch above jambs: both arcs have the opening's width as radius (so its rise is sqrt(3)
/// times half the width). `steps` per side.
Outline pointedArch(float halfWidth, float sill, float spring, int steps);
/// A half circle above jambs.
Outline roundArch(float halfWidth, float sill, float spring, int steps);
Outline circle(float radius, float centreY, int steps);

struct WallShape {
  float halfWidth = 1;  ///< s from -halfWidth to halfWidth
  float bottom = 0;
  float topMiddle = 1, topEnds = 1;  ///< the top falls evenly from s = 0 to both ends
  float thickness = 0.6f;
};

/// `inner` goes to the faces, `reveal` to the sides of the hole.
void wall(MeshBuilder& face, MeshBuilder& reveal, const WallShape& shape, const Outline& inner, const Outline& outer);
/// The same without an opening.
void wall(MeshBuilder& face, const WallShape& shape);

}  // namespace tyndall::levels
