#include "base/assert.hpp"
#include "passes.hpp"

namespace tyndall::render {

Result<ImageRef> addCompositePass(Graph& graph, const PassTools& tools, ImageRef color, ImageRef scatter,
                                  float exposure, const gpu::Buffer& meter, bool metered) {
  Result<const gpu::Pipeline*> pipeline = tools.pipelines.get(compositeRecipe(static_cast<bool>(scatter), metered));
  if (!pipeline) return pipeline.error();
  const gpu::ImageDesc& size = graph.desc(color);
  TY_ASSERT(!scatter || (graph.desc(scatter).width == size.width && graph.desc(scatter).height == size.height),
            "the effect's image is not of the view's size");
  const ImageRef picture = viewImage(graph, "picture", kPictureFormat, size.width, size.height);
  Graph::Pass pass = graph.pass("composite");
  pass.use(color, Use::kSampledGraphics).use(picture, Use::kColorWrite);
  if (scatter) pass.use(scatter, Use::kSampledGraphics);
  // Bound in either case: a picture of fixed exposure is measured as well where somebody asks.
  pass.use(graph.import(meter), Use::kSampledGraphics);
  const ImageRef second = scatter ? scatter : color;  // bound but not read without scatter
  pass.run([=, &meter, &use = **pipeline, texel = tools.samplers.texel](PassContext& context) {
    context.beginRendering({{picture}});
    gpu::Descriptors descriptors(context.commands(), use);
    descriptors.sampled(0, context.view(color), texel).sampled(1, context.view(second), texel);
    descriptors.storageBuffer(2, meter.handle());
    drawFullScreen(context.commands(), use, descriptors, exposure);
    context.endRendering();
  });
  return picture;
}

Result<ImageRef> addDistancePass(Graph& graph, const PassTools& tools, const View& view, ImageRef depth) {
  Result<const gpu::Pipeline*> pipeline = tools.pipelines.get(distanceRecipe());
  if (!pipeline) return pipeline.error();
  const ImageRef distance = viewImage(graph, "distance", kDistanceFormat, view.width, view.height);
  const DistancePush push{view.viewFromClip[0][0],
                          -view.viewFromClip[1][1],
                          static_cast<float>(view.width),
                          static_cast<float>(view.height),
                          view.znear,
                          view.zfar};
  graph.pass("distance")
      .use(depth, Use::kSampledGraphics)
      .use(distance, Use::kColorWrite)
      .run([=, &use = **pipeline, texel = tools.samplers.texel](PassContext& context) {
        context.beginRendering({{distance}});
        gpu::Descriptors descriptors(context.commands(), use);
        descriptors.sampled(0, context.view(depth), texel);
        drawFullScreen(context.commands(), use, descriptors, push);
        context.endRendering();
      });
  return distance;
}

Result<ImageRef> addDebugPass(Graph& graph, const PassTools& tools, const View& view, const Effect::DebugImage& shown) {
  const ImageRef picture = viewImage(graph, "debug view", kPictureFormat, view.width, view.height);
  if (!shown.image) {
    VkClearColorValue grey{{shown.low, shown.low, shown.low, 1}};
    graph.pass("debug view").use(picture, Use::kColorWrite).run([=](PassContext& context) {
      context.beginRendering({{picture, true, grey}});
      context.endRendering();
    });
    return picture;
  }
  TY_ASSERT(graph.desc(shown.image).type == VK_IMAGE_TYPE_2D, "'" + graph.desc(shown.image).name + "' is no 2D image");
  Result<const gpu::Pipeline*> pipeline = tools.pipelines.get(debugViewRecipe());
  if (!pipeline) return pipeline.error();
  gpu::ViewDesc part = shown.view;  // one mip of one layer
  part.mipCount = part.layerCount = 1;
  part.array = false;
  const DebugPush push{static_cast<float>(view.width), static_cast<float>(view.height), shown.channel, shown.low,
                       shown.high};
  graph.pass("debug view")
      .use(shown.image, Use::kSampledGraphics)
      .use(picture, Use::kColorWrite)
      .run([=, &use = **pipeline, source = shown.image, texel = tools.samplers.texel](PassContext& context) {
        context.beginRendering({{picture}});
        gpu::Descriptors descriptors(context.commands(), use);
        descriptors.sampled(0, context.view(source, part), texel);
        drawFullScreen(context.commands(), use, descriptors, push);
        context.endRendering();
      });
  return picture;
}

}  // namespace tyndall::render
