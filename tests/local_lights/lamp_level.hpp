// Small levels with lamps for tests: a floor, a wall, slats before a lamp; one camera at (0, 2, 8) that looks down -z.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace tyndall::local_lights {

struct Lamp {
  scene::LightKind kind = scene::LightKind::kSpot;
  glm::vec3 position{0};
  glm::vec3 towards{0, 0, -1};  ///< direction in which a spot or sun shines
  float intensity = 400;        ///< cd; lux of a sun
  std::optional<float> range;
  float inner = 0.2f, outer = 0.4f;  ///< rad
  glm::vec3 color{1};
  bool cookie = false;  ///< four by four squares of strong colours; of a sun a tile of 4 m
};

/// A flat bar: from `a` to `b`, of the given width along `across`.
struct Bar {
  glm::vec3 a, b, across;
};

/// Slats 0.1 m wide and 0.25 m apart across the way of a lamp, `ahead` metres before it.
std::vector<Bar> slatsBefore(const Lamp& lamp, float ahead);
/// A cage of bars around a point: four upright slats a side of a cube of half size `half`.
std::vector<Bar> cage(const glm::vec3& around, float half);

/// Six beams 4 m above the floor, for a sun.
std::vector<Bar> roof();

/// Writes the level as a .glb file into the folder of temporary files; `shell` adds floor and wall. Returns its path.
std::string writeLevel(const std::string& name, const std::vector<Lamp>& lamps, const std::vector<Bar>& bars,
                       bool shell = true);

}  // namespace tyndall::local_lights
