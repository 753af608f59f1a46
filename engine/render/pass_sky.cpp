// Draws the sky's maps and binds them.
#include "draw_record.hpp"
#include "passes.hpp"
#include "sky_maps.hpp"

namespace tyndall::render {

namespace {

gpu::ViewDesc layerView(std::uint32_t layer) {
  gpu::ViewDesc view;
  view.baseLayer = layer;
  view.layerCount = 1;
  view.array = true;
  return view;
}

}  // namespace

Result<void> addSkyPasses(Graph& graph, const PassTools& tools, const std::shared_ptr<FrameData>& frame) {
  const std::shared_ptr<const SkyFrame> sky = frame->sky;
  if (!sky->kept) return {};
  constexpr VkImageLayout kRead = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  const ImageRef maps = graph.import(sky->kept->image, sky->kept->drawn ? kRead : VK_IMAGE_LAYOUT_UNDEFINED, kRead);
  frame->skyMaps = maps;
  if (sky->drawn.empty()) return {};
  const Result<CasterPipelines> casters = casterPipelines(tools.pipelines);
  if (!casters) return casters.error();
  const Result<const gpu::Pipeline*> spread = tools.pipelines.get(skySpreadRecipe());
  if (!spread) return spread.error();

  gpu::ImageDesc desc;
  desc.name = "sky depths";
  desc.format = kDepthFormat;
  desc.width = desc.height = shared::kSkyTexels;
  desc.layers = static_cast<std::uint32_t>(sky->drawn.size());
  const ImageRef depths = graph.image(desc);
  graph.pass("sky maps")
      .use(depths, Use::kDepthWrite)
      .run([frame = FramePointer(frame), casters = *casters, depths](PassContext& context) {
        for (std::uint32_t i = 0; i < frame->sky->drawn.size(); ++i) {
          PassContext::DepthAttachment depth{depths, true, 1.0f};
          depth.view.baseLayer = i;
          depth.view.layerCount = 1;
          context.beginRendering({}, &depth);
          recordCasters(context, *frame, casters, clipFromWorld(frame->sky->drawn[i].second.map));
          context.endRendering();
        }
      });
  graph.pass("sky maps spread")
      .use(depths, Use::kSampledCompute)
      .use(maps, sky->kept->drawn ? Use::kStorageReadWriteCompute : Use::kStorageWriteCompute)
      .run([sky, &pipeline = **spread, depths, maps, texel = tools.samplers.texel](PassContext& context) {
        const VkCommandBuffer commands = context.commands();
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle());
        for (std::uint32_t i = 0; i < sky->drawn.size(); ++i) {
          gpu::Descriptors(commands, pipeline)
              .sampled(0, context.view(depths, layerView(i)), texel)
              .storageImage(1, context.view(maps, layerView(sky->drawn[i].first)))
              .push();
          vkCmdDispatch(commands, shared::kSkyTexels / 8, shared::kSkyTexels / 8, 1);
        }
        for (const auto& [layer, shown] : sky->drawn) sky->kept->layers[layer] = shown;
        sky->kept->drawn = true;
      });
  return {};
}

void bindSky(PassContext& context, const PassTools& tools, const FrameData& frame, gpu::Descriptors& descriptors,
             std::uint32_t block, std::uint32_t maps) {
  const BlockRange& range = frame.skyBlock;
  gpu::ViewDesc array;
  array.array = true;
  descriptors.uniformBuffer(block, range.buffer, range.offset, range.size)
      .sampled(maps, frame.skyMaps ? context.view(frame.skyMaps, array) : tools.unusedMap, tools.samplers.texel);
}

}  // namespace tyndall::render
