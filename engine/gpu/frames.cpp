// Submission, frames in flight and what waits for them before it is destroyed.
#include <algorithm>
#include <iterator>
#include <limits>

#include "base/assert.hpp"
#include "state.hpp"
#include "vk_text.hpp"

namespace tyndall::gpu {
namespace {

constexpr std::uint64_t kIdleNs = 4'000'000;  // a hand's events come every 4 to 16 ms

VkResult begin(VkCommandBuffer commands) {
  VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  return vkBeginCommandBuffer(commands, &info);
}

}  // namespace

VkResult Device::State::wait(const std::function<VkResult(std::uint64_t)>& attempt) const {
  if (!idle) return attempt(std::numeric_limits<std::uint64_t>::max());
  VkResult result = attempt(kIdleNs);
  for (; result == VK_TIMEOUT || result == VK_NOT_READY; result = attempt(kIdleNs)) idle();
  return result;
}

std::uint64_t Device::State::finishedFrames() const {
  std::uint64_t value = 0;
  // A lost device finishes nothing more; what waits is destroyed with the device.
  return vkGetSemaphoreCounterValue(device, timeline, &value) == VK_SUCCESS ? value : 0;
}

Result<void> Device::State::waitForFrame(std::uint64_t frame) const {
  VkSemaphoreWaitInfo sought{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
  sought.semaphoreCount = 1, sought.pSemaphores = &timeline, sought.pValues = &frame;
  const VkResult result = wait([&](std::uint64_t ns) { return vkWaitSemaphores(device, &sought, ns); });
  if (result) return vkFailed("frame " + std::to_string(frame) + " did not finish", result);
  return {};
}

void Device::State::retire(std::unique_ptr<Resource> resource) {
  // The frame being recorded may use it; a one-shot command buffer being recorded is waited for before collect().
  const std::uint64_t frame = recording && !unused ? submitted + 1 : submitted;
  if (oneShots == 0 && frame <= finishedFrames()) return;  // destroyed here
  retired.push_back({frame, std::move(resource)});
}

void Device::State::collect() {
  if (oneShots > 0 || retired.empty()) return;
  const std::uint64_t finished = finishedFrames();
  const auto done =
      std::partition(retired.begin(), retired.end(), [&](const Retired& r) { return r.frame > finished; });
  retired.erase(done, retired.end());
}

Result<Device::State::OneShot> Device::State::takeOneShot() {
  OneShot shot;
  if (!idleOneShots.empty()) {
    shot = idleOneShots.back();
    if (const VkResult result = vkResetFences(device, 1, &shot.fence)) return vkFailed("Vulkan: a fence", result);
    idleOneShots.pop_back();
    return shot;
  }
  const VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  if (const VkResult result = vkCreateFence(device, &fence, nullptr, &shot.fence))
    return vkFailed("Vulkan: no fence", result);
  const VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, oneShotPool,
                                             VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
  if (const VkResult result = vkAllocateCommandBuffers(device, &allocate, &shot.commands)) {
    vkDestroyFence(device, shot.fence, nullptr);
    return vkFailed("Vulkan: no command buffer", result);
  }
  return shot;
}

Result<void> Device::submitAndWait(const std::function<void(VkCommandBuffer)>& record) {
  State& s = *state_;
  auto taken = s.takeOneShot();
  if (!taken) return taken.error();
  const State::OneShot shot = *taken;
  VkResult result = begin(shot.commands);
  if (!result) {
    ++s.oneShots;
    record(shot.commands);
    result = vkEndCommandBuffer(shot.commands);
    VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO, nullptr, shot.commands, 0};
    VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submit.commandBufferInfoCount = 1, submit.pCommandBufferInfos = &buffer;
    if (!result) result = vkQueueSubmit2(s.queue, 1, &submit, shot.fence);
    if (!result)
      result = s.wait([&](std::uint64_t ns) { return vkWaitForFences(s.device, 1, &shot.fence, VK_TRUE, ns); });
    --s.oneShots;
  }
  s.collect();
  if (!result) {
    // Kept for the next one: the validation layer holds something of each command buffer after it was freed.
    s.idleOneShots.push_back(shot);
    return {};
  }
  vkDestroyFence(s.device, shot.fence, nullptr);
  vkFreeCommandBuffers(s.device, s.oneShotPool, 1, &shot.commands);
  return vkFailed("Vulkan: a submission failed", result);
}

Result<VkCommandBuffer> Device::beginFrame() {
  State& s = *state_;
  State::Slot& slot = s.slots[s.submitted % s.slots.size()];
  if (auto waited = s.waitForFrame(slot.frame); !waited) return waited.error();
  s.collect();
  if (const VkResult result = vkResetCommandPool(s.device, slot.pool, 0))
    return vkFailed("Vulkan: command pool", result);
  if (const VkResult result = begin(slot.commands)) return vkFailed("Vulkan: command buffer", result);
  s.recording = true;
  return slot.commands;
}

Result<void> Device::endFrame(const FrameSignals& signals) {
  State& s = *state_;
  TY_ASSERT(s.recording, "endFrame without beginFrame");
  State::Slot& slot = s.slots[s.submitted % s.slots.size()];
  const std::uint64_t frame = s.submitted + 1;
  VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO, nullptr, slot.commands, 0};
  const auto semaphore = [](VkSemaphore handle, std::uint64_t value, VkPipelineStageFlags2 stage) {
    return VkSemaphoreSubmitInfo{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO, nullptr, handle, value, stage, 0};
  };
  const VkSemaphoreSubmitInfo wait = semaphore(signals.wait, 0, signals.waitStage);
  const std::array signalled{semaphore(s.timeline, frame, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT),
                             semaphore(signals.signal, 0, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT)};
  VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  submit.waitSemaphoreInfoCount = signals.wait ? 1 : 0, submit.pWaitSemaphoreInfos = &wait;
  submit.commandBufferInfoCount = 1, submit.pCommandBufferInfos = &buffer;
  submit.signalSemaphoreInfoCount = signals.signal ? 2 : 1, submit.pSignalSemaphoreInfos = signalled.data();
  VkResult result = vkEndCommandBuffer(slot.commands);
  if (!result) result = vkQueueSubmit2(s.queue, 1, &submit, VK_NULL_HANDLE);
  s.recording = false;
  if (result) return vkFailed("Vulkan: a frame could not be submitted", result);
  slot.frame = s.submitted = frame;
  return {};
}

std::uint64_t Device::submittedFrames() const { return state_->submitted; }

Result<void> Device::waitForFrames() { return state_->waitForFrame(state_->submitted); }

VkResult Device::wait(const std::function<VkResult(std::uint64_t)>& attempt) const { return state_->wait(attempt); }

void Device::whileWaiting(std::function<void()> idle) { state_->idle = std::move(idle); }

Result<void> Device::waitIdle() {
  if (auto waited = waitForFrames(); !waited) return waited;  // this wait can be made idly
  if (const VkResult result = vkDeviceWaitIdle(state_->device))
    return vkFailed("Vulkan: waiting for the device", result);
  state_->collect();
  return {};
}

Result<void> Device::destroyNow(const std::function<void()>& letGo) {
  if (auto idle = waitIdle(); !idle) return idle;
  // What the frame being recorded let go of before waits for that frame, although nothing of it is recorded there yet.
  if (state_->oneShots == 0) state_->retired.clear();
  state_->unused = true;
  letGo();
  state_->unused = false;
  return {};
}

}  // namespace tyndall::gpu
