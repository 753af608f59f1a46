// Uploads and readback through staging buffers, in pieces when the data is larger than the staging buffer.
#include <algorithm>
#include <bit>
#include <cstring>

#include "base/assert.hpp"
#include "state.hpp"

namespace tyndall::gpu {
namespace {

// Large enough that a piece's copy outweighs its submission, small enough to keep around.
constexpr VkDeviceSize kStagingBytes = 16ull << 20;

/// A staging buffer of at least `atLeast` bytes, kept between calls.
Result<Buffer*> staging(Device& device, Buffer& kept, bool upload, VkDeviceSize atLeast) {
  if (!kept || kept.size() < atLeast) {
    kept = {};
    BufferDesc desc;
    desc.name = upload ? "upload staging" : "readback staging";
    desc.size = std::bit_ceil(std::max<VkDeviceSize>(atLeast, 1u << 16));
    desc.usage = upload ? VK_BUFFER_USAGE_TRANSFER_SRC_BIT : VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    desc.hostVisible = true;
    auto made = device.createBuffer(desc);
    if (!made) return made.error();
    kept = made.take();
  }
  return &kept;
}

struct Subresource {
  std::uint32_t mip = 0, layer = 0;
  VkImageAspectFlags aspect = 0;
  VkExtent3D extent{};
  std::uint32_t texel = 0;
  VkDeviceSize rowBytes() const { return static_cast<VkDeviceSize>(extent.width) * texel; }
  VkDeviceSize bytes() const { return rowBytes() * extent.height * extent.depth; }
};

Subresource subresource(const Image& image, std::uint32_t mip, std::uint32_t layer) {
  const ImageDesc& d = image.desc();
  TY_ASSERT(mip < d.mips && layer < d.layers,
            "image '" + d.name + "' has no mip " + std::to_string(mip) + " of layer " + std::to_string(layer));
  Subresource part{mip,
                   layer,
                   image.aspect(),
                   {std::max(1u, d.width >> mip), std::max(1u, d.height >> mip), std::max(1u, d.depth >> mip)},
                   texelBytes(d.format)};
  TY_ASSERT(part.texel > 0, "image '" + d.name + "': no copies of format " + std::to_string(d.format));
  return part;
}

void barrier(VkCommandBuffer commands, VkImage image, const Subresource& part, VkImageLayout from, VkImageLayout to) {
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.oldLayout = from, barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = {part.aspect, part.mip, 1, part.layer, 1};
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.imageMemoryBarrierCount = 1, dependency.pImageMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &dependency);
}

/// Rows [y, y+rows) of slices [z, z+slices) that fit the staging buffer: whole slices, or rows of one slice.
struct Piece {
  VkBufferImageCopy copy{};
  VkDeviceSize offset = 0, bytes = 0;  ///< in the packed texels
};

std::vector<Piece> pieces(const Subresource& part, VkDeviceSize room) {
  const VkDeviceSize row = part.rowBytes(), slice = row * part.extent.height;
  const auto rowsAtOnce = static_cast<std::uint32_t>(std::clamp<VkDeviceSize>(room / row, 1, part.extent.height));
  const auto slicesAtOnce = static_cast<std::uint32_t>(std::clamp<VkDeviceSize>(room / slice, 1, part.extent.depth));
  std::vector<Piece> list;
  for (std::uint32_t z = 0; z < part.extent.depth; z += slicesAtOnce)
    for (std::uint32_t y = 0; y < part.extent.height; y += rowsAtOnce) {
      const std::uint32_t rows = std::min(rowsAtOnce, part.extent.height - y);
      const std::uint32_t slices = std::min(slicesAtOnce, part.extent.depth - z);
      Piece piece;
      piece.copy.imageSubresource = {part.aspect, part.mip, part.layer, 1};
      piece.copy.imageOffset = {0, static_cast<std::int32_t>(y), static_cast<std::int32_t>(z)};
      piece.copy.imageExtent = {part.extent.width, rows, slices};
      piece.offset = z * slice + y * row;
      piece.bytes = row * rows * slices;
      list.push_back(piece);
    }
  return list;
}

}  // namespace

Result<void> Device::upload(Image& image, std::span<const std::byte> texels, std::uint32_t mip, std::uint32_t layer) {
  const ImageDesc& desc = image.desc();
  const Subresource part = subresource(image, mip, layer);
  TY_ASSERT(texels.size() == part.bytes(), "image '" + desc.name + "': " + std::to_string(texels.size()) +
                                               " bytes given for " + std::to_string(part.bytes()));
  TY_ASSERT(desc.usage & VK_IMAGE_USAGE_TRANSFER_DST_BIT, "image '" + desc.name + "' takes no copies");
  auto buffer =
      staging(*this, state_->uploadStaging, true, std::min(part.bytes(), std::max(kStagingBytes, part.rowBytes())));
  if (!buffer) return buffer.error();
  const VkImageLayout after =
      desc.usage & VK_IMAGE_USAGE_SAMPLED_BIT ? VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL : VK_IMAGE_LAYOUT_GENERAL;
  const auto list = pieces(part, (*buffer)->size());
  for (const Piece& piece : list) {
    std::memcpy((*buffer)->mapped(), texels.data() + piece.offset, piece.bytes);
    auto done = submitAndWait([&](VkCommandBuffer commands) {
      // From UNDEFINED: every texel is overwritten, whatever layout the image was in.
      if (&piece == &list.front())
        barrier(commands, image.handle(), part, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
      vkCmdCopyBufferToImage(commands, (*buffer)->handle(), image.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                             &piece.copy);
      if (&piece == &list.back()) barrier(commands, image.handle(), part, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, after);
    });
    if (!done) return done;
  }
  return {};
}

Result<std::vector<std::byte>> Device::readback(const Image& image, VkImageLayout layout, std::uint32_t mip,
                                                std::uint32_t layer) {
  const Subresource part = subresource(image, mip, layer);
  TY_ASSERT(image.desc().usage & VK_IMAGE_USAGE_TRANSFER_SRC_BIT, "image '" + image.desc().name + "' gives no copies");
  auto buffer =
      staging(*this, state_->readbackStaging, false, std::min(part.bytes(), std::max(kStagingBytes, part.rowBytes())));
  if (!buffer) return buffer.error();
  std::vector<std::byte> texels(part.bytes());
  const auto list = pieces(part, (*buffer)->size());
  for (const Piece& piece : list) {
    auto done = submitAndWait([&](VkCommandBuffer commands) {
      if (&piece == &list.front())
        barrier(commands, image.handle(), part, layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
      vkCmdCopyImageToBuffer(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, (*buffer)->handle(), 1,
                             &piece.copy);
      if (&piece == &list.back()) barrier(commands, image.handle(), part, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, layout);
      fullBarrier(commands);
    });
    if (!done) return done.error();
    std::memcpy(texels.data() + piece.offset, (*buffer)->mapped(), piece.bytes);
  }
  return texels;
}

Result<void> Device::upload(Buffer& buffer, std::span<const std::byte> bytes, VkDeviceSize offset) {
  const BufferDesc& desc = buffer.state_->desc;
  TY_ASSERT(
      offset <= desc.size && bytes.size() <= desc.size - offset,
      "buffer '" + desc.name + "': " + std::to_string(bytes.size()) + " bytes given at " + std::to_string(offset));
  if (bytes.empty()) return {};
  if (!(desc.usage & VK_BUFFER_USAGE_TRANSFER_DST_BIT)) {
    TY_ASSERT(buffer.mapped(), "buffer '" + desc.name + "' takes no copies");
    if (auto waited = state_->waitForFrame(state_->submitted); !waited) return waited;  // frames in flight may read it
    std::memcpy(buffer.mapped() + offset, bytes.data(), bytes.size());
    return {};
  }
  auto stage = staging(*this, state_->uploadStaging, true, std::min<VkDeviceSize>(bytes.size(), kStagingBytes));
  if (!stage) return stage.error();
  for (VkDeviceSize at = 0; at < bytes.size(); at += (*stage)->size()) {
    const VkBufferCopy copy{0, offset + at, std::min<VkDeviceSize>((*stage)->size(), bytes.size() - at)};
    std::memcpy((*stage)->mapped(), bytes.data() + at, copy.size);
    auto done = submitAndWait([&](VkCommandBuffer commands) {
      fullBarrier(commands);
      vkCmdCopyBuffer(commands, (*stage)->handle(), buffer.handle(), 1, &copy);
      fullBarrier(commands);
    });
    if (!done) return done;
  }
  return {};
}

Result<std::vector<std::byte>> Device::readback(const Buffer& buffer) {
  const BufferDesc& desc = buffer.state_->desc;
  std::vector<std::byte> bytes(desc.size);
  if (buffer.mapped()) {
    if (auto done = submitAndWait(fullBarrier); !done) return done.error();
    std::memcpy(bytes.data(), buffer.mapped(), bytes.size());
    return bytes;
  }
  TY_ASSERT(desc.usage & VK_BUFFER_USAGE_TRANSFER_SRC_BIT, "buffer '" + desc.name + "' gives no copies");
  auto stage = staging(*this, state_->readbackStaging, false, std::min(desc.size, kStagingBytes));
  if (!stage) return stage.error();
  for (VkDeviceSize at = 0; at < desc.size; at += (*stage)->size()) {
    const VkBufferCopy copy{at, 0, std::min((*stage)->size(), desc.size - at)};
    auto done = submitAndWait([&](VkCommandBuffer commands) {
      fullBarrier(commands);
      vkCmdCopyBuffer(commands, buffer.handle(), (*stage)->handle(), 1, &copy);
      fullBarrier(commands);
    });
    if (!done) return done.error();
    std::memcpy(bytes.data() + at, (*stage)->mapped(), copy.size);
  }
  return bytes;
}

void transition(VkCommandBuffer commands, const Image& image, VkImageLayout from, VkImageLayout to) {
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.oldLayout = from, barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image.handle();
  barrier.subresourceRange = {image.aspect(), 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.imageMemoryBarrierCount = 1, dependency.pImageMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace tyndall::gpu
