// The step through tinygltf.
#pragma once

#include "document.hpp"
#include "import_log.hpp"
#include "prepare.hpp"

namespace tyndall::scene {

/// Parses what was prepared. Images are decoded here; a broken one is refused by name.
document::Document parseGltf(Prepared prepared, Warnings& warnings);

}  // namespace tyndall::scene
