#include "app/memory.hpp"

#include <algorithm>

#include "texel_format.hpp"

namespace tyndall::app {
namespace {

std::string formatText(VkFormat format) {
  if (const char* name = texelFormat(format).name) return name;
  switch (format) {
    case VK_FORMAT_R32_UINT: return "R32 uint";
    case VK_FORMAT_R32G32_UINT: return "RG32 uint";
    case VK_FORMAT_R32G32B32A32_UINT: return "RGBA32 uint";
    case VK_FORMAT_B8G8R8A8_UNORM: return "BGRA8 unorm";
    default: return "VkFormat " + std::to_string(format);
  }
}

std::string imageText(const gpu::ImageDesc& image) {
  std::string text = std::to_string(image.width) + "x" + std::to_string(image.height);
  if (image.type == VK_IMAGE_TYPE_3D) text += "x" + std::to_string(image.depth);
  text += " " + formatText(image.format);
  if (image.layers > 1) text += ", " + std::to_string(image.layers) + " layers";
  if (image.mips > 1) text += ", " + std::to_string(image.mips) + " mips";
  return text;
}

}  // namespace

std::vector<ResourceMemory> keptMemory(const gpu::Device& device) {
  std::vector<ResourceMemory> list;
  for (const gpu::MemoryUser& user : device.memoryUsers())
    list.push_back({user.name, "",
                    user.image    ? imageText(*user.image)
                    : user.shared ? "shared in turn"
                                  : "buffer",
                    user.bytes, "", ""});
  return list;
}

std::vector<ResourceMemory> passingMemory(const Session& session) {
  std::vector<ResourceMemory> list;
  for (const render::TransientUse& use : session.transients())
    list.push_back(
        {use.name, use.owner, use.image ? imageText(*use.image) : "buffer", use.bytes, use.firstPass, use.lastPass});
  std::stable_sort(list.begin(), list.end(),
                   [](const ResourceMemory& a, const ResourceMemory& b) { return a.bytes > b.bytes; });
  return list;
}

}  // namespace tyndall::app
