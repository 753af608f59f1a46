// Images of lights resampled into square layers, on the CPU and in linear light.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.hpp"

namespace tyndall::render {

/// Linear colours, row 0 on top.
struct Plane {
  std::uint32_t width = 0, height = 0;
  std::vector<glm::vec3> texels;
};

/// Decodes sRGB; alpha is left out.
Plane linearPlane(const scene::Image& image);

/// Averages over areas along an axis that shrinks, interpolates linearly (with that axis's wrap) along one that grows,
/// and copies one that stays.
Plane resized(const Plane& in, std::uint32_t width, std::uint32_t height, scene::Wrap wrapU, scene::Wrap wrapV);

/// The image and its mirror image beside (below) it.
Plane mirroredOnce(const Plane& in, glm::bvec2 axes);

/// Unit-free direction through a place on a cube's face, u and v in [-1, 1], v down: Vulkan 1.3, "Cube Map Face
/// Selection", turned round.
glm::vec3 cubeDirection(std::uint32_t face, float u, float v);

/// Six faces of `side` texels from an equirectangular image (docs/conventions.md, "Cookies") or from a strip of faces.
std::vector<Plane> facesFromEquirectangular(const Plane& in, std::uint32_t side);
std::vector<Plane> facesFromStrip(const Plane& in, std::uint32_t side);

}  // namespace tyndall::render
