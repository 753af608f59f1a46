// Pipelines with push descriptors (set 0) and push constants, and the small class that fills the descriptors.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <volk.h>

#include "base/result.hpp"
#include "gpu/device.hpp"
#include "gpu/shader.hpp"

namespace tyndall::gpu {

struct Binding {
  std::uint32_t binding = 0;
  VkDescriptorType type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
};

struct Specialization {
  std::uint32_t id = 0;
  std::uint32_t value = 0;
};

struct ComputePipelineDesc {
  std::string name;
  std::shared_ptr<const Shader> shader;
  std::vector<Binding> bindings;
  std::uint32_t pushConstantBytes = 0;
  std::vector<Specialization> specialization;
};

struct ColorTarget {
  VkFormat format = VK_FORMAT_UNDEFINED;
  bool blend = false;
  VkBlendFactor sourceFactor = VK_BLEND_FACTOR_ONE, destinationFactor = VK_BLEND_FACTOR_ZERO;
  VkBlendFactor sourceAlphaFactor = VK_BLEND_FACTOR_ONE, destinationAlphaFactor = VK_BLEND_FACTOR_ZERO;
  VkBlendOp op = VK_BLEND_OP_ADD;
};

struct GraphicsPipelineDesc {
  std::string name;
  std::shared_ptr<const Shader> vertex, geometry, fragment;  ///< geometry and fragment may be null
  std::vector<Binding> bindings;
  std::uint32_t pushConstantBytes = 0;
  std::vector<Specialization> specialization;  ///< for every stage
  std::vector<VkVertexInputBindingDescription> vertexBindings;
  std::vector<VkVertexInputAttributeDescription> vertexAttributes;
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkCullModeFlags cull = VK_CULL_MODE_NONE;
  VkFrontFace frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  bool depthClamp = false;
  std::vector<ColorTarget> colors;
  VkFormat depthFormat = VK_FORMAT_UNDEFINED;  ///< undefined: no depth
  bool depthTest = false, depthWrite = false;
  VkCompareOp depthCompare = VK_COMPARE_OP_GREATER_OR_EQUAL;
};

/// A move-only pipeline with its layouts. Viewport and scissor are dynamic. Push constants are declared for all stages:
/// vkCmdPushConstants takes VK_SHADER_STAGE_ALL.
class Pipeline {
 public:
  Pipeline() noexcept;
  Pipeline(Pipeline&&) noexcept;
  Pipeline& operator=(Pipeline&&) noexcept;
  ~Pipeline();
  explicit operator bool() const { return state_ != nullptr; }
  VkPipeline handle() const;
  VkPipelineLayout layout() const;
  VkPipelineBindPoint bindPoint() const;
  struct State;

 private:
  friend Result<Pipeline> createPipeline(Device&, const ComputePipelineDesc&);
  friend Result<Pipeline> createPipeline(Device&, const GraphicsPipelineDesc&);
  std::unique_ptr<State> state_;
};

Result<Pipeline> createPipeline(Device& device, const ComputePipelineDesc& desc);
Result<Pipeline> createPipeline(Device& device, const GraphicsPipelineDesc& desc);

/// Collects descriptors for one draw or dispatch and pushes them:  Descriptors(cmd, pipeline).sampled(0, view,
/// sampler).push();
class Descriptors {
 public:
  Descriptors(VkCommandBuffer commands, const Pipeline& pipeline) : commands_(commands), pipeline_(pipeline) {}
  Descriptors& sampled(std::uint32_t binding, VkImageView view, VkSampler sampler,
                       VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  Descriptors& storageImage(std::uint32_t binding, VkImageView view);
  Descriptors& storageBuffer(std::uint32_t binding, VkBuffer buffer, VkDeviceSize offset = 0,
                             VkDeviceSize size = VK_WHOLE_SIZE);
  Descriptors& uniformBuffer(std::uint32_t binding, VkBuffer buffer, VkDeviceSize offset, VkDeviceSize size);
  void push();

 private:
  VkWriteDescriptorSet& add(std::uint32_t binding, VkDescriptorType type);
  VkCommandBuffer commands_;
  const Pipeline& pipeline_;
  static constexpr std::uint32_t kMax = 32;
  std::array<VkWriteDescriptorSet, kMax> writes_{};
  std::array<VkDescriptorImageInfo, kMax> images_{};
  std::array<VkDescriptorBufferInfo, kMax> buffers_{};
  std::uint32_t count_ = 0;
};

/// GPU timestamps of one frame's passes, as a chain: begin, then one mark after each pass. On lavapipe a timestamp of a
/// graphics pass is right only if a barrier FOLLOWS it, so mark() writes the timestamp and then a full barrier.
class Timestamps {
 public:
  static Result<Timestamps> create(Device& device, std::uint32_t capacity);
  Timestamps() noexcept;
  Timestamps(Timestamps&&) noexcept;
  Timestamps& operator=(Timestamps&&) noexcept;
  ~Timestamps();
  void begin(VkCommandBuffer commands);
  void mark(VkCommandBuffer commands);
  /// Milliseconds of each span since begin (one per mark); call when the GPU has finished the frame. Their sum is the
  /// frame's time.
  std::vector<double> milliseconds() const;
  std::uint32_t capacity() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tyndall::gpu
