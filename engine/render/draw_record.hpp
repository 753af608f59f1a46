// Records draws of geometry: binding state only where it changes.
#pragma once

#include <array>

#include "frame_data.hpp"
#include "render/graph.hpp"

namespace tyndall::render {

struct GeometryPipelines {
  std::array<const gpu::Pipeline*, 3> opaque{}, mask{};  ///< by Facing
};
/// The solid draws that the camera may see.
void recordSolid(PassContext& context, const FrameData& frame, const GeometryPipelines& pipelines);

struct CasterPipelines { const gpu::Pipeline* opaque = nullptr; const gpu::Pipeline* mask = nullptr; };
/// The solid draws that may fall into the map of `clipFromWorld` (depth clamped).
void recordCasters(PassContext& context, const FrameData& frame, const CasterPipelines& pipelines, const glm::mat4& clipFromWorld);

/// The blended draws that the camera may see, back to front. `bindLights` is called after each change of pipeline.
void recordBlended(PassContext& context, const FrameData& frame, const std::array<const gpu::Pipeline*, 3>& pipelines,
                   const std::function<void(const gpu::Pipeline&)>& bindLights);
bool anyBlendedVisible(const FrameData& frame);

}  // namespace tyndall::render
