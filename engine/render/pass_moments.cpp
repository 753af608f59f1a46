// Four-moment shadow maps: for each light's depth map, the filtered moments of its depth with all mips.
#include <bit>

#include "passes.hpp"

namespace tyndall::render {

namespace {

// Texels that one workgroup of moments_blur.comp makes along its direction and across, and of moments_mip.comp.
constexpr std::uint32_t kGroup = 8, kRun = 4;

std::uint32_t groups(std::uint32_t texels, std::uint32_t each) { return (texels + each - 1) / each; }

gpu::ViewDesc mipView(std::uint32_t mip) {
  gpu::ViewDesc view;
  view.baseMip = mip;
  view.mipCount = 1;
  view.array = true;
  return view;
}

struct MomentPipelines {
  const gpu::Pipeline* rows = nullptr;
  const gpu::Pipeline* columns = nullptr;
  const gpu::Pipeline* mip = nullptr;
};

void addBlur(Graph& graph, const PassTools& tools, const gpu::Pipeline& pipeline, bool rows, const std::string& name,
             ImageRef from, ImageRef to, float depthCurve) {
  graph.pass(name)
      .use(from, Use::kSampledCompute)
      .use(to, Use::kStorageWriteCompute)
      .run([=, &pipeline, texel = tools.samplers.texel](PassContext& context) {
        const VkCommandBuffer commands = context.commands();
        const gpu::ImageDesc& desc = context.desc(to);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle());
        gpu::Descriptors(commands, pipeline)
            .sampled(0, context.view(from, mipView(0)), texel)
            .storageImage(1, context.view(to, mipView(0)))
            .push();
        vkCmdPushConstants(commands, pipeline.layout(), VK_SHADER_STAGE_ALL, 0, sizeof depthCurve, &depthCurve);
        vkCmdDispatch(commands, groups(desc.width, rows ? kGroup * kRun : kGroup),
                      groups(desc.height, rows ? kGroup : kGroup * kRun), desc.layers);
      });
}

// All levels in one pass: a dozen timers of a few microseconds each would tell nothing.
void addMips(Graph& graph, const PassTools& tools, const gpu::Pipeline& pipeline, const std::string& name,
             ImageRef image) {
  graph.pass(name)
      .use(image, Use::kSampledStorageCompute)
      .run([=, &pipeline, linear = tools.samplers.linear](PassContext& context) {
        const VkCommandBuffer commands = context.commands();
        const gpu::ImageDesc& desc = context.desc(image);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle());
        for (std::uint32_t mip = 1; mip < desc.mips; ++mip) {
          VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
          barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
          barrier.srcAccessMask = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
          barrier.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
          VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
          dependency.memoryBarrierCount = 1;
          dependency.pMemoryBarriers = &barrier;
          vkCmdPipelineBarrier2(commands, &dependency);
          gpu::Descriptors(commands, pipeline)
              .sampled(0, context.view(image, mipView(mip - 1)), linear, VK_IMAGE_LAYOUT_GENERAL)
              .storageImage(1, context.view(image, mipView(mip)))
              .push();
          vkCmdDispatch(commands, groups(std::max(desc.width >> mip, 1u), kGroup),
                        groups(std::max(desc.height >> mip, 1u), kGroup), desc.layers);
        }
      });
}

Result<MomentPipelines> pipelinesFor(PipelineLibrary& library, VkFormat format) {
  MomentPipelines made;
  const std::pair<const gpu::Pipeline**, ComputeRecipe> wanted[] = {{&made.rows, momentBlurRecipe(true, format)},
                                                                    {&made.columns, momentBlurRecipe(false, format)},
                                                                    {&made.mip, momentMipRecipe()}};
  for (const auto& [to, recipe] : wanted) {
    const Result<const gpu::Pipeline*> pipeline = library.get(recipe);
    if (!pipeline) return pipeline.error();
    *to = *pipeline;
  }
  return made;
}

}  // namespace

Result<ImageRef> addMomentPasses(Graph& graph, const PassTools& tools, const FrameData& frame,
                                 const PlannedLight& light, ImageRef shadowMap) {
  const Result<MomentPipelines> pipelines = pipelinesFor(tools.pipelines, frame.momentFormat);
  if (!pipelines) return pipelines.error();
  const std::string number = std::to_string(light.source);
  gpu::ImageDesc desc = graph.desc(shadowMap);
  desc.name = "row moments of light " + number;
  desc.format = frame.momentFormat;
  desc.usage = 0;
  const ImageRef rows = graph.image(desc);
  desc.name = "shadow moments of light " + number;
  desc.mips = static_cast<std::uint32_t>(std::bit_width(desc.width));
  const ImageRef moments = graph.image(desc);
  const float curve = light.fit.depthCurve;
  addBlur(graph, tools, *pipelines->rows, true, "moments blur x " + number, shadowMap, rows, curve);
  addBlur(graph, tools, *pipelines->columns, false, "moments blur y " + number, rows, moments, curve);
  if (desc.mips > 1) addMips(graph, tools, *pipelines->mip, "moments mips " + number, moments);
  return moments;
}

}  // namespace tyndall::render
