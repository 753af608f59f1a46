// The pipeline cache's file: one per device and driver, with a checksum of its own, since drivers differ in how well they
// survive a damaged cache.
#include <cstring>

#include "base/file.hpp"
#include "base/log.hpp"
#include "state.hpp"
#include "vk_text.hpp"

namespace tyndall::gpu {
namespace {

struct FileHeader {
  std::array<char, 8> magic{'T', 'Y', 'P', 'C', 'A', 'C', 'H', '1'};
  std::uint64_t hash = 0;
};

// FNV-1a, 64 bit (Fowler, Noll, Vo 1991; constants from the authors).
std::uint64_t hashOf(std::span<const std::byte> bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const std::byte byte : bytes) hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3ull;
  return hash;
}

}  // namespace

void openPipelineCache(Device::State& state, const VkPhysicalDeviceProperties& properties) {
  std::vector<std::byte> data;
  if (const auto folder = cacheFolder(); !folder.empty()) {
    std::string name = "pipelines-";
    for (const std::uint8_t byte : properties.pipelineCacheUUID)
      for (const int nibble : {byte >> 4, byte & 15}) name += "0123456789abcdef"[nibble];
    state.pipelineCacheFile = folder / (name + "-" + std::to_string(properties.driverVersion) + ".bin");
    std::error_code none;
    if (std::filesystem::exists(state.pipelineCacheFile, none)) {
      auto file = readFile(state.pipelineCacheFile);
      FileHeader header, expected;
      if (file && file->size() >= sizeof header) {
        std::memcpy(&header, file->data(), sizeof header);
        data.assign(file->begin() + sizeof header, file->end());
        if (header.magic != expected.magic || header.hash != hashOf(data)) data.clear();
      }
      if (data.empty()) log::debug("pipeline cache: " + state.pipelineCacheFile.string() + " is damaged, starting anew");
      else state.pipelineCacheHash = header.hash;
    }
  }
  VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  info.initialDataSize = data.size(), info.pInitialData = data.data();
  if (const VkResult result = vkCreatePipelineCache(state.device, &info, nullptr, &state.pipelineCache)) {
    log::warning("pipeline cache: none, pipelines are made without (" + text(result) + ")");
    state.pipelineCache = VK_NULL_HANDLE;
  }
}

void savePipelineCache(Device::State& state) {
  if (!state.pipelineCache) return;
  std::size_t size = 0;
  vkGetPipelineCacheData(state.device, state.pipelineCache, &size, nullptr);
  std::vector<std::byte> file(sizeof(FileHeader) + size);
  const bool read = vkGetPipelineCacheData(state.device, state.pipelineCache, &size, file.data() + sizeof(FileHeader)) == VK_SUCCESS;
  file.resize(sizeof(FileHeader) + size);
  vkDestroyPipelineCache(state.device, state.pipelineCache, nullptr);
  state.pipelineCache = VK_NULL_HANDLE;
  // A cache of nothing but Vulkan's own header (lavapipe's) is not worth a file.
  if (!read || size <= sizeof(VkPipelineCacheHeaderVersionOne) || state.pipelineCacheFile.empty()) return;
  FileHeader header;
  header.hash = hashOf(std::span(file).subspan(sizeof header));
  if (header.hash == state.pipelineCacheHash) return;
  std::memcpy(file.data(), &header, sizeof header);
  if (auto written = writeFileAtomically(state.pipelineCacheFile, file); !written)
    log::warning("pipeline cache: " + written.error().message);
}

}  // namespace tyndall::gpu
