// Records draws of geometry: binding state only where it changes.
#pragma once

#include <functional>
#include <vector>

#include "frame_data.hpp"
#include "render/graph.hpp"

namespace tyndall::render {

/// Pipelines of a list of draws, one for each; equal recipes share one.
using DrawPipelines = std::vector<const gpu::Pipeline*>;
Result<DrawPipelines> pipelinesOf(PipelineLibrary& library, const std::vector<Draw>& draws,
                                  const std::function<Recipe(const Draw&)>& recipeOf);

/// Those of `draws` that the camera may see, in their order. `bindMore` is called after each change of pipeline.
void recordShaded(PassContext& context, const FrameData& frame, const std::vector<Draw>& draws,
                  const DrawPipelines& pipelines, const std::function<void(const gpu::Pipeline&)>& bindMore);

struct CasterPipelines {
  const gpu::Pipeline* opaque = nullptr;
  const gpu::Pipeline* mask = nullptr;
};
Result<CasterPipelines> casterPipelines(PipelineLibrary& library);
/// The solid draws that may fall into the map of `clipFromWorld` (depth clamped).
void recordCasters(PassContext& context, const FrameData& frame, const CasterPipelines& pipelines,
                   const glm::mat4& clipFromWorld);

}  // namespace tyndall::render
