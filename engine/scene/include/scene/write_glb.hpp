// Writes a Scene as an ordinary binary glTF 2.0 file that any viewer opens. Used by the sample levels' generators.
#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "scene/scene.hpp"

namespace tyndall::scene {

/// Geometry, materials, images (embedded PNG), nodes, cameras, lights, animations. Written all or nothing.
Result<void> writeGlb(const Scene& scene, const std::filesystem::path& path);

}  // namespace tyndall::scene
