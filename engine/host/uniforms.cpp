#include "uniforms.hpp"

#include <algorithm>
#include <cstring>

namespace tyndall::host {

Result<UniformRing> UniformRing::create(gpu::Device& device, const Layout& layout, std::uint32_t lights,
                                        const std::string& name) {
  UniformRing ring;
  // 16: a block never starts on a worse boundary than the CPU's widest loads like.
  const auto alignment =
      std::max<std::size_t>(16, static_cast<std::size_t>(device.info().limits.minUniformBufferOffsetAlignment));
  std::size_t bytes = 0;
  for (const LayoutUniform& uniform : layout.uniforms) {
    const auto stride = (uniform.d.size + alignment - 1) / alignment * alignment;
    ring.blocks_.push_back({bytes, uniform.d.size, static_cast<std::uint32_t>(stride), uniform.d.per_light != 0});
    bytes += stride * (uniform.d.per_light ? std::max(1u, lights) : 1);
  }
  if (bytes > 0) {
    auto buffer = device.createBuffer(
        {.name = name, .size = bytes * kFrameSlots, .usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, .hostVisible = true});
    if (!buffer) return buffer.error();
    ring.ring_ = buffer.take();
  }
  ring.staging_.resize(bytes);
  ring.skipStride_ = std::max(1u, lights);
  ring.skip_.resize(layout.passes.size() * ring.skipStride_);
  return ring;
}

const TyUniformData& UniformRing::begin() {
  std::fill(staging_.begin(), staging_.end(), std::byte{0});
  std::fill(skip_.begin(), skip_.end(), std::uint8_t{0});
  data_.clear();
  strides_.clear();
  for (const Block& block : blocks_) {
    data_.push_back(reinterpret_cast<std::uint8_t*>(staging_.data() + block.offset));
    strides_.push_back(block.stride);
  }
  abi_ = {};
  abi_.struct_size = sizeof abi_;
  abi_.block_count = static_cast<std::uint32_t>(blocks_.size());
  abi_.data = data_.data();
  abi_.stride = strides_.data();
  abi_.skip = skip_.data();
  abi_.skip_stride = skipStride_;
  return abi_;
}

void UniformRing::commit(std::uint32_t slot) {
  if (!staging_.empty()) std::memcpy(ring_.mapped() + slot * staging_.size(), staging_.data(), staging_.size());
}

UniformRing::Place UniformRing::place(std::uint32_t block, std::uint32_t light, std::uint32_t slot) const {
  const Block& b = blocks_[block];
  return {slot * staging_.size() + b.offset + (b.perLight ? std::size_t{light} * b.stride : 0), b.size};
}

const std::byte* UniformRing::staged(std::uint32_t block, std::uint32_t light) const {
  const Block& b = blocks_[block];
  return staging_.data() + b.offset + (b.perLight ? std::size_t{light} * b.stride : 0);
}

}  // namespace tyndall::host
