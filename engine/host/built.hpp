// A layout made real, and one frame's passes of it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pipelines.hpp"
#include "resources.hpp"
#include "structure.hpp"
#include "uniforms.hpp"

namespace tyndall::host {

/// Shared with the passes of graphs that are not recorded yet.
struct Built {
  TyInstance* instance = nullptr;  ///< whose last layout() this is made from, and which prepares its frames
  Structure structure;
  Layout layout;
  std::vector<PassRun> runs;
  std::vector<std::vector<PassUse>> uses;  ///< of each pass of the layout
  std::vector<std::uint64_t> moved;        ///< bytesMoved() by each pass
  std::vector<PipelinePtr> pipelines;      ///< of each pass
  Resources resources;
  UniformRing uniforms;

  std::uint64_t outputBytes() const { return std::uint64_t{structure.width} * structure.height * 16; }
};

/// The graph's names for a layout's resources in one frame.
struct FrameRefs {
  std::vector<render::ImageRef> images;
  std::vector<render::BufferRef> buffers;
  std::vector<bool> imageHasContents;  ///< false: no pass of this frame writes it
  render::ImageRef output, depth;
  std::vector<render::ImageRef> shadowMaps;     ///< of each light
  std::vector<render::ImageRef> shadowMoments;  ///< the same; empty refs where the renderer makes none
  std::vector<render::ImageRef> cookies;        ///< the same; empty refs where the renderer offers none
  std::vector<gpu::ViewDesc> cookieViews;       ///< each light's layers
  /// Which of the layout's runs the graph recorded: it drops those whose results nobody reads. Filled while it records.
  std::shared_ptr<std::vector<bool>> recorded;
  std::shared_ptr<std::vector<bool>> idle;  ///< those that the plugin skipped: recorded, but with nothing to do
};

/// Memory of what the recorded passes of a frame used, each image and buffer on its own, history always.
std::uint64_t bytesUsed(const Built& built, const FrameRefs& refs);

/// The same of each light's own passes, without the output. Lights take turns in the same memory, so that these do not
/// add up to bytesUsed.
std::vector<std::uint64_t> bytesOfLights(const Built& built, const FrameRefs& refs);

/// What the recorded passes of a frame move, each part of what they are bound to once a pass and direction. Nothing
/// where several lights take turns: each then uses as much of the shared images as it needs, which the host does not
/// know.
std::optional<std::uint64_t> bytesMoved(const Built& built, const FrameRefs& refs);

/// Declares all passes of one frame. Passes are named "name", or "name [light 2]" where they repeat per light.
std::shared_ptr<const FrameRefs> addFramePasses(const render::EffectInput& input, const std::shared_ptr<Built>& built,
                                                const std::string& owner, std::uint32_t slot);

/// Whether the graph's pass `graphName` is (one light's run of) the layout's pass `name`.
bool isRunOf(const std::string& graphName, const std::string& name);

}  // namespace tyndall::host
