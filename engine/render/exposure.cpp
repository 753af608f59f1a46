#include "exposure.hpp"

#include <cmath>
#include <cstring>
#include <vector>

namespace tyndall::render {

namespace {

constexpr std::uint32_t kGroup = 16;          // exposure_meter.comp's pixels a side
constexpr std::uint32_t kMaxSamples = 65536;  // half of what the shader's sums take

constexpr float kSettled = 1e6f;  // seconds after which nothing is left of the factor before

Result<gpu::Buffer> zeros(gpu::Device& device, const char* name, std::size_t bytes) {
  Result<gpu::Buffer> buffer =
      device.createBuffer({name, bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT, false});
  if (!buffer) return buffer;
  const std::vector<std::byte> nothing(bytes);
  if (Result<void> filled = device.upload(*buffer, nothing); !filled) return filled.error();
  return buffer;
}

std::uint32_t strideFor(std::uint32_t width, std::uint32_t height) {
  std::uint32_t stride = 1;
  const auto across = [&](std::uint32_t side) { return (std::uint64_t{side} + stride - 1) / stride; };
  while (across(width) * across(height) > kMaxSamples) ++stride;
  return stride;
}

}  // namespace

Result<ExposureMeter> ExposureMeter::create(gpu::Device& device) {
  ExposureMeter meter;
  Result<gpu::Buffer> counts = zeros(device, "exposure counts", sizeof(shared::ExposureCounts));
  if (!counts) return counts.error();
  Result<gpu::Buffer> metered = zeros(device, "metered", sizeof(shared::MeteredBlock));
  if (!metered) return metered.error();
  meter.counts_ = counts.take();
  meter.metered_ = metered.take();
  for (gpu::Buffer& copy : meter.copies_) {
    Result<gpu::Buffer> made = device.createBuffer(
        {"metered, for the host", sizeof(shared::MeteredBlock), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, true});
    if (!made) return made.error();
    copy = made.take();
  }
  return meter;
}

Result<std::uint32_t> ExposureMeter::addPass(Graph& graph, const PassTools& tools, const View& view, ImageRef color,
                                             ImageRef scatter, ImageRef depth, float seconds) {
  const Result<const gpu::Pipeline*> look = tools.pipelines.get(exposureMeterRecipe(static_cast<bool>(scatter)));
  if (!look) return look.error();
  const Result<const gpu::Pipeline*> adapt = tools.pipelines.get(exposureAdaptRecipe());
  if (!adapt) return adapt.error();
  const std::uint32_t slot = next_;
  next_ = (next_ + 1) % kSlots;
  shared::MeterPush push{};
  push.tangent = {view.viewFromClip[0][0], -view.viewFromClip[1][1]};
  push.size = {view.width, view.height};
  push.znear = view.znear;
  push.zfar = view.zfar;
  push.stride = strideFor(view.width, view.height);
  push.seconds = seconds < 0 ? kSettled : seconds;
  const std::uint32_t each = push.stride * kGroup;
  const std::uint32_t across = (view.width + each - 1) / each, down = (view.height + each - 1) / each;

  const BufferRef counts = graph.import(counts_), metered = graph.import(metered_), copy = graph.import(copies_[slot]);
  const ImageRef second = scatter ? scatter : color;  // bound but not read without scatter
  Graph::Pass pass = graph.pass("exposure");
  pass.use(color, Use::kSampledCompute).use(depth, Use::kSampledCompute);
  if (scatter) pass.use(scatter, Use::kSampledCompute);
  pass.use(counts, Use::kStorageReadWriteCompute)
      .use(metered, Use::kStorageReadWriteCompute)
      .use(copy, Use::kStorageWriteCompute)
      .run([=, &meter = **look, &adaptation = **adapt, texel = tools.samplers.texel](PassContext& context) {
        const VkCommandBuffer commands = context.commands();
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, meter.handle());
        gpu::Descriptors(commands, meter)
            .sampled(0, context.view(color), texel)
            .sampled(1, context.view(second), texel)
            .sampled(2, context.view(depth), texel)
            .storageBuffer(3, context.buffer(counts))
            .push();
        vkCmdPushConstants(commands, meter.layout(), VK_SHADER_STAGE_ALL, 0, sizeof push, &push);
        vkCmdDispatch(commands, across, down, 1);
        gpu::fullBarrier(commands);  // the counts
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, adaptation.handle());
        gpu::Descriptors(commands, adaptation)
            .storageBuffer(0, context.buffer(counts))
            .storageBuffer(1, context.buffer(metered))
            .storageBuffer(2, context.buffer(copy))
            .push();
        vkCmdPushConstants(commands, adaptation.layout(), VK_SHADER_STAGE_ALL, 0, sizeof push, &push);
        vkCmdDispatch(commands, 1, 1, 1);
      });
  return slot;
}

shared::MeteredBlock ExposureMeter::read(std::uint32_t slot) const {
  shared::MeteredBlock metered;
  std::memcpy(&metered, copies_[slot].mapped(), sizeof metered);
  return metered;
}

}  // namespace tyndall::render
