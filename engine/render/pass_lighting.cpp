#include <algorithm>

#include "passes.hpp"

namespace tyndall::render {

namespace {

void declare(Graph& graph, const PassTools& tools, FramePointer frame, const gpu::Pipeline& pipeline, const LightRange& range,
             const PixelRect& rect, bool base) {
  Graph::Pass pass = graph.pass(base ? "lighting" : "lighting " + std::to_string(range.firstShadowed / kShadowSlots));
  for (const ImageRef image : {frame->base, frame->normal, frame->emissive, frame->depth}) pass.use(image, Use::kSampledGraphics);
  for (std::uint32_t i = 0; i < range.shadowedCount; ++i) {
    pass.use(frame->shadowMaps[range.firstShadowed + i], Use::kSampledGraphics);
  }
  pass.use(frame->color, base ? Use::kColorWrite : Use::kColorReadWrite);
  pass.run([frame, tools, &pipeline, range, rect](PassContext& context) {
    const VkCommandBuffer commands = context.commands();
    context.beginRendering({{frame->color}});
    const VkRect2D scissor{{rect.x0, rect.y0},
                           {static_cast<std::uint32_t>(rect.x1 - rect.x0), static_cast<std::uint32_t>(rect.y1 - rect.y0)}};
    vkCmdSetScissor(commands, 0, 1, &scissor);
    gpu::Descriptors descriptors(commands, pipeline);
    const VkSampler texel = tools.samplers.texel;
    descriptors.uniformBuffer(0, frame->viewBlock.buffer, frame->viewBlock.offset, frame->viewBlock.size)
        .storageBuffer(1, frame->lightBlocks.buffer, frame->lightBlocks.offset, frame->lightBlocks.size)
        .sampled(2, context.view(frame->base), texel)
        .sampled(3, context.view(frame->normal), texel)
        .sampled(4, context.view(frame->emissive), texel)
        .sampled(5, context.view(frame->depth), texel);
    bindShadowMaps(context, tools, *frame, descriptors, 6, range.firstShadowed, range.shadowedCount);
    drawFullScreen(commands, pipeline, descriptors, range);
    context.endRendering();
  });
}

}  // namespace

Result<void> addLightingPasses(Graph& graph, const PassTools& tools, const std::shared_ptr<FrameData>& frame,
                               const std::vector<scene::LightView>& lights) {
  const View& view = frame->view;
  frame->color = viewImage(graph, "radiance", kColorFormat, view.width, view.height);
  const auto shadowed = static_cast<std::uint32_t>(frame->plan.shadowed.size());
  std::uint32_t first = 0;
  do {
    const bool base = first == 0;
    LightRange range;
    range.firstShadowed = first;
    range.shadowedCount = std::min(kShadowSlots, shadowed - first);
    range.firstUnshadowed = shadowed;
    range.unshadowedCount = base ? static_cast<std::uint32_t>(frame->plan.unshadowed.size()) : 0;
    PixelRect rect{0, 0, static_cast<std::int32_t>(view.width), static_cast<std::int32_t>(view.height)};
    if (!base) {
      rect = {};
      for (std::uint32_t i = 0; i < range.shadowedCount; ++i) rect.add(reach(view, lights[frame->plan.shadowed[first + i].source]));
    }
    first += kShadowSlots;
    if (rect.empty()) continue;
    Result<const gpu::Pipeline*> pipeline = tools.pipelines.get(lightingRecipe(base, range.shadowedCount));
    if (!pipeline) return pipeline.error();
    declare(graph, tools, frame, **pipeline, range, rect, base);
  } while (first < shadowed);
  return {};
}

}  // namespace tyndall::render
