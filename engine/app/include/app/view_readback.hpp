// Brings the numbers behind debug views to the host: those of the image itself, not of what is shown of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/session.hpp"
#include "image/image_io.hpp"

namespace tyndall::app {

/// Which part of a view's image is wanted: the view's own, or another layer or mip (taken to the nearest that there
/// is).
struct ViewRequest {
  std::string name;
  std::optional<std::uint32_t> layer{}, mip{};
  bool operator==(const ViewRequest&) const = default;
};

/// Values of one layer of one mip, row 0 on top: values[(y * width + x) * channels + c]. Unorm formats are from 0 to 1,
/// sRGB-coded ones decoded, as a shader reads them.
struct ViewPicture {
  std::string name;
  std::uint32_t width = 0, height = 0, channels = 0;  ///< 0 by 0: this frame has no image for the view
  std::vector<float> values;
  std::uint32_t layer = 0, mip = 0, layers = 1, mips = 1;
  std::string format;       ///< "RGBA16 unorm"
  std::uint32_t shown = 0;  ///< what the view shows: channel 0 to 3, or 4: the first three as a colour
  float low = 0, high = 1;  ///< values that the view shows as black and white
  float at(std::uint32_t x, std::uint32_t y, std::uint32_t c) const {
    return values[(std::size_t{y} * width + x) * channels + c];
  }
};

/// As an EXR can hold it: a second channel alone gets a third of zeros. Only of a picture with values.
image::FloatImage exrOf(const ViewPicture& picture);

class ViewReadback {
 public:
  /// Adds passes that copy the views. The frame must have been built with FrameRequest::views naming them in this
  /// order.
  Result<void> addPasses(Session& session, render::Graph& graph, const render::FrameOutput& output,
                         const std::vector<ViewRequest>& wanted);
  /// Valid when the frame is finished (Session::finishFrames).
  std::vector<ViewPicture> pictures() const;

 private:
  struct Copy {
    ViewPicture picture;  ///< without its values
    VkFormat format = VK_FORMAT_UNDEFINED;
    bool isNormal = false;
    gpu::Buffer buffer;
  };
  std::vector<Copy> copies_;
};

}  // namespace tyndall::app
