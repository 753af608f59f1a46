#include "base/assert.hpp"
#include "gpu/pipeline.hpp"
#include "state.hpp"
#include "vk_text.hpp"

namespace tyndall::gpu {

struct Timestamps::State : Resource {
  using Resource::Resource;
  ~State() override { vkDestroyQueryPool(device.device, pool, nullptr); }
  VkQueryPool pool = VK_NULL_HANDLE;
  std::uint32_t capacity = 0, written = 0;

  void write(VkCommandBuffer commands) {
    // Waits for all that precedes, then a barrier: lavapipe assigns a timestamp to the right pass only so.
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool, written++);
    fullBarrier(commands);
  }
};

Timestamps::Timestamps() noexcept = default;
Timestamps::Timestamps(Timestamps&&) noexcept = default;
Timestamps& Timestamps::operator=(Timestamps&& other) noexcept {
  if (this == &other) return *this;
  letGo(state_);
  state_ = std::move(other.state_);
  return *this;
}
Timestamps::~Timestamps() { letGo(state_); }

Result<Timestamps> Timestamps::create(Device& device, std::uint32_t capacity) {
  TY_ASSERT(capacity > 0, "timestamps for no pass");
  Device::State& owner = device.state();
  if (owner.timestampBits == 0) return failed("timestamps: the queue of '" + owner.info.name + "' has none");
  Timestamps made;
  made.state_ = std::make_unique<State>(owner, "timestamps");
  made.state_->capacity = capacity;
  VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = capacity + 1;
  if (const VkResult result = vkCreateQueryPool(owner.device, &info, nullptr, &made.state_->pool))
    return vkFailed("timestamps", result);
  owner.name(VK_OBJECT_TYPE_QUERY_POOL, made.state_->pool, "timestamps");
  return made;
}

std::uint32_t Timestamps::capacity() const { return state_ ? state_->capacity : 0; }

void Timestamps::begin(VkCommandBuffer commands) {
  state_->written = 0;
  vkCmdResetQueryPool(commands, state_->pool, 0, state_->capacity + 1);
  fullBarrier(commands);
  state_->write(commands);
}

void Timestamps::mark(VkCommandBuffer commands) {
  TY_ASSERT(state_->written > 0 && state_->written <= state_->capacity,
            "mark " + std::to_string(state_->written) + " of " + std::to_string(state_->capacity));
  state_->write(commands);
}

std::vector<double> Timestamps::milliseconds() const {
  if (state_->written < 2) return {};
  std::vector<std::uint64_t> ticks(state_->written);
  const VkResult result = vkGetQueryPoolResults(state_->device.device, state_->pool, 0, state_->written,
                                                ticks.size() * sizeof(std::uint64_t), ticks.data(),
                                                sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT);
  TY_ASSERT(result == VK_SUCCESS, "timestamps were asked for before their frame was finished: " + text(result));
  // The counter has timestampBits and wraps; a difference of two is right in that many bits.
  const std::uint32_t bits = state_->device.timestampBits;
  const std::uint64_t mask = bits >= 64 ? ~0ull : (1ull << bits) - 1;
  std::vector<double> spans;
  for (std::size_t i = 1; i < ticks.size(); ++i)
    spans.push_back(static_cast<double>((ticks[i] - ticks[i - 1]) & mask) * state_->device.info.timestampPeriodNs *
                    1e-6);
  return spans;
}

}  // namespace tyndall::gpu
