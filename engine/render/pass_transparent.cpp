#include <algorithm>

#include "draw_record.hpp"
#include "passes.hpp"

namespace tyndall::render {

Result<void> addTransparentPass(Graph& graph, const PassTools& tools, const std::shared_ptr<FrameData>& frame) {
  if (!anyBlendedVisible(*frame)) return {};
  const auto shadowed = static_cast<std::uint32_t>(frame->plan.shadowed.size());
  LightRange range;
  range.shadowedCount = std::min(kShadowSlots, shadowed);
  // The shaders' array holds shadowed lights first: what follows the slots counts as unshadowed here.
  range.firstUnshadowed = range.shadowedCount;
  range.unshadowedCount = static_cast<std::uint32_t>(frame->plan.blocks.size()) - range.shadowedCount;
  if (shadowed > kShadowSlots) {
    frame->plan.notes.push_back("alpha-blended surfaces: shadowed by the " + std::to_string(kShadowSlots) +
                                " most important lights only, of " + std::to_string(shadowed) + " with shadow maps");
  }
  std::array<const gpu::Pipeline*, 3> pipelines{};
  for (const Facing facing : {Facing::kFront, Facing::kFrontMirrored, Facing::kBoth}) {
    Result<const gpu::Pipeline*> made = tools.pipelines.get(transparentRecipe(facing, range.shadowedCount));
    if (!made) return made.error();
    pipelines[static_cast<std::size_t>(facing)] = *made;
  }
  Graph::Pass pass = graph.pass("transparent");
  pass.use(frame->color, Use::kColorReadWrite).use(frame->depth, Use::kDepthRead);
  for (std::uint32_t i = 0; i < range.shadowedCount; ++i) pass.use(frame->shadowMaps[i], Use::kSampledGraphics);
  pass.run([frame = FramePointer(frame), tools, pipelines, range](PassContext& context) {
    PassContext::DepthAttachment depth{frame->depth};
    depth.readOnly = true;
    context.beginRendering({{frame->color}}, &depth);
    recordBlended(context, *frame, pipelines, [&](const gpu::Pipeline& pipeline) {
      gpu::Descriptors descriptors(context.commands(), pipeline);
      descriptors.storageBuffer(9, frame->lightBlocks.buffer, frame->lightBlocks.offset, frame->lightBlocks.size);
      bindShadowMaps(context, tools, *frame, descriptors, 10, 0, range.shadowedCount);
      descriptors.push();
      vkCmdPushConstants(context.commands(), pipeline.layout(), VK_SHADER_STAGE_ALL, 0, sizeof(range), &range);
    });
    context.endRendering();
  });
  return {};
}

}  // namespace tyndall::render
