#include "graph_use.hpp"

#include "base/assert.hpp"

namespace tyndall::render {
namespace {

constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags2 kGraphics =
    VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
constexpr VkPipelineStageFlags2 kColor = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
// Clears and loads of depth happen in the early tests, stores in the late ones.
constexpr VkPipelineStageFlags2 kDepth =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;

constexpr VkAccessFlags2 kSampledRead = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
constexpr VkAccessFlags2 kStorageRead = VK_ACCESS_2_SHADER_STORAGE_READ_BIT;
constexpr VkAccessFlags2 kStorageWrite = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
constexpr VkAccessFlags2 kColorRead = VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT;
constexpr VkAccessFlags2 kColorWritten = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
constexpr VkAccessFlags2 kDepthReadBit = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
constexpr VkAccessFlags2 kDepthWritten = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;

constexpr VkImageUsageFlags kSampledUsage = VK_IMAGE_USAGE_SAMPLED_BIT;
constexpr VkImageUsageFlags kStorageUsage = VK_IMAGE_USAGE_STORAGE_BIT;
constexpr VkImageUsageFlags kColorUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
constexpr VkImageUsageFlags kDepthUsage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
constexpr VkBufferUsageFlags kStorageBuffer = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

}  // namespace

UseInfo useInfo(Use use) {
  switch (use) {
    // A "sampled" buffer is a storage buffer that the shaders of those stages only read; image reads by texture, buffer
    // reads by storage access.
    case Use::kSampledCompute:
      return {.stages = kCompute,
              .access = kSampledRead | kStorageRead,
              .layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
              .imageUsage = kSampledUsage,
              .bufferUsage = kStorageBuffer,
              .reads = true};
    case Use::kSampledGraphics:
      return {.stages = kGraphics,
              .access = kSampledRead | kStorageRead,
              .layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
              .imageUsage = kSampledUsage,
              .bufferUsage = kStorageBuffer,
              .reads = true};
    case Use::kStorageReadCompute:
      return {.stages = kCompute,
              .access = kStorageRead,
              .layout = VK_IMAGE_LAYOUT_GENERAL,
              .imageUsage = kStorageUsage,
              .bufferUsage = kStorageBuffer,
              .reads = true};
    case Use::kStorageWriteCompute:
      return {.stages = kCompute,
              .access = kStorageWrite,
              .writeAccess = kStorageWrite,
              .layout = VK_IMAGE_LAYOUT_GENERAL,
              .imageUsage = kStorageUsage,
              .bufferUsage = kStorageBuffer};
    case Use::kStorageReadWriteCompute:
      return {.stages = kCompute,
              .access = kStorageRead | kStorageWrite,
              .writeAccess = kStorageWrite,
              .layout = VK_IMAGE_LAYOUT_GENERAL,
              .imageUsage = kStorageUsage,
              .bufferUsage = kStorageBuffer,
              .reads = true};
    // One layout for the whole image: its sampled parts are read in GENERAL too.
    case Use::kSampledStorageCompute:
      return {.stages = kCompute,
              .access = kSampledRead | kStorageRead | kStorageWrite,
              .writeAccess = kStorageWrite,
              .layout = VK_IMAGE_LAYOUT_GENERAL,
              .imageUsage = kSampledUsage | kStorageUsage,
              .reads = true};
    // Attachments that are cleared may still blend or test within their pass, hence the read access.
    case Use::kColorWrite:
      return {.stages = kColor,
              .access = kColorRead | kColorWritten,
              .writeAccess = kColorWritten,
              .layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
              .imageUsage = kColorUsage,
              .replaces = true};
    case Use::kColorReadWrite:
      return {.stages = kColor,
              .access = kColorRead | kColorWritten,
              .writeAccess = kColorWritten,
              .layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
              .imageUsage = kColorUsage,
              .reads = true};
    case Use::kDepthWrite:
      return {.stages = kDepth,
              .access = kDepthReadBit | kDepthWritten,
              .writeAccess = kDepthWritten,
              .layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
              .imageUsage = kDepthUsage,
              .replaces = true};
    case Use::kDepthReadWrite:
      return {.stages = kDepth,
              .access = kDepthReadBit | kDepthWritten,
              .writeAccess = kDepthWritten,
              .layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
              .imageUsage = kDepthUsage,
              .reads = true};
    case Use::kDepthRead:
      return {.stages = kDepth,
              .access = kDepthReadBit,
              .layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL,
              .imageUsage = kDepthUsage,
              .reads = true};
    case Use::kTransferRead:
      return {.stages = kTransfer,
              .access = VK_ACCESS_2_TRANSFER_READ_BIT,
              .layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
              .imageUsage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
              .bufferUsage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
              .reads = true};
    case Use::kTransferWrite:
      return {.stages = kTransfer,
              .access = VK_ACCESS_2_TRANSFER_WRITE_BIT,
              .writeAccess = VK_ACCESS_2_TRANSFER_WRITE_BIT,
              .layout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
              .imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT,
              .bufferUsage = VK_BUFFER_USAGE_TRANSFER_DST_BIT};
    case Use::kUniform:
      return {.stages = kGraphics | kCompute,
              .access = VK_ACCESS_2_UNIFORM_READ_BIT,
              .bufferUsage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
              .reads = true};
    case Use::kIndirect:
      return {.stages = VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT,
              .access = VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT,
              .bufferUsage = VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT,
              .reads = true};
    // Presentation waits on a semaphore, which makes everything visible: only the layout and the order count.
    case Use::kPresent:
      return {.stages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
              .access = 0,
              .layout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR,
              .reads = true};
  }
  TY_ASSERT(false, "unknown Use " + std::to_string(static_cast<int>(use)));
  return {};
}

const char* useName(Use use) {
  static constexpr const char* kNames[] = {"sampled (compute)",  "sampled (graphics)",
                                           "storage read",       "storage write",
                                           "storage read-write", "sampled and storage",
                                           "colour write",       "colour read-write",
                                           "depth write",        "depth read-write",
                                           "depth read",         "transfer read",
                                           "transfer write",     "uniform",
                                           "indirect",           "present"};
  return kNames[static_cast<std::size_t>(use)];
}

}  // namespace tyndall::render
