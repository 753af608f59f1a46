// A level on the GPU: one vertex buffer, one index buffer, textures, and what binds a material's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.hpp"
#include "cookies.hpp"
#include "gpu/device.hpp"
#include "scene/scene.hpp"

namespace tyndall::render {

struct TextureBinding {
  VkImageView view = VK_NULL_HANDLE;
  VkSampler sampler = VK_NULL_HANDLE;
};

struct MaterialBindings {
  /// `alpha` is the base-colour image again, for the alpha test: mip 0 only, bilinear (see material.glsl).
  TextureBinding baseColor, alpha, metallicRoughness, normal, occlusion, emissive;
  scene::AlphaMode alphaMode = scene::AlphaMode::kOpaque;
  bool doubleSided = false;
  bool castsShadow = true;
  std::uint32_t textures = 0;  ///< shared::k...Map bits of the maps it has
};

/// Where a primitive lies in the shared buffers.
struct DrawRange {
  std::uint32_t firstIndex = 0, indexCount = 0;
  std::int32_t vertexOffset = 0;
  std::uint32_t material = 0;  ///< index into SceneResources::materials
  scene::Bounds bounds;        ///< mesh space
};

/// A whole multiple of every offset alignment that Vulkan 1.3 lets a device ask of a uniform buffer.
inline constexpr VkDeviceSize kMaterialStride = 256;

struct SceneResources {
  gpu::Buffer vertices, indices;
  std::vector<gpu::Image> images;
  Cookies cookies;
  std::vector<std::vector<DrawRange>> meshes;  ///< by mesh, then by primitive
  std::vector<MaterialBindings> materials;     ///< one more than the scene's: the last is glTF's default material
};

/// One shared::MaterialBlock every kMaterialStride bytes, in the order of SceneResources::materials. They are a
/// frame's, not the level's: the numbers of materials may change from one frame to the next.
std::vector<std::byte> materialBlocks(const scene::Scene& scene);

/// Errors: lack of memory, an image larger than the device takes.
Result<std::shared_ptr<const SceneResources>> uploadScene(gpu::Device& device, const scene::Scene& scene);

}  // namespace tyndall::render
