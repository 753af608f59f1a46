// What the two kinds of pipeline share.
#pragma once

#include "gpu/pipeline.hpp"
#include "state.hpp"

namespace tyndall::gpu {

struct Pipeline::State : Resource {
  using Resource::Resource;
  ~State() override;
  VkPipeline pipeline = VK_NULL_HANDLE;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
  VkPipelineBindPoint bindPoint = VK_PIPELINE_BIND_POINT_COMPUTE;
};

/// The state with its layouts: bindings for `stages`, push constants for all.
Result<std::unique_ptr<Pipeline::State>> makeLayouts(Device::State& device, const std::string& name,
                                                     const std::vector<Binding>& bindings,
                                                     std::uint32_t pushConstantBytes, VkShaderStageFlags stages);

/// Shader modules and specialization of one pipeline's creation; the modules go with it.
class Stages {
 public:
  Stages(Device::State& device, const std::vector<Specialization>& specialization);
  ~Stages();
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;
  Result<void> add(VkShaderStageFlagBits stage, const Shader& shader);
  const std::vector<VkPipelineShaderStageCreateInfo>& infos() const { return infos_; }

 private:
  Device::State& device_;
  std::vector<Specialization> values_;
  std::vector<VkSpecializationMapEntry> entries_;
  VkSpecializationInfo specialization_{};
  std::vector<VkPipelineShaderStageCreateInfo> infos_;
};

}  // namespace tyndall::gpu
