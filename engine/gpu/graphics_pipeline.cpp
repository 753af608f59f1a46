#include "base/assert.hpp"
#include "pipeline_state.hpp"
#include "vk_text.hpp"

namespace tyndall::gpu {

Result<Pipeline> createPipeline(Device& device, const GraphicsPipelineDesc& desc) {
  const std::string subject = "pipeline '" + desc.name + "'";
  TY_ASSERT(desc.vertex, subject + " has no vertex shader");
  if (desc.geometry && !device.state().geometryShader) return failed(subject + ": this device has no geometry shaders");
  VkShaderStageFlags flags = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
  if (desc.geometry) flags |= VK_SHADER_STAGE_GEOMETRY_BIT;
  auto state = makeLayouts(device.state(), desc.name, desc.bindings, desc.pushConstantBytes, flags);
  if (!state) return state.error();
  (*state)->bindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;

  Stages stages(device.state(), desc.specialization);
  const std::pair<VkShaderStageFlagBits, const Shader*> shaders[] = {
      {VK_SHADER_STAGE_VERTEX_BIT, desc.vertex.get()},
      {VK_SHADER_STAGE_GEOMETRY_BIT, desc.geometry.get()},
      {VK_SHADER_STAGE_FRAGMENT_BIT, desc.fragment.get()}};
  for (const auto& [stage, shader] : shaders) {
    if (!shader) continue;
    if (auto added = stages.add(stage, *shader); !added) return added.error();
  }

  VkPipelineVertexInputStateCreateInfo vertices{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  vertices.vertexBindingDescriptionCount = static_cast<std::uint32_t>(desc.vertexBindings.size());
  vertices.pVertexBindingDescriptions = desc.vertexBindings.data();
  vertices.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(desc.vertexAttributes.size());
  vertices.pVertexAttributeDescriptions = desc.vertexAttributes.data();
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = desc.topology;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.depthClampEnable = desc.depthClamp;
  raster.cullMode = desc.cull;
  raster.frontFace = desc.frontFace;
  raster.lineWidth = 1;
  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  // Vulkan writes depth only where it tests it.
  TY_ASSERT(desc.depthTest || !desc.depthWrite, subject + " writes depth without testing it");
  TY_ASSERT(desc.depthFormat != VK_FORMAT_UNDEFINED || !desc.depthTest, subject + " tests depth that it has not");
  depth.depthTestEnable = desc.depthTest;
  depth.depthWriteEnable = desc.depthWrite;
  depth.depthCompareOp = desc.depthCompare;

  std::vector<VkFormat> formats;
  std::vector<VkPipelineColorBlendAttachmentState> targets;
  for (const ColorTarget& color : desc.colors) {
    constexpr VkColorComponentFlags kAll =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    formats.push_back(color.format);
    targets.push_back({color.blend, color.sourceFactor, color.destinationFactor, color.op, color.sourceAlphaFactor,
                       color.destinationAlphaFactor, color.op, kAll});
  }
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = static_cast<std::uint32_t>(targets.size());
  blend.pAttachments = targets.data();
  const VkDynamicState changing[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = 2;
  dynamic.pDynamicStates = changing;

  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = static_cast<std::uint32_t>(formats.size());
  rendering.pColorAttachmentFormats = formats.data();
  rendering.depthAttachmentFormat = desc.depthFormat;
  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering};
  info.stageCount = static_cast<std::uint32_t>(stages.infos().size());
  info.pStages = stages.infos().data();
  info.pVertexInputState = &vertices;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = (*state)->layout;
  if (const VkResult result =
          vkCreateGraphicsPipelines(device.handle(), device.pipelineCache(), 1, &info, nullptr, &(*state)->pipeline)) {
    (*state)->pipeline = VK_NULL_HANDLE;
    return vkFailed(subject, result);
  }
  device.state().name(VK_OBJECT_TYPE_PIPELINE, (*state)->pipeline, desc.name);
  Pipeline pipeline;
  pipeline.state_ = state.take();
  return pipeline;
}

}  // namespace tyndall::gpu
