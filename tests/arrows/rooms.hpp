// Which part of the project a file belongs to, and which parts it may see (docs/architecture.md).
#pragma once

#include <set>
#include <string>
#include <vector>

namespace tyndall::arrows {

/// "gpu" for engine/gpu/..., "plugin:volumetrics" for plugins/volumetrics/..., "abi", "shared", "lib", "shaders" (the
/// engine's own), "editor", "levels" (samples/levels), "sample" (sample plugins), "tests" (also for any *_test.cpp); ""
/// for anything else. `path` is relative to the project's root, with '/'.
std::string roomOf(const std::string& path);

/// The rooms that `room` may include, itself among them (arrows are followed all the way down).
std::set<std::string> visibleFrom(const std::string& room);

/// Names of the engine's rooms: the first folder of an include such as "gpu/device.hpp".
const std::vector<std::string>& engineRooms();

}  // namespace tyndall::arrows
