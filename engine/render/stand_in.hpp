// A level in small: what its pipelines and their code depend on, and nothing else.
#pragma once

#include "render/frame.hpp"

namespace tyndall::render {

struct StandIn {
  scene::Scene scene;
  std::vector<glm::mat4> worldFromNode;
};

/// One triangle before the camera for each kind of drawing: material, and whether its node mirrors it. Materials and
/// samplers are the level's; images have at most three texels a side, and powers of two where the level's have
/// (llvmpipe compiles for that); those of cookies, whose sides have a meaning, are whole.
StandIn standInFor(const Renderer::Input& frame);

/// 2 for a power of two above 1, 3 for other numbers above 1, 1 for 1.
std::uint32_t smallSide(std::uint32_t texels);

}  // namespace tyndall::render
