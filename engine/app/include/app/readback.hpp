// Brings a frame's results to the host. One object per size; the buffers are reused from frame to frame.
#pragma once

#include <memory>

#include "app/session.hpp"
#include "image/image_io.hpp"

namespace tyndall::app {

struct ReadbackWants {
  bool picture = true, scatter = false, distance = false;
};

class Readback {
 public:
  /// Owner of the passes that copy; they are no part of the frame and are left out of reported times.
  static constexpr const char* kOwner = "readback";

  /// Adds passes that copy what is wanted into host memory. `request` is the one the frame was built with.
  Result<void> addPasses(Session& session, render::Graph& graph, const render::FrameOutput& output,
                         const FrameRequest& request, const ReadbackWants& wants);

  /// Valid when the frame is finished (Session::finishFrames).
  image::ByteImage picture() const;    ///< RGB
  image::FloatImage scatter() const;   ///< RGBA; 0,0,0,1 everywhere when the effect had nothing to do
  image::FloatImage distance() const;  ///< metres along the ray

 private:
  Result<void> copy(Session& session, render::Graph& graph, const char* name, render::ImageRef image,
                    std::uint64_t texelBytes, gpu::Buffer& buffer);
  std::uint32_t width_ = 0, height_ = 0;
  bool scatterIsEmpty_ = false;
  gpu::Buffer picture_, scatter_, distance_;
};

}  // namespace tyndall::app
