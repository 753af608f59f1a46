#include "vulkan_model.hpp"

#include <utility>

namespace tyndall::render::test {

Stages stagesOf(VkPipelineStageFlags2 mask) {
  constexpr std::pair<VkPipelineStageFlags2, Stages> kTable[] = {
      {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, kAllCommands},
      {VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, bit(sIndirect)},
      {VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT, bit(sVertex)},
      {VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, bit(sFragment)},
      {VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT, bit(sEarly)},
      {VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT, bit(sLate)},
      {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, bit(sColor)},
      {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, bit(sCompute)},
      {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, bit(sTransfer)},
      {VK_PIPELINE_STAGE_2_HOST_BIT, bit(sHost)}};
  Stages result = 0;
  for (const auto& [flag, stages] : kTable)
    if (mask & flag) result |= stages;
  return result;
}

Accesses accessesOf(VkAccessFlags2 mask) {
  constexpr std::pair<VkAccessFlags2, Accesses> kTable[] = {
      {VK_ACCESS_2_MEMORY_READ_BIT, kReads},
      {VK_ACCESS_2_MEMORY_WRITE_BIT, kWrites},
      {VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, bit(aIndirect)},
      {VK_ACCESS_2_UNIFORM_READ_BIT, bit(aUniform)},
      {VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, bit(aSampled)},
      {VK_ACCESS_2_SHADER_STORAGE_READ_BIT, bit(aStorageRead)},
      {VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, bit(aStorageWrite)},
      {VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT, bit(aColorRead)},
      {VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, bit(aColorWrite)},
      {VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT, bit(aDepthRead)},
      {VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, bit(aDepthWrite)},
      {VK_ACCESS_2_TRANSFER_READ_BIT, bit(aTransferRead)},
      {VK_ACCESS_2_TRANSFER_WRITE_BIT, bit(aTransferWrite)},
      {VK_ACCESS_2_HOST_READ_BIT, bit(aHostRead)}};
  Accesses result = 0;
  for (const auto& [flag, accesses] : kTable)
    if (mask & flag) result |= accesses;
  return result;
}

Meaning meaningOf(Use use, bool isBuffer) {
  const Accesses shaderRead = isBuffer ? bit(aStorageRead) : bit(aSampled);
  const Stages depthTests = bit(sEarly) | bit(sLate);
  Meaning m;
  switch (use) {
    case Use::kSampledCompute:
      m = {bit(sCompute), shaderRead, 0, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, true};
      break;
    case Use::kSampledGraphics:
      m = {bit(sVertex) | bit(sFragment), shaderRead, 0, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, true};
      break;
    case Use::kStorageReadCompute: m = {bit(sCompute), bit(aStorageRead), 0, VK_IMAGE_LAYOUT_GENERAL, true}; break;
    case Use::kStorageWriteCompute: m = {bit(sCompute), 0, bit(aStorageWrite), VK_IMAGE_LAYOUT_GENERAL, false}; break;
    case Use::kStorageReadWriteCompute:
      m = {bit(sCompute), bit(aStorageRead), bit(aStorageWrite), VK_IMAGE_LAYOUT_GENERAL, true};
      break;
    case Use::kSampledStorageCompute:
      m = {bit(sCompute), bit(aSampled) | bit(aStorageRead), bit(aStorageWrite), VK_IMAGE_LAYOUT_GENERAL, true};
      break;
    case Use::kColorWrite:
    case Use::kColorReadWrite:
      m = {bit(sColor),
           bit(aColorRead),
           bit(aColorWrite),
           VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
           use == Use::kColorReadWrite,
           use == Use::kColorWrite};
      break;
    case Use::kDepthWrite:
    case Use::kDepthReadWrite:
      m = {depthTests,
           bit(aDepthRead),
           bit(aDepthWrite),
           VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
           use == Use::kDepthReadWrite,
           use == Use::kDepthWrite};
      break;
    case Use::kDepthRead:
      m = {depthTests, bit(aDepthRead), 0, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL, true};
      break;
    case Use::kTransferRead:
      m = {bit(sTransfer), bit(aTransferRead), 0, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, true};
      break;
    case Use::kTransferWrite:
      m = {bit(sTransfer), 0, bit(aTransferWrite), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, false};
      break;
    case Use::kUniform:
      m = {bit(sVertex) | bit(sFragment) | bit(sCompute), bit(aUniform), 0, VK_IMAGE_LAYOUT_UNDEFINED, true};
      break;
    case Use::kIndirect: m = {bit(sIndirect), bit(aIndirect), 0, VK_IMAGE_LAYOUT_UNDEFINED, true}; break;
    case Use::kPresent: m = {kAllCommands, 0, 0, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, true}; break;
  }
  return m;
}

}  // namespace tyndall::render::test
