#include "draw_record.hpp"

#include "culling.hpp"

namespace tyndall::render {

namespace {

constexpr std::uint32_t kNothing = ~0u;

void bindBuffers(VkCommandBuffer commands, const SceneResources& resources) {
  const VkBuffer vertices = resources.vertices.handle();
  const VkDeviceSize offset = 0;
  vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
  vkCmdBindIndexBuffer(commands, resources.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
}

void drawOne(VkCommandBuffer commands, const Draw& draw) {
  vkCmdDrawIndexed(commands, draw.range.indexCount, 1, draw.range.firstIndex, draw.range.vertexOffset, draw.instance);
}

void bindFrame(gpu::Descriptors& d, const FrameData& frame) {
  d.uniformBuffer(0, frame.viewBlock.buffer, frame.viewBlock.offset, frame.viewBlock.size)
      .storageBuffer(1, frame.instanceBlocks.buffer, frame.instanceBlocks.offset, frame.instanceBlocks.size)
      .storageBuffer(2, frame.resources->materialBlocks.handle());
}

void bindMaterial(gpu::Descriptors& d, const MaterialBindings& m) {
  d.sampled(3, m.baseColor.view, m.baseColor.sampler)
      .sampled(4, m.alpha.view, m.alpha.sampler)
      .sampled(5, m.metallicRoughness.view, m.metallicRoughness.sampler)
      .sampled(6, m.normal.view, m.normal.sampler)
      .sampled(7, m.occlusion.view, m.occlusion.sampler)
      .sampled(8, m.emissive.view, m.emissive.sampler);
}

// Draws one after the other; `pipelineOf` chooses, `afterChange` pushes what a newly bound pipeline needs beyond the frame.
template <class PipelineOf, class AfterChange>
void recordShaded(PassContext& context, const FrameData& frame, const std::vector<Draw>& draws, PipelineOf pipelineOf, AfterChange afterChange) {
  const VkCommandBuffer commands = context.commands();
  bindBuffers(commands, *frame.resources);
  const gpu::Pipeline* bound = nullptr;
  std::uint32_t material = kNothing;
  for (const Draw& draw : draws) {
    if (!mayBeSeen(draw.bounds, frame.clipFromWorld, DepthPlanes::kBoth)) continue;
    const gpu::Pipeline* pipeline = pipelineOf(draw);
    if (pipeline != bound || draw.range.material != material) {
      gpu::Descriptors descriptors(commands, *pipeline);
      if (pipeline != bound) {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline->handle());
        bindFrame(descriptors, frame);
        afterChange(*pipeline);
        bound = pipeline;
      }
      bindMaterial(descriptors, frame.resources->materials[draw.range.material]);
      descriptors.push();
      material = draw.range.material;
    }
    drawOne(commands, draw);
  }
}

}  // namespace

void recordSolid(PassContext& context, const FrameData& frame, const GeometryPipelines& pipelines) {
  recordShaded(
      context, frame, frame.draws.solid,
      [&](const Draw& draw) { return (draw.mask ? pipelines.mask : pipelines.opaque)[static_cast<std::size_t>(draw.facing)]; },
      [](const gpu::Pipeline&) {});
}

void recordBlended(PassContext& context, const FrameData& frame, const std::array<const gpu::Pipeline*, 3>& pipelines,
                   const std::function<void(const gpu::Pipeline&)>& bindLights) {
  recordShaded(
      context, frame, frame.draws.blended, [&](const Draw& draw) { return pipelines[static_cast<std::size_t>(draw.facing)]; }, bindLights);
}

bool anyBlendedVisible(const FrameData& frame) {
  for (const Draw& draw : frame.draws.blended) {
    if (mayBeSeen(draw.bounds, frame.clipFromWorld, DepthPlanes::kBoth)) return true;
  }
  return false;
}

void recordCasters(PassContext& context, const FrameData& frame, const CasterPipelines& pipelines, const glm::mat4& clipFromWorld) {
  const VkCommandBuffer commands = context.commands();
  bindBuffers(commands, *frame.resources);
  const gpu::Pipeline* bound = nullptr;
  std::uint32_t material = kNothing;
  for (const Draw& draw : frame.draws.solid) {
    if (!mayBeSeen(draw.bounds, clipFromWorld, DepthPlanes::kClamped)) continue;
    const gpu::Pipeline* pipeline = draw.mask ? pipelines.mask : pipelines.opaque;
    if (pipeline != bound) {
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline->handle());
      vkCmdPushConstants(commands, pipeline->layout(), VK_SHADER_STAGE_ALL, 0, sizeof(glm::mat4), &clipFromWorld);
      gpu::Descriptors(commands, *pipeline)
          .storageBuffer(0, frame.instanceBlocks.buffer, frame.instanceBlocks.offset, frame.instanceBlocks.size)
          .storageBuffer(1, frame.resources->materialBlocks.handle())
          .push();
      bound = pipeline;
      material = kNothing;
    }
    if (draw.mask && draw.range.material != material) {
      const TextureBinding& alpha = frame.resources->materials[draw.range.material].alpha;
      gpu::Descriptors(commands, *pipeline).sampled(2, alpha.view, alpha.sampler).push();
      material = draw.range.material;
    }
    drawOne(commands, draw);
  }
}

}  // namespace tyndall::render
