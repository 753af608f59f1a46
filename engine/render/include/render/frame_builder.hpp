// Pipelines of the engine's own for other frame settings, made beside the frames.
#pragma once

#include <filesystem>
#include <memory>

#include "render/frame.hpp"

namespace tyndall::render {

/// Draws one tiny frame with the settings to come on a device and a thread of its own, with every material of the level
/// on one triangle. From it come the pipelines that the settings need, which are then made on the renderer's device,
/// and, where a driver compiles at the first draw (llvmpipe), their code, which reaches that device through the
/// driver's cache on disk. What is not foreseen so is compiled in a frame, as without this. Called by the thread that
/// owns the device.
class FrameBuilder {
 public:
  /// `shaderFolder`: as the renderer's.
  FrameBuilder(gpu::Device& device, Renderer& renderer, const std::filesystem::path& shaderFolder);
  ~FrameBuilder();  ///< waits for the frame that is being drawn

  /// Begins what `settings` need for frames like `frame`, in place of what was begun before.
  void start(const Renderer::Input& frame, const FrameSettings& settings);
  void cancel();
  bool done() const;  ///< everything that was started is there; finish() hands it over
  /// The renderer has the pipelines from here on.
  void finish();

  struct State;

 private:
  std::unique_ptr<State> state_;
};

}  // namespace tyndall::render
