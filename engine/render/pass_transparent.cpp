#include <algorithm>

#include "culling.hpp"
#include "draw_record.hpp"
#include "passes.hpp"

namespace tyndall::render {

Result<void> addTransparentPass(Graph& graph, const PassTools& tools, const std::shared_ptr<FrameData>& frame) {
  const std::vector<Draw>& draws = frame->draws.blended;
  const bool visible = std::any_of(draws.begin(), draws.end(), [&](const Draw& draw) {
    return mayBeSeen(draw.bounds, frame->clipFromWorld, DepthPlanes::kBoth);
  });
  if (!visible) return {};
  const auto shadowed = static_cast<std::uint32_t>(frame->plan.shadowed.size());
  const std::uint32_t slots = std::min(kShadowSlots, shadowed);
  // The light array holds shadowed lights first: what follows the slots counts as unshadowed here.
  const UnshadowedLights others{slots, static_cast<std::uint32_t>(frame->plan.blocks.size()) - slots};
  if (shadowed > kShadowSlots) {
    frame->plan.notes.push_back("alpha-blended surfaces: shadowed by the " + std::to_string(kShadowSlots) +
                                " most important lights only, of " + std::to_string(shadowed) + " with shadow maps");
  }
  Result<DrawPipelines> pipelines = pipelinesOf(tools.pipelines, draws, [&](const Draw& draw) {
    return transparentRecipe(draw.facing, draw.textures, slots, frame->surfaceMaps, frame->cookies);
  });
  if (!pipelines) return pipelines.error();
  Graph::Pass pass = graph.pass("transparent");
  pass.use(frame->color, Use::kColorReadWrite).use(frame->depth, Use::kDepthRead);
  for (std::uint32_t i = 0; i < slots; ++i) pass.use(frame->surfaceMap(i), Use::kSampledGraphics);
  if (frame->skyMaps) pass.use(frame->skyMaps, Use::kSampledGraphics);
  pass.run([frame = FramePointer(frame), tools, pipelines = pipelines.take(), slots, others](PassContext& context) {
    PassContext::DepthAttachment depth{frame->depth};
    depth.readOnly = true;
    context.beginRendering({{frame->color}}, &depth);
    recordShaded(context, *frame, frame->draws.blended, pipelines, [&](const gpu::Pipeline& pipeline) {
      gpu::Descriptors descriptors(context.commands(), pipeline);
      bindLights(context, tools, *frame, descriptors, {9, 10, 14, 15}, 0, slots);
      bindSky(context, tools, *frame, descriptors, 16, 17);
      descriptors.push();
      vkCmdPushConstants(context.commands(), pipeline.layout(), VK_SHADER_STAGE_ALL, 0, sizeof(others), &others);
    });
    context.endRendering();
  });
  return {};
}

}  // namespace tyndall::render
