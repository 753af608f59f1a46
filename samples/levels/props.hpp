// Things that several levels hold, and the mechanics of hanging ones. A thing stands on y = 0 about its node's origin.
#pragma once

#include "level_builder.hpp"

namespace tyndall::levels {

/// A material and the size of one repetition of its textures, metres.
struct Coat {
  std::int32_t material = scene::kNone;
  float tile = 1;
  scene::Primitive finish(const MeshBuilder& b) const { return b.finish(material, tile); }
};

std::int32_t crateMesh(LevelBuilder& level, const Coat& boarding, const Coat& edges);  ///< 0.9 m a side
std::int32_t barrelMesh(LevelBuilder& level, const Coat& wood, const Coat& hoops);     ///< 0.92 m high
/// A stone: the body cut from a ball by random planes, the edges slightly rounded by its cells. Half a metre or so in
/// every direction about the origin, before scaling.
std::int32_t rockMesh(LevelBuilder& level, const Coat& coat, std::uint64_t seed);

/// Points of a circle in the plane z = depth, counter-clockwise.
std::vector<glm::vec3> ringPath(float radius, const glm::vec2& centre, int sides, float depth = 0);
/// A chain hanging from the origin down to y = -length: oval links, each turned by a quarter against the last.
void chain(MeshBuilder& b, float length, float link = 0.10f, float wire = 0.009f);
/// A bar of round section that gives way by `bend` in its middle, as if someone had pulled at it.
void bentRod(MeshBuilder& b, const glm::vec3& from, const glm::vec3& to, float radius, const glm::vec3& bend,
             int sides = 8);
/// A ladder of `length` metres along +y, leaning is the frame's matter: rails at x = -0.24 and 0.24, a rung every 0.3
/// m.
void ladder(MeshBuilder& b, float length);

}  // namespace tyndall::levels
