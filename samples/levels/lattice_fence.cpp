// Chain-link fences: cut-out panels, and panels of real wire before the lamp.
#include <glm/gtc/constants.hpp>

#include "lattice_parts.hpp"
#include "lattice_textures.hpp"
#include "shapes.hpp"

namespace tyndall::levels::lattice {
namespace {

/// A panel's mesh in its own frame: s from 0 to `length`, y from 0.05 to `top`, in the plane z = 0.
void addCutout(MeshBuilder& chain, float length, float top) {
  const float tile = kMesh * kDiamonds;
  card(chain, {0.5f * length, 0.05f, 0}, {length, 0, 0}, {0, top - 0.05f, 0}, {0, 0, 1}, {0, 0},
       {length / tile, (top - 0.05f) / tile});
}

/// The same of wire: each wire climbs in a zigzag, against its neighbours', so that they hook into one another.
void addWires(MeshBuilder& wire, float length, float top) {
  constexpr float kRadius = 0.008f, kStep = 0.5f * kMesh;
  const int wires = static_cast<int>(length / kStep), steps = static_cast<int>((top - 0.05f) / kStep);
  for (int w = 0; w < wires; ++w) {
    std::vector<glm::vec3> path;
    for (int k = 0; k <= steps; ++k) {
      const float side = (k + w) % 2 == 0 ? -1.0f : 1.0f;
      path.emplace_back(kStep * (real(w) + 0.5f + 0.5f * side), 0.05f + kStep * real(k), 0.004f * side);
    }
    tube(wire, path, std::vector<float>(path.size(), kRadius), 3);
  }
}

void addPosts(MeshBuilder& pipe, float length, float top) {
  for (const float s : {0.0f, length}) tube(pipe, {{s, 0, 0}, {s, top + 0.05f, 0}}, {0.035f, 0.035f}, 10, true);
  for (const float y : {0.08f, top}) tube(pipe, {{0, y, 0}, {length, y, 0}}, {0.025f, 0.025f}, 8);
}

}  // namespace

void addFences(LevelBuilder& level, const Materials& m) {
  MeshBuilder chain, wire, pipe;
  const auto panel = [&](const glm::vec3& at, float yaw, float length, float top, bool real3d) {
    chain.frame = wire.frame = pipe.frame = placed(at, yaw);
    addPosts(pipe, length, top);
    if (real3d) {
      addWires(wire, length, top);
    } else {
      addCutout(chain, length, top);
    }
  };
  const float quarter = glm::half_pi<float>();
  for (int i = 0; i < 5; ++i)  // along z; the panels before the lamp are wire
    panel({kCageX, 0, kCageZ - 3.0f * real(i)}, quarter, 3.0f, kCageTop, i == 1 || i == 2);
  for (const float x : {kCageX + 2.0f, kCageX + 4.4f}) panel({x, 0, kCageZ}, 0, 2.4f, kCageTop, false);
  panel({kCageX + 2.0f, 0, kCageZ}, -0.9f, 1.9f, 2.3f, false);  // the gate, open
  for (const int bay : {1, 2, 4})
    panel({kBay * (real(bay) - 2.5f), 0, -kHalfLength - 0.05f}, 0, kBay, kFenceTop, false);
  level.single("fence", {m.chain.finish(chain), wire.finish(m.galvanised), pipe.finish(m.galvanised)});
}

}  // namespace tyndall::levels::lattice
