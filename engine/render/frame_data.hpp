// What one frame's passes share while they record: camera, draws, lights, uploaded blocks. Passes hold it by
// shared_ptr, because they record after addFrame has returned.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "draw_list.hpp"
#include "gpu/device.hpp"
#include "gpu/pipeline.hpp"
#include "light_plan.hpp"
#include "recipes.hpp"
#include "render/frame.hpp"
#include "scene_resources.hpp"

namespace tyndall::render {

struct KeptShadowMap;
struct SkyFrame;

/// A part of the frame's block buffer.
struct BlockRange {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offset = 0, size = 0;
};

/// Host-written buffers in turn. At most two frames are in flight and a third may be declared meanwhile.
class BlockRing {
 public:
  explicit BlockRing(gpu::Device& device) : device_(device) {}
  /// Copies the parts, each at an offset that any binding takes, into the next buffer.
  Result<std::vector<BlockRange>> write(const std::vector<std::pair<const void*, std::size_t>>& parts);

 private:
  static constexpr std::size_t kSlots = 4;
  gpu::Device& device_;
  std::array<gpu::Buffer, kSlots> slots_;
  std::size_t next_ = 0;
};

struct FrameData {
  View view;
  glm::mat4 clipFromWorld{1};
  DrawList draws;
  LightPlan plan;
  std::vector<ImageRef> shadowMaps;                            ///< by plan.shadowed
  std::vector<std::shared_ptr<KeptShadowMap>> keptShadowMaps;  ///< those of them that outlive the frame
  std::vector<ImageRef> momentMaps;                            ///< the same; empty refs where momentFormat is undefined
  VkFormat momentFormat = VK_FORMAT_UNDEFINED;
  ShadowMaps surfaceMaps = ShadowMaps::kDepths;  ///< what surfaces read
  std::vector<ShadowedLight> shadowedLights;     ///< in file order, for effects
  std::shared_ptr<const SceneResources> resources;
  BlockRange viewBlock, lightBlocks, instanceBlocks, materialBlocks, skyBlock;
  std::shared_ptr<const SkyFrame> sky;  ///< the maps that say what surfaces see of the sky
  ImageRef skyMaps;                     ///< empty: nothing hides the sky
  std::uint64_t materialsHash = 0;      ///< of the contents of materialBlocks
  bool cookies = false;                 ///< some light has one
  ImageRef cookieArray, noCookie;       ///< resources->cookies and a white texel, for effects; empty without an effect

  ImageRef base, normal, emissive, depth, color;

  /// What surfaces read of plan.shadowed[index].
  ImageRef surfaceMap(std::uint32_t index) const {
    return surfaceMaps == ShadowMaps::kDepths ? shadowMaps[index] : momentMaps[index];
  }
};
using FramePointer = std::shared_ptr<const FrameData>;

/// The samplers of the frame's own images.
struct FrameSamplers {
  VkSampler texel = VK_NULL_HANDLE;      ///< nearest, clamped: targets read by texelFetch, cube faces
  VkSampler borderLit = VK_NULL_HANDLE;  ///< nearest, 1 outside: maps outside of which everything is lit
  VkSampler linear = VK_NULL_HANDLE;     ///< linear in one mip, clamped
  VkSampler trilinear = VK_NULL_HANDLE;  ///< trilinear, clamped: moment shadow maps
  VkSampler cookie = VK_NULL_HANDLE;     ///< trilinear, repeating
};
FrameSamplers makeSamplers(gpu::Device& device);

}  // namespace tyndall::render
