#include "draw_record.hpp"

#include <map>
#include <tuple>

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
      .storageBuffer(1, frame.instanceBlocks.buffer, frame.instanceBlocks.offset, frame.instanceBlocks.size);
}

void bindMaterialBlock(gpu::Descriptors& d, std::uint32_t binding, const FrameData& frame, std::uint32_t material) {
  const BlockRange& all = frame.materialBlocks;
  d.uniformBuffer(binding, all.buffer, all.offset + material * kMaterialStride, sizeof(shared::MaterialBlock));
}

void bindMaps(gpu::Descriptors& d, const MaterialBindings& m) {
  d.sampled(3, m.baseColor.view, m.baseColor.sampler)
      .sampled(4, m.alpha.view, m.alpha.sampler)
      .sampled(5, m.metallicRoughness.view, m.metallicRoughness.sampler)
      .sampled(6, m.normal.view, m.normal.sampler)
      .sampled(7, m.occlusion.view, m.occlusion.sampler)
      .sampled(8, m.emissive.view, m.emissive.sampler);
}

}  // namespace

Result<DrawPipelines> pipelinesOf(PipelineLibrary& library, const std::vector<Draw>& draws,
                                  const std::function<Recipe(const Draw&)>& recipeOf) {
  std::map<std::tuple<Facing, bool, std::uint32_t>, const gpu::Pipeline*> known;
  DrawPipelines pipelines;
  for (const Draw& draw : draws) {
    const gpu::Pipeline*& pipeline = known[{draw.facing, draw.mask, draw.textures}];
    if (!pipeline) {
      Result<const gpu::Pipeline*> made = library.get(recipeOf(draw));
      if (!made) return made.error();
      pipeline = *made;
    }
    pipelines.push_back(pipeline);
  }
  return pipelines;
}

void recordShaded(PassContext& context, const FrameData& frame, const std::vector<Draw>& draws,
                  const DrawPipelines& pipelines, const std::function<void(const gpu::Pipeline&)>& bindMore) {
  const VkCommandBuffer commands = context.commands();
  bindBuffers(commands, *frame.resources);
  const gpu::Pipeline* bound = nullptr;
  std::uint32_t material = kNothing;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const Draw& draw = draws[i];
    if (!mayBeSeen(draw.bounds, frame.clipFromWorld, DepthPlanes::kBoth)) continue;
    if (pipelines[i] != bound || draw.range.material != material) {
      gpu::Descriptors descriptors(commands, *pipelines[i]);
      if (pipelines[i] != bound) {
        bound = pipelines[i];
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, bound->handle());
        bindFrame(descriptors, frame);
        if (bindMore) bindMore(*bound);
      }
      material = draw.range.material;
      bindMaterialBlock(descriptors, 2, frame, material);
      bindMaps(descriptors, frame.resources->materials[material]);
      descriptors.push();
    }
    drawOne(commands, draw);
  }
}

Result<CasterPipelines> casterPipelines(PipelineLibrary& library) {
  Result<const gpu::Pipeline*> opaque = library.get(casterRecipe(false));
  if (!opaque) return opaque.error();
  Result<const gpu::Pipeline*> mask = library.get(casterRecipe(true));
  if (!mask) return mask.error();
  return CasterPipelines{*opaque, *mask};
}

void recordCasters(PassContext& context, const FrameData& frame, const CasterPipelines& pipelines,
                   const glm::mat4& clipFromWorld) {
  const VkCommandBuffer commands = context.commands();
  bindBuffers(commands, *frame.resources);
  const gpu::Pipeline* bound = nullptr;
  std::uint32_t material = kNothing;
  for (const Draw& draw : frame.draws.solid) {
    if (!draw.casts || !mayBeSeen(draw.bounds, clipFromWorld, DepthPlanes::kClamped)) continue;
    const gpu::Pipeline* pipeline = draw.mask ? pipelines.mask : pipelines.opaque;
    if (pipeline != bound) {
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline->handle());
      vkCmdPushConstants(commands, pipeline->layout(), VK_SHADER_STAGE_ALL, 0, sizeof(glm::mat4), &clipFromWorld);
      gpu::Descriptors(commands, *pipeline)
          .storageBuffer(0, frame.instanceBlocks.buffer, frame.instanceBlocks.offset, frame.instanceBlocks.size)
          .push();
      bound = pipeline;
      material = kNothing;
    }
    if (draw.mask && draw.range.material != material) {
      material = draw.range.material;
      const TextureBinding& alpha = frame.resources->materials[material].alpha;
      gpu::Descriptors descriptors(commands, *pipeline);
      bindMaterialBlock(descriptors, 1, frame, material);
      descriptors.sampled(2, alpha.view, alpha.sampler).push();
    }
    drawOne(commands, draw);
  }
}

}  // namespace tyndall::render
