#include <cstddef>

#include "base/assert.hpp"
#include "pipeline_state.hpp"
#include "vk_text.hpp"

namespace tyndall::gpu {

Pipeline::State::~State() {
  vkDestroyPipeline(device.device, pipeline, nullptr);
  vkDestroyPipelineLayout(device.device, layout, nullptr);
  vkDestroyDescriptorSetLayout(device.device, setLayout, nullptr);
}

Pipeline::Pipeline() noexcept = default;
Pipeline::Pipeline(Pipeline&&) noexcept = default;
Pipeline& Pipeline::operator=(Pipeline&& other) noexcept {
  if (this == &other) return *this;
  letGo(state_);
  state_ = std::move(other.state_);
  return *this;
}
Pipeline::~Pipeline() { letGo(state_); }

VkPipeline Pipeline::handle() const { return state_->pipeline; }
VkPipelineLayout Pipeline::layout() const { return state_->layout; }
VkPipelineBindPoint Pipeline::bindPoint() const { return state_->bindPoint; }

Result<std::unique_ptr<Pipeline::State>> makeLayouts(Device::State& device, const std::string& name,
                                                     const std::vector<Binding>& bindings,
                                                     std::uint32_t pushConstantBytes, VkShaderStageFlags stages) {
  const std::string subject = "pipeline '" + name + "'";
  if (bindings.size() > device.info.maxPushDescriptors)
    return failed(subject + ": " + std::to_string(bindings.size()) + " bindings; this device takes at most " +
                  std::to_string(device.info.maxPushDescriptors));
  if (pushConstantBytes > device.info.limits.maxPushConstantsSize || pushConstantBytes % 4 != 0)
    return failed(subject + ": " + std::to_string(pushConstantBytes) +
                  " bytes of push constants; this device takes at most " +
                  std::to_string(device.info.limits.maxPushConstantsSize) + ", a multiple of 4");
  auto state = std::make_unique<Pipeline::State>(device, name);
  std::vector<VkDescriptorSetLayoutBinding> slots;
  for (const Binding& binding : bindings) slots.push_back({binding.binding, binding.type, 1, stages, nullptr});
  VkDescriptorSetLayoutCreateInfo set{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  set.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
  set.bindingCount = static_cast<std::uint32_t>(slots.size()), set.pBindings = slots.data();
  if (const VkResult result = vkCreateDescriptorSetLayout(device.device, &set, nullptr, &state->setLayout))
    return vkFailed(subject, result);
  const VkPushConstantRange range{VK_SHADER_STAGE_ALL, 0, pushConstantBytes};
  VkPipelineLayoutCreateInfo layout{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  layout.setLayoutCount = 1, layout.pSetLayouts = &state->setLayout;
  layout.pushConstantRangeCount = pushConstantBytes > 0 ? 1 : 0, layout.pPushConstantRanges = &range;
  if (const VkResult result = vkCreatePipelineLayout(device.device, &layout, nullptr, &state->layout))
    return vkFailed(subject, result);
  device.name(VK_OBJECT_TYPE_PIPELINE_LAYOUT, state->layout, name);
  return state;
}

Stages::Stages(Device::State& device, const std::vector<Specialization>& specialization)
    : device_(device), values_(specialization) {
  for (std::size_t i = 0; i < values_.size(); ++i)
    entries_.push_back({values_[i].id,
                        static_cast<std::uint32_t>(i * sizeof(Specialization) + offsetof(Specialization, value)),
                        sizeof(std::uint32_t)});
  specialization_.mapEntryCount = static_cast<std::uint32_t>(entries_.size());
  specialization_.pMapEntries = entries_.data();
  specialization_.dataSize = values_.size() * sizeof(Specialization);
  specialization_.pData = values_.data();
}

Stages::~Stages() {
  for (const auto& info : infos_) vkDestroyShaderModule(device_.device, info.module, nullptr);
}

Result<void> Stages::add(VkShaderStageFlagBits stage, const Shader& shader) {
  VkShaderModuleCreateInfo create{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  create.codeSize = shader.code.size() * sizeof(std::uint32_t), create.pCode = shader.code.data();
  VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  if (const VkResult result = vkCreateShaderModule(device_.device, &create, nullptr, &info.module))
    return vkFailed("shader '" + shader.name + "'", result);
  device_.name(VK_OBJECT_TYPE_SHADER_MODULE, info.module, shader.name);
  info.stage = stage;
  info.pName = "main";
  info.pSpecializationInfo = values_.empty() ? nullptr : &specialization_;
  infos_.push_back(info);
  return {};
}

Result<Pipeline> createPipeline(Device& device, const ComputePipelineDesc& desc) {
  TY_ASSERT(desc.shader, "pipeline '" + desc.name + "' has no shader");
  auto state =
      makeLayouts(device.state(), desc.name, desc.bindings, desc.pushConstantBytes, VK_SHADER_STAGE_COMPUTE_BIT);
  if (!state) return state.error();
  Stages stages(device.state(), desc.specialization);
  if (auto added = stages.add(VK_SHADER_STAGE_COMPUTE_BIT, *desc.shader); !added) return added.error();
  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage = stages.infos().front();
  info.layout = (*state)->layout;
  if (const VkResult result =
          vkCreateComputePipelines(device.handle(), device.pipelineCache(), 1, &info, nullptr, &(*state)->pipeline)) {
    (*state)->pipeline = VK_NULL_HANDLE;
    return vkFailed("pipeline '" + desc.name + "'", result);
  }
  device.state().name(VK_OBJECT_TYPE_PIPELINE, (*state)->pipeline, desc.name);
  Pipeline pipeline;
  pipeline.state_ = state.take();
  return pipeline;
}

}  // namespace tyndall::gpu
