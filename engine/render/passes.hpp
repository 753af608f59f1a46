// The passes of the deferred frame, one function each. They declare into the graph and record later.
#pragma once

#include <string>

#include "base/result.hpp"
#include "frame_data.hpp"
#include "pipeline_library.hpp"
#include "render/frame.hpp"
#include "render/graph.hpp"
#include "shadow_cache.hpp"

namespace tyndall::render {

/// What passes need besides the frame.
struct PassTools {
  PipelineLibrary& pipelines;
  FrameSamplers samplers;
  VkImageView unusedMap = VK_NULL_HANDLE;  ///< a white 1x1 array view for shadow slots without a light, and for cookies
};

/// One pass per light with a map (all faces), clearing it and drawing the casters, and those of its moment map. Fills
/// frame.shadowMaps and frame.momentMaps. With a `cache`, maps live there, and those that show what they should already
/// are not drawn.
Result<void> addShadowPasses(Graph& graph, const PassTools& tools, const std::shared_ptr<FrameData>& frame,
                             const std::vector<scene::LightView>& lights, ShadowCache* cache);

/// Passes that make a light's four-moment shadow map: its Gaussian along rows and columns, then its mips. The graph
/// drops them where nobody reads the result. frame.momentFormat must be set.
Result<ImageRef> addMomentPasses(Graph& graph, const PassTools& tools, const FrameData& frame,
                                 const PlannedLight& light, ImageRef shadowMap);

/// Draws what frame.sky wants drawn, and imports the maps as frame.skyMaps.
Result<void> addSkyPasses(Graph& graph, const PassTools& tools, const std::shared_ptr<FrameData>& frame);
/// Binds the sky's block and maps (white where there are none).
void bindSky(PassContext& context, const PassTools& tools, const FrameData& frame, gpu::Descriptors& descriptors,
             std::uint32_t block, std::uint32_t maps);

/// Base colour, normal, emission, depth. `clear`: texels that nothing covers are 0 instead of undefined (debug views).
Result<void> addGBufferPass(Graph& graph, const PassTools& tools, const std::shared_ptr<FrameData>& frame, bool clear);

/// Radiance of sky and opaque surfaces: one pass for up to four shadowed lights and everything else, one more for each
/// further four shadowed lights, limited to the pixels that their ranges reach. (Lights without a range reach all.)
Result<void> addLightingPasses(Graph& graph, const PassTools& tools, const std::shared_ptr<FrameData>& frame,
                               const std::vector<scene::LightView>& lights);

/// Alpha-blended surfaces over frame.color, back to front per primitive, before the effect's composition: they get the
/// fog of the opaque surface behind them. The four most important lights shadow them.
Result<void> addTransparentPass(Graph& graph, const PassTools& tools, const std::shared_ptr<FrameData>& frame);

/// picture = toneMap(exposure * (color * T + scatter)); an empty `scatter` stands for scatter 0 and T 1. With
/// `metered`, the exposure is a factor on what ExposureMeter has found in this frame.
Result<ImageRef> addCompositePass(Graph& graph, const PassTools& tools, ImageRef color, ImageRef scatter,
                                  float exposure, const gpu::Buffer& meter, bool metered);

Result<ImageRef> addDistancePass(Graph& graph, const PassTools& tools, const View& view, ImageRef depth);

/// An image shown instead of the picture; an empty one is shown as the grey value `low`.
Result<ImageRef> addDebugPass(Graph& graph, const PassTools& tools, const View& view, const Effect::DebugImage& shown);

/// The one triangle of fullscreen.vert, inside a rendering, with `push` as push constants.
template <class Push>
void drawFullScreen(VkCommandBuffer commands, const gpu::Pipeline& pipeline, gpu::Descriptors& descriptors,
                    const Push& push) {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.handle());
  descriptors.push();
  vkCmdPushConstants(commands, pipeline.layout(), VK_SHADER_STAGE_ALL, 0, sizeof(Push), &push);
  vkCmdDraw(commands, 3, 1, 0, 0);
}

/// A transient image of the view's size.
ImageRef viewImage(Graph& graph, const std::string& name, VkFormat format, std::uint32_t width, std::uint32_t height);

/// Binding numbers of what lights.glsl reads: the block of shadowed lights, the first shadow map, the array of all
/// lights, their cookies.
struct LightBindings {
  std::uint32_t shadowed, firstMap, all, cookies;
};
/// Binds lights [first, first + count) of plan.shadowed with their maps (`first` a multiple of kShadowSlots; slots
/// without a light get a stand-in), the array of all lights and their cookies.
void bindLights(PassContext& context, const PassTools& tools, const FrameData& frame, gpu::Descriptors& descriptors,
                const LightBindings& bindings, std::uint32_t first, std::uint32_t count);

}  // namespace tyndall::render
