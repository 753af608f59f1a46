#include "shadow_cache.hpp"

#include <algorithm>
#include <cstring>

namespace tyndall::render {
namespace {

/// FNV-1a, 64 bit.
class Hash {
 public:
  template <class T>
  Hash& add(const T& value) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (const unsigned char byte : bytes) value_ = (value_ ^ byte) * 1099511628211ull;
    return *this;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ull;
};

}  // namespace

std::uint64_t bytesHash(std::span<const std::byte> bytes) {
  Hash hash;
  for (const std::byte byte : bytes) hash.add(byte);
  return hash.value();
}

std::uint64_t shadowContent(const FrameData& frame, const ShadowFit& fit) {
  // The order of draws follows the camera and is not a part of it.
  std::uint64_t casters = 0;
  for (const Draw& draw : frame.draws.solid)
    casters += Hash().add(draw.range.firstIndex).add(draw.range.indexCount).add(draw.range.vertexOffset).add(draw.range.material)
                   .add(frame.draws.instances[draw.instance].worldFromObject).value();
  Hash hash;
  hash.add(casters).add(frame.materialsHash).add(frame.resources.get()).add(fit.useful).add(fit.faceCount);
  for (std::uint32_t face = 0; face < fit.faceCount; ++face) hash.add(fit.clipFromWorld[face]);
  return hash.value();
}

Result<std::shared_ptr<KeptShadowMap>> ShadowCache::map(std::uint32_t source, gpu::ImageDesc desc) {
  desc.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  std::shared_ptr<KeptShadowMap>& kept = maps_[source];
  if (kept && kept->image.desc() == desc) return kept;
  kept.reset();
  Result<gpu::Image> image = device_.createImage(desc);
  if (!image) return image.error();
  kept = std::make_shared<KeptShadowMap>();
  kept->image = image.take();
  return kept;
}

void ShadowCache::keepOnly(const std::vector<PlannedLight>& lights) {
  std::erase_if(maps_, [&](const auto& entry) {
    return std::none_of(lights.begin(), lights.end(), [&](const PlannedLight& light) { return light.source == entry.first; });
  });
}

}  // namespace tyndall::render
