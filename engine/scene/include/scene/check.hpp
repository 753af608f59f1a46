// The promise that every Scene handed out by an importer keeps, and every Scene handed to a writer has to keep.
#pragma once

#include "base/result.hpp"
#include "scene/scene.hpp"

namespace tyndall::scene {

/// Ok when every index is in range, every number finite and within its documented range, every triangle list whole,
/// every normal and tangent of unit length, parents before children, key times strictly increasing.
/// The error names the first offending element, such as "nodes[3].mesh is 7; there are 5 meshes".
/// Writers pass withBounds = false: no format stores Primitive::bounds.
Result<void> checkScene(const Scene& scene, bool withBounds = true);

}  // namespace tyndall::scene
