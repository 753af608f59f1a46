#include "draw_record.hpp"
#include "passes.hpp"

namespace tyndall::render {

ImageRef viewImage(Graph& graph, const std::string& name, VkFormat format, std::uint32_t width, std::uint32_t height) {
  gpu::ImageDesc desc;
  desc.name = name;
  desc.format = format;
  desc.width = width;
  desc.height = height;
  return graph.image(desc);
}

Result<void> addGBufferPass(Graph& graph, const PassTools& tools, const std::shared_ptr<FrameData>& frame, bool clear) {
  Result<DrawPipelines> pipelines = pipelinesOf(tools.pipelines, frame->draws.solid, [](const Draw& draw) {
    return gbufferRecipe(draw.facing, draw.mask, draw.textures);
  });
  if (!pipelines) return pipelines.error();
  const View& view = frame->view;
  frame->base = viewImage(graph, "base colour", kBaseFormat, view.width, view.height);
  frame->normal = viewImage(graph, "normal", kNormalFormat, view.width, view.height);
  frame->emissive = viewImage(graph, "emissive", kEmissiveFormat, view.width, view.height);
  frame->depth = viewImage(graph, "depth", kDepthFormat, view.width, view.height);
  graph.pass("G-buffer")
      .use(frame->base, Use::kColorWrite)
      .use(frame->normal, Use::kColorWrite)
      .use(frame->emissive, Use::kColorWrite)
      .use(frame->depth, Use::kDepthWrite)
      .run([frame = FramePointer(frame), pipelines = pipelines.take(), clear](PassContext& context) {
        const PassContext::DepthAttachment depth{frame->depth, true, 0.0f};
        context.beginRendering({{frame->base, clear}, {frame->normal, clear}, {frame->emissive, clear}}, &depth);
        recordShaded(context, *frame, frame->draws.solid, pipelines, {});
        context.endRendering();
      });
  return {};
}

}  // namespace tyndall::render
