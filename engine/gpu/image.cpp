#include <algorithm>

#include "base/assert.hpp"
#include "state.hpp"
#include "vk_text.hpp"

namespace tyndall::gpu {
namespace {

VkImageCreateInfo createInfo(const ImageDesc& desc) {
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = desc.type;
  info.format = desc.format;
  info.extent = {desc.width, desc.height, desc.depth};
  info.mipLevels = desc.mips;
  info.arrayLayers = desc.layers;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = desc.usage;
  info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
  return info;
}

std::string sizeText(const ImageDesc& d) {
  std::string text = std::to_string(d.width) + "x" + std::to_string(d.height);
  if (d.type == VK_IMAGE_TYPE_3D) text += "x" + std::to_string(d.depth);
  if (d.layers > 1) text += ", " + std::to_string(d.layers) + " layers";
  if (d.mips > 1) text += ", " + std::to_string(d.mips) + " mips";
  return text;
}

/// Refuses what vkCreateImage must not be asked for.
Result<void> check(VkPhysicalDevice physical, const ImageDesc& d) {
  const std::string subject = "image '" + d.name + "' (" + sizeText(d) + "): ";
  if (d.width == 0 || d.height == 0 || d.depth == 0 || d.layers == 0 || d.mips == 0)
    return failed(subject + "a size of 0");
  VkImageFormatProperties limits{};
  const VkResult result = vkGetPhysicalDeviceImageFormatProperties(physical, d.format, d.type, VK_IMAGE_TILING_OPTIMAL,
                                                                   d.usage, 0, &limits);
  if (result)
    return vkFailed(subject + "format " + std::to_string(d.format) + " with usage " + std::to_string(d.usage), result);
  const VkExtent3D most = limits.maxExtent;
  if (d.width > most.width || d.height > most.height || d.depth > most.depth)
    return failed(subject + "too large; this device takes at most " + std::to_string(most.width) + "x" +
                  std::to_string(most.height) + (d.type == VK_IMAGE_TYPE_3D ? "x" + std::to_string(most.depth) : ""));
  if (d.layers > limits.maxArrayLayers)
    return failed(subject + "this device takes at most " + std::to_string(limits.maxArrayLayers) + " layers");
  const double bytes = static_cast<double>(d.width) * d.height * d.depth * d.layers * texelBytes(d.format);
  if (bytes > static_cast<double>(limits.maxResourceSize))
    return failed(subject + "too large; this device takes images of at most " + std::to_string(limits.maxResourceSize) +
                  " bytes");
  const std::uint32_t longest = std::max({d.width, d.height, d.depth});
  if (d.mips > limits.maxMipLevels || (d.mips > 1 && longest >> (d.mips - 1) == 0))
    return failed(subject + "too many mips for its size");
  return {};
}

}  // namespace

Image::State::~State() {
  for (const auto& [desc_, view] : views) vkDestroyImageView(device.device, view, nullptr);
  vkDestroyImage(device.device, image, nullptr);
}

Image::Image() noexcept = default;
Image::Image(Image&&) noexcept = default;
Image& Image::operator=(Image&& other) noexcept {
  if (this == &other) return *this;
  letGo(state_);
  state_ = std::move(other.state_);
  return *this;
}
Image::~Image() { letGo(state_); }

VkImage Image::handle() const { return state_->image; }
const ImageDesc& Image::desc() const { return state_->desc; }
VkDeviceSize Image::bytes() const { return state_->bytes; }

VkImageAspectFlags Image::aspect() const {
  switch (state_->desc.format) {
    case VK_FORMAT_D16_UNORM:
    case VK_FORMAT_X8_D24_UNORM_PACK32:
    case VK_FORMAT_D32_SFLOAT: return VK_IMAGE_ASPECT_DEPTH_BIT;
    case VK_FORMAT_S8_UINT: return VK_IMAGE_ASPECT_STENCIL_BIT;
    case VK_FORMAT_D16_UNORM_S8_UINT:
    case VK_FORMAT_D24_UNORM_S8_UINT:
    case VK_FORMAT_D32_SFLOAT_S8_UINT: return VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;
    default: return VK_IMAGE_ASPECT_COLOR_BIT;
  }
}

VkImageView Image::view(const ViewDesc& desc) const {
  const ImageDesc& image = state_->desc;
  ViewDesc full = desc;
  TY_ASSERT(desc.baseMip < image.mips && desc.baseLayer < image.layers, "view outside of image '" + image.name + "'");
  if (full.mipCount == 0) full.mipCount = image.mips - full.baseMip;
  if (full.layerCount == 0) full.layerCount = image.layers - full.baseLayer;
  TY_ASSERT(full.baseMip + full.mipCount <= image.mips && full.baseLayer + full.layerCount <= image.layers,
            "view outside of image '" + image.name + "'");
  full.array = full.array || full.layerCount > 1;
  for (const auto& [known, view] : state_->views)
    if (known == full) return view;

  VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  info.image = state_->image;
  info.format = image.format;
  switch (image.type) {
    case VK_IMAGE_TYPE_3D: info.viewType = VK_IMAGE_VIEW_TYPE_3D; break;
    case VK_IMAGE_TYPE_1D: info.viewType = full.array ? VK_IMAGE_VIEW_TYPE_1D_ARRAY : VK_IMAGE_VIEW_TYPE_1D; break;
    default: info.viewType = full.array ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D; break;
  }
  // A view that is sampled has one aspect; of depth and stencil the engine samples depth.
  const VkImageAspectFlags aspects = aspect();
  info.subresourceRange.aspectMask =
      (aspects & VK_IMAGE_ASPECT_DEPTH_BIT) ? static_cast<VkImageAspectFlags>(VK_IMAGE_ASPECT_DEPTH_BIT) : aspects;
  info.subresourceRange.baseMipLevel = full.baseMip;
  info.subresourceRange.levelCount = full.mipCount;
  info.subresourceRange.baseArrayLayer = full.baseLayer;
  info.subresourceRange.layerCount = full.layerCount;
  VkImageView view = VK_NULL_HANDLE;
  const VkResult result = vkCreateImageView(state_->device.device, &info, nullptr, &view);
  TY_ASSERT(result == VK_SUCCESS, "view of image '" + image.name + "': " + text(result));
  state_->device.name(VK_OBJECT_TYPE_IMAGE_VIEW, view, image.name);
  state_->views.emplace_back(full, view);
  return view;
}

Result<Image> Device::createImageAt(const ImageDesc& desc, std::shared_ptr<Allocation> memory, VkDeviceSize offset) {
  if (auto good = check(state_->physical, desc); !good) return good.error();
  const VkImageCreateInfo info = createInfo(desc);
  Image image;
  image.state_ = std::make_unique<Image::State>(*state_, desc.name);
  Image::State& made = *image.state_;
  made.desc = desc;
  if (const VkResult result = vkCreateImage(state_->device, &info, nullptr, &made.image)) {
    made.image = VK_NULL_HANDLE;
    return vkFailed("image '" + desc.name + "' (" + sizeText(desc) + ")", result);
  }
  VkMemoryRequirements needs{};
  vkGetImageMemoryRequirements(state_->device, made.image, &needs);
  made.bytes = needs.size;
  if (!memory) {
    auto own = state_->allocator->allocate(needs, MemoryUse::kDevice, desc.name);
    if (!own) return failed("image " + own.error().message + " (" + sizeText(desc) + ")");
    memory = own.take();
    memory->user.image = desc;
  }
  const VkDeviceSize at = memory->offset + offset;
  TY_ASSERT(at % needs.alignment == 0 && offset <= memory->size && needs.size <= memory->size - offset &&
                state_->allocator->fits(*memory, needs.memoryTypeBits),
            "image '" + desc.name + "' does not fit the memory at offset " + std::to_string(offset));
  if (const VkResult result = vkBindImageMemory(state_->device, made.image, memory->memory, at))
    return vkFailed("image '" + desc.name + "'", result);
  made.memory = std::move(memory);
  state_->name(VK_OBJECT_TYPE_IMAGE, made.image, desc.name);
  return image;
}

Result<Image> Device::createImage(const ImageDesc& desc) { return createImageAt(desc, nullptr, 0); }

VkMemoryRequirements Device::requirements(const ImageDesc& desc) {
  if (!check(state_->physical, desc)) return {};
  const VkImageCreateInfo info = createInfo(desc);
  VkDeviceImageMemoryRequirements query{VK_STRUCTURE_TYPE_DEVICE_IMAGE_MEMORY_REQUIREMENTS, nullptr, &info,
                                        VK_IMAGE_ASPECT_NONE};
  VkMemoryRequirements2 needs{VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
  vkGetDeviceImageMemoryRequirements(state_->device, &query, &needs);
  return state_->allocator->rounded(needs.memoryRequirements);
}

}  // namespace tyndall::gpu
