#include <algorithm>

#include "passes.hpp"

namespace tyndall::render {

namespace {

// The lights of one pass and the pixels they reach.
struct Batch {
  std::uint32_t firstShadowed = 0, shadowedCount = 0;
  UnshadowedLights unshadowed;
  PixelRect rect;
  bool base() const { return firstShadowed == 0; }
};

void declare(Graph& graph, const PassTools& tools, FramePointer frame, const gpu::Pipeline& pipeline,
             const Batch& batch) {
  Graph::Pass pass =
      graph.pass(batch.base() ? "lighting" : "lighting " + std::to_string(batch.firstShadowed / kShadowSlots));
  for (const ImageRef image : {frame->base, frame->normal, frame->emissive, frame->depth})
    pass.use(image, Use::kSampledGraphics);
  for (std::uint32_t i = 0; i < batch.shadowedCount; ++i) {
    pass.use(frame->surfaceMap(batch.firstShadowed + i), Use::kSampledGraphics);
  }
  if (frame->skyMaps) pass.use(frame->skyMaps, Use::kSampledGraphics);
  pass.use(frame->color, batch.base() ? Use::kColorWrite : Use::kColorReadWrite);
  pass.run([frame, tools, &pipeline, batch](PassContext& context) {
    const VkCommandBuffer commands = context.commands();
    context.beginRendering({{frame->color}});
    const PixelRect& r = batch.rect;
    const VkRect2D scissor{{r.x0, r.y0},
                           {static_cast<std::uint32_t>(r.x1 - r.x0), static_cast<std::uint32_t>(r.y1 - r.y0)}};
    vkCmdSetScissor(commands, 0, 1, &scissor);
    gpu::Descriptors descriptors(commands, pipeline);
    const VkSampler texel = tools.samplers.texel;
    descriptors.uniformBuffer(0, frame->viewBlock.buffer, frame->viewBlock.offset, frame->viewBlock.size)
        .sampled(2, context.view(frame->base), texel)
        .sampled(3, context.view(frame->normal), texel)
        .sampled(4, context.view(frame->emissive), texel)
        .sampled(5, context.view(frame->depth), texel);
    bindLights(context, tools, *frame, descriptors, {1, 6, 10, 11}, batch.firstShadowed, batch.shadowedCount);
    bindSky(context, tools, *frame, descriptors, 12, 13);
    drawFullScreen(commands, pipeline, descriptors, batch.unshadowed);
    context.endRendering();
  });
}

}  // namespace

Result<void> addLightingPasses(Graph& graph, const PassTools& tools, const std::shared_ptr<FrameData>& frame,
                               const std::vector<scene::LightView>& lights) {
  const View& view = frame->view;
  frame->color = viewImage(graph, "radiance", kColorFormat, view.width, view.height);
  const auto shadowed = static_cast<std::uint32_t>(frame->plan.shadowed.size());
  const PixelRect whole{0, 0, static_cast<std::int32_t>(view.width), static_cast<std::int32_t>(view.height)};
  // One pass even without any light: it writes the sky.
  for (std::uint32_t first = 0; first == 0 || first < shadowed; first += kShadowSlots) {
    Batch batch;
    batch.firstShadowed = first;
    batch.shadowedCount = std::min(kShadowSlots, shadowed - first);
    batch.unshadowed = {shadowed, batch.base() ? static_cast<std::uint32_t>(frame->plan.unshadowed.size()) : 0u};
    if (batch.base()) {
      batch.rect = whole;
    } else {
      for (std::uint32_t i = first; i < first + batch.shadowedCount; ++i) {
        batch.rect.add(reach(view, lights[frame->plan.shadowed[i].source]));
      }
    }
    if (batch.rect.empty()) continue;
    Result<const gpu::Pipeline*> pipeline =
        tools.pipelines.get(lightingRecipe(batch.base(), batch.shadowedCount, frame->surfaceMaps, frame->cookies));
    if (!pipeline) return pipeline.error();
    declare(graph, tools, frame, **pipeline, batch);
  }
  return {};
}

}  // namespace tyndall::render
