// An effect that computes nothing and reads the shadow maps and moment shadow maps of a frame back.
#pragma once

#include <cmath>
#include <cstring>

#include "stage.hpp"

namespace tyndall::render::test {

class MomentReader : public Effect {
 public:
  struct Light {
    ShadowedLight shadow;
    std::vector<std::vector<float>> depth;                      ///< [face][texel]
    std::vector<std::vector<std::vector<glm::dvec4>>> moments;  ///< [mip][face][texel], as stored
    gpu::ImageDesc desc;                                        ///< of the moments
  };

  explicit MomentReader(gpu::Device& device) : device_(device) {}

  Result<ImageRef> addPasses(const EffectInput& input) override {
    copies_.clear();
    lights_.clear();
    for (const ShadowedLight& light : input.lights) {
      lights_.push_back({light, {}, {}, input.graph.desc(light.moments)});
      add(input.graph, light.shadowMap, 0, VK_IMAGE_ASPECT_DEPTH_BIT);
      for (std::uint32_t mip = 0; mip < lights_.back().desc.mips; ++mip)
        add(input.graph, light.moments, mip, VK_IMAGE_ASPECT_COLOR_BIT);
    }
    return ImageRef{};
  }
  DebugImage debugImage(const std::string&) override { return {}; }

  /// After the frame.
  std::vector<Light> take() {
    auto copy = copies_.begin();
    for (Light& light : lights_) {
      const std::size_t texels = std::size_t{light.shadow.size} * light.shadow.size;
      for (std::uint32_t face = 0; face < light.shadow.faceCount; ++face) {
        light.depth.emplace_back(texels);
        std::memcpy(light.depth.back().data(), copy->mapped() + face * texels * 4, texels * 4);
      }
      ++copy;
      for (std::uint32_t mip = 0; mip < light.desc.mips; ++mip, ++copy)
        light.moments.push_back(decode(light, mip, *copy));
    }
    return std::move(lights_);
  }

 private:
  void add(Graph& graph, ImageRef image, std::uint32_t mip, VkImageAspectFlags aspect) {
    const gpu::ImageDesc desc = graph.desc(image);
    const std::uint32_t side = std::max(desc.width >> mip, 1u);
    copies_.push_back(
        device_
            .createBuffer({"moments read back", VkDeviceSize{side} * side * desc.layers * gpu::texelBytes(desc.format),
                           VK_BUFFER_USAGE_TRANSFER_DST_BIT, true})
            .take());
    // The buffer moves with the list, its handle does not change; passes that write no import must be kept.
    graph.pass("read maps")
        .use(image, Use::kTransferRead)
        .keep()
        .run([=, to = copies_.back().handle(), layers = desc.layers](PassContext& context) {
          VkBufferImageCopy region{};
          region.imageSubresource = {aspect, mip, 0, layers};
          region.imageExtent = {side, side, 1};
          vkCmdCopyImageToBuffer(context.commands(), context.image(image), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to, 1,
                                 &region);
        });
  }

  static std::vector<std::vector<glm::dvec4>> decode(const Light& light, std::uint32_t mip, const gpu::Buffer& from) {
    const std::uint32_t side = std::max(light.desc.width >> mip, 1u);
    const bool quantised = light.desc.format == VK_FORMAT_R16G16B16A16_UNORM;
    std::vector<std::vector<glm::dvec4>> faces(light.shadow.faceCount);
    const std::byte* at = from.mapped();
    for (auto& face : faces)
      for (std::uint32_t i = 0; i < side * side; ++i) {
        glm::vec4 wide;
        glm::u16vec4 narrow;
        std::memcpy(&narrow, at, sizeof narrow);
        if (!quantised) std::memcpy(&wide, at, sizeof wide);
        face.push_back(quantised ? glm::dvec4(narrow) / 65535.0 : glm::dvec4(wide));
        at += quantised ? sizeof narrow : sizeof wide;
      }
    return faces;
  }

  gpu::Device& device_;
  std::vector<gpu::Buffer> copies_;
  std::vector<Light> lights_;
};

}  // namespace tyndall::render::test
