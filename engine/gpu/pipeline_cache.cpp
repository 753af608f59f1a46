#include "pipeline_cache.hpp"

#include <array>
#include <cstring>

#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"
#include "vk_text.hpp"

namespace tyndall::gpu {
namespace {

constexpr std::array<char, 8> kMagic{'T', 'Y', 'P', 'C', 'A', 'C', 'H', '1'};

struct FileHeader {
  std::array<char, 8> magic = kMagic;
  std::uint64_t hash = 0;
};

std::filesystem::path cacheFile(const VkPhysicalDeviceProperties& properties) {
  const auto folder = cacheFolder();
  if (folder.empty()) return {};
  std::string name = "pipelines-";
  for (const std::uint8_t byte : properties.pipelineCacheUUID)
    for (const int nibble : {byte >> 4, byte & 15}) name += "0123456789abcdef"[nibble];
  return folder / (name + "-" + std::to_string(properties.driverVersion) + ".bin");
}

}  // namespace

std::vector<std::byte> packCache(std::span<const std::byte> data) {
  const FileHeader header{kMagic, Hash().bytes(data).value()};
  std::vector<std::byte> file(sizeof header + data.size());
  std::memcpy(file.data(), &header, sizeof header);
  if (!data.empty()) std::memcpy(file.data() + sizeof header, data.data(), data.size());
  return file;
}

std::optional<std::vector<std::byte>> unpackCache(std::span<const std::byte> file) {
  FileHeader header;
  if (file.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, file.data(), sizeof header);
  const auto data = file.subspan(sizeof header);
  if (header.magic != kMagic || header.hash != Hash().bytes(data).value()) return std::nullopt;
  return std::vector<std::byte>(data.begin(), data.end());
}

void openPipelineCache(Device::State& state, const VkPhysicalDeviceProperties& properties) {
  state.pipelineCacheFile = cacheFile(properties);
  std::error_code none;
  if (!state.pipelineCacheFile.empty() && std::filesystem::exists(state.pipelineCacheFile, none)) {
    const auto file = readFile(state.pipelineCacheFile);
    auto data = file ? unpackCache(*file) : std::nullopt;
    if (data)
      state.pipelineCacheRead = std::move(*data);
    else
      log::debug("pipeline cache: " + state.pipelineCacheFile.string() + " is damaged, starting anew");
  }
  VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  info.initialDataSize = state.pipelineCacheRead.size(), info.pInitialData = state.pipelineCacheRead.data();
  if (const VkResult result = vkCreatePipelineCache(state.device, &info, nullptr, &state.pipelineCache)) {
    log::warning("pipeline cache: none, pipelines are made without (" + text(result) + ")");
    state.pipelineCache = VK_NULL_HANDLE;
  }
}

void savePipelineCache(Device::State& state) {
  if (!state.pipelineCache) return;
  std::size_t size = 0;
  VkResult result = vkGetPipelineCacheData(state.device, state.pipelineCache, &size, nullptr);
  std::vector<std::byte> data(size);
  if (!result) result = vkGetPipelineCacheData(state.device, state.pipelineCache, &size, data.data());
  data.resize(size);
  vkDestroyPipelineCache(state.device, state.pipelineCache, nullptr);
  state.pipelineCache = VK_NULL_HANDLE;
  // A cache of nothing but Vulkan's own header (lavapipe's) is not worth a file.
  const bool worth = !result && size > sizeof(VkPipelineCacheHeaderVersionOne) && data != state.pipelineCacheRead;
  if (!worth || state.pipelineCacheFile.empty()) return;
  if (auto written = writeFileAtomically(state.pipelineCacheFile, packCache(data)); !written)
    log::warning("pipeline cache: " + written.error().message);
}

}  // namespace tyndall::gpu
