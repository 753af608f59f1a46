// The uniform blocks that prepare() fills: a staging copy on the CPU and a mapped ring that the GPU reads.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/device.hpp"
#include "host/layout.hpp"

namespace tyndall::host {

/// At most two frames are in flight (gpu::Device) while a third is prepared.
inline constexpr std::uint32_t kFrameSlots = 3;

class UniformRing {
 public:
  /// Also holds the run-by-run skip flags that prepare() may set.
  static Result<UniformRing> create(gpu::Device& device, const Layout& layout, std::uint32_t lights,
                                    const std::string& name);
  UniformRing() = default;

  /// Zeroes the staging copy and returns where prepare() writes. Plugins never see mapped memory: reading that can be
  /// slow, and a failed prepare leaves nothing behind.
  const TyUniformData& begin();
  /// Copies the staging copy into `slot` for the GPU.
  void commit(std::uint32_t slot);

  struct Place {
    VkDeviceSize offset = 0, size = 0;
  };
  Place place(std::uint32_t block, std::uint32_t light, std::uint32_t slot) const;
  const std::byte* staged(std::uint32_t block, std::uint32_t light) const;
  /// Set by the last prepare(): this run of `pass` has nothing to do in this frame.
  bool skipped(std::uint32_t pass, std::uint32_t light) const {
    return skip_[std::size_t{pass} * skipStride_ + light] != 0;
  }
  VkBuffer buffer() const { return ring_.handle(); }
  std::uint64_t bytes() const { return ring_ ? ring_.size() : 0; }

 private:
  struct Block {
    std::size_t offset = 0;
    std::uint32_t size = 0, stride = 0;
    bool perLight = false;
  };
  std::vector<Block> blocks_;
  std::vector<std::byte> staging_;
  std::vector<std::uint8_t*> data_;
  std::vector<std::uint32_t> strides_;
  std::vector<std::uint8_t> skip_;
  std::uint32_t skipStride_ = 1;
  TyUniformData abi_{};
  gpu::Buffer ring_;
};

}  // namespace tyndall::host
