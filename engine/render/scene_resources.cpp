#include "scene_resources.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

#include "shared/surface.h"
#include "textures.hpp"

namespace tyndall::render {

namespace {

// The pipelines' vertex attributes point into scene::Vertex as it is.
static_assert(sizeof(scene::Vertex) == 64);

shared::UvTransform uvTransform(const scene::TextureUse& use) {
  const float c = std::cos(use.rotation), s = std::sin(use.rotation);
  return {{c * use.scale.x, s * use.scale.y, use.offset.x}, {-s * use.scale.x, c * use.scale.y, use.offset.y}};
}

std::uint32_t textureBits(const scene::Material& m) {
  return (m.baseColorTexture.used() ? shared::kBaseColorMap : 0u) |
         (m.metallicRoughnessTexture.used() ? shared::kMetallicRoughnessMap : 0u) |
         (m.normalTexture.used() ? shared::kNormalMap : 0u) | (m.occlusionTexture.used() ? shared::kOcclusionMap : 0u) |
         (m.emissiveTexture.used() ? shared::kEmissiveMap : 0u);
}

static_assert(sizeof(shared::MaterialBlock) <= kMaterialStride);

shared::MaterialBlock materialBlock(const scene::Material& m) {
  shared::MaterialBlock block{};
  block.baseColor = m.baseColor;
  block.emissive = m.emissive;
  block.metallic = m.metallic;
  block.roughness = m.roughness;
  block.normalScale = m.normalScale;
  block.occlusionStrength = m.occlusionStrength;
  block.alphaCutoff = m.alphaCutoff;
  block.flags = (m.doubleSided ? shared::kMaterialDoubleSided : 0u) | (m.unlit ? shared::kMaterialUnlit : 0u);
  block.baseColorUv = uvTransform(m.baseColorTexture);
  block.metallicRoughnessUv = uvTransform(m.metallicRoughnessTexture);
  block.normalUv = uvTransform(m.normalTexture);
  block.occlusionUv = uvTransform(m.occlusionTexture);
  block.emissiveUv = uvTransform(m.emissiveTexture);
  return block;
}

Result<MaterialBindings> bindMaterial(TextureUploader& textures, const scene::Material& m) {
  using Content = TextureUploader::Content;
  MaterialBindings b;
  b.alphaMode = m.alphaMode;
  b.doubleSided = m.doubleSided;
  b.castsShadow = m.castsShadow;
  b.textures = textureBits(m);
  const struct {
    const scene::TextureUse& use;
    Content content;
    TextureBinding& out;
  } all[] = {{m.baseColorTexture, Content::kColor, b.baseColor},
             {m.baseColorTexture, Content::kAlphaTest, b.alpha},
             {m.metallicRoughnessTexture, Content::kData, b.metallicRoughness},
             {m.normalTexture, Content::kData, b.normal},
             {m.occlusionTexture, Content::kData, b.occlusion},
             {m.emissiveTexture, Content::kColor, b.emissive}};
  for (const auto& one : all) {
    Result<TextureBinding> bound = one.content == Content::kAlphaTest && m.alphaMode != scene::AlphaMode::kMask
                                       ? textures.bind({}, one.content)
                                       : textures.bind(one.use, one.content);
    if (!bound) return bound.error();
    one.out = *bound;
  }
  return b;
}

template <class T>
Result<gpu::Buffer> uploadBuffer(gpu::Device& device, const std::string& name, VkBufferUsageFlags usage,
                                 const std::vector<T>& data) {
  // Vulkan has no empty buffers; a level may be empty.
  const VkDeviceSize bytes = std::max<VkDeviceSize>(data.size() * sizeof(T), 64);
  Result<gpu::Buffer> made = device.createBuffer({name, bytes, usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, false});
  if (!made || data.empty()) return made;
  const Result<void> copied = device.upload(*made, std::as_bytes(std::span(data)));
  if (!copied) return copied.error();
  return made;
}

Result<void> uploadGeometry(gpu::Device& device, const scene::Scene& scene, SceneResources& out) {
  std::size_t vertexCount = 0, indexCount = 0;
  for (const scene::Mesh& mesh : scene.meshes) {
    for (const scene::Primitive& p : mesh.primitives) {
      vertexCount += p.vertices.size();
      indexCount += p.indices.size();
    }
  }
  // Draw calls address vertices by a signed and indices by an unsigned 32-bit number.
  if (vertexCount > INT32_MAX || indexCount > UINT32_MAX) {
    return failed("level: " + std::to_string(vertexCount) + " vertices and " + std::to_string(indexCount) +
                  " indices; at most 2147483647 vertices and 4294967295 indices can be drawn");
  }
  std::vector<scene::Vertex> vertices;
  std::vector<std::uint32_t> indices;
  vertices.reserve(vertexCount);
  indices.reserve(indexCount);
  const auto defaultMaterial = static_cast<std::uint32_t>(scene.materials.size());
  for (const scene::Mesh& mesh : scene.meshes) {
    std::vector<DrawRange>& ranges = out.meshes.emplace_back();
    for (const scene::Primitive& p : mesh.primitives) {
      ranges.push_back({static_cast<std::uint32_t>(indices.size()), static_cast<std::uint32_t>(p.indices.size()),
                        static_cast<std::int32_t>(vertices.size()),
                        p.material == scene::kNone ? defaultMaterial : static_cast<std::uint32_t>(p.material),
                        p.bounds});
      vertices.insert(vertices.end(), p.vertices.begin(), p.vertices.end());
      indices.insert(indices.end(), p.indices.begin(), p.indices.end());
    }
  }
  Result<gpu::Buffer> made = uploadBuffer(device, "vertices", VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, vertices);
  if (!made) return made.error();
  out.vertices = made.take();
  made = uploadBuffer(device, "indices", VK_BUFFER_USAGE_INDEX_BUFFER_BIT, indices);
  if (!made) return made.error();
  out.indices = made.take();
  return {};
}

}  // namespace

std::vector<std::byte> materialBlocks(const scene::Scene& scene) {
  std::vector<std::byte> blocks((scene.materials.size() + 1) * kMaterialStride);
  const auto put = [&](std::size_t i, const scene::Material& material) {
    const shared::MaterialBlock block = materialBlock(material);
    std::memcpy(blocks.data() + i * kMaterialStride, &block, sizeof(block));
  };
  for (std::size_t i = 0; i < scene.materials.size(); ++i) put(i, scene.materials[i]);
  put(scene.materials.size(), scene::Material{});
  return blocks;
}

Result<std::shared_ptr<const SceneResources>> uploadScene(gpu::Device& device, const scene::Scene& scene) {
  auto resources = std::make_shared<SceneResources>();
  if (Result<void> done = uploadGeometry(device, scene, *resources); !done) return done.error();

  TextureUploader textures(device, scene);
  const auto add = [&](const scene::Material& material) -> Result<void> {
    Result<MaterialBindings> bound = bindMaterial(textures, material);
    if (!bound) return bound.error();
    resources->materials.push_back(*bound);
    return {};
  };
  for (const scene::Material& material : scene.materials) {
    if (Result<void> done = add(material); !done) return done.error();
  }
  if (Result<void> done = add(scene::Material{}); !done) return done.error();
  resources->images = textures.takeImages();
  Result<Cookies> cookies = uploadCookies(device, scene);
  if (!cookies) return cookies.error();
  resources->cookies = cookies.take();
  return std::shared_ptr<const SceneResources>(std::move(resources));
}

}  // namespace tyndall::render
