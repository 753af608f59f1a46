// The engine's own debug views.
#pragma once

#include <string>

#include "frame_data.hpp"
#include "passes.hpp"
#include "render/frame.hpp"

namespace tyndall::render {

bool isEngineDebugView(const std::string& name);
/// The image behind one of the engine's debug views; adds the distance pass where it is needed.
Result<Effect::DebugImage> engineDebugImage(Graph& graph, const PassTools& tools, const FrameData& frame,
                                            const std::string& name, ImageRef scatter, float exposure);

}  // namespace tyndall::render
