#include "shadow_cache.hpp"

#include <algorithm>

#include "base/hash.hpp"

namespace tyndall::render {

std::uint64_t casterContent(const FrameData& frame) {
  // The order of draws follows the camera and is not a part of it.
  std::uint64_t casters = 0;
  for (const Draw& draw : frame.draws.solid) {
    if (!draw.casts) continue;
    casters += Hash()
                   .add(draw.range.firstIndex)
                   .add(draw.range.indexCount)
                   .add(draw.range.vertexOffset)
                   .add(draw.range.material)
                   .add(frame.draws.instances[draw.instance].worldFromObject)
                   .value();
  }
  return Hash().add(casters).add(frame.materialsHash).add(frame.resources.get()).value();
}

std::uint64_t shadowContent(const FrameData& frame, const ShadowFit& fit) {
  Hash hash;
  hash.add(casterContent(frame)).add(fit.useful).add(fit.faceCount);
  for (std::uint32_t face = 0; face < fit.faceCount; ++face) hash.add(fit.clipFromWorld[face]);
  return hash.value();
}

Result<std::shared_ptr<KeptShadowMap>> ShadowCache::map(std::uint32_t source, gpu::ImageDesc desc) {
  desc.usage =
      VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
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
    return std::none_of(lights.begin(), lights.end(),
                        [&](const PlannedLight& light) { return light.source == entry.first; });
  });
}

}  // namespace tyndall::render
