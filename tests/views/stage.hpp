// A session with a level, and one frame's views.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/readback.hpp"
#include "app/session.hpp"
#include "app/view_readback.hpp"

namespace tyndall::views {

struct Taken {
  std::vector<app::ViewPicture> views;
  image::FloatImage scatter, distance;
  image::ByteImage picture;
};

class Stage : public ::testing::Test {
 protected:
  /// Opens the level; false (and a failure) when that is not possible.
  bool open(const std::string& level, std::uint32_t camera, const std::vector<std::string>& settings);
  void set(const std::vector<std::string>& settings);
  /// Renders one frame; `shown` is the debug view in the place of the picture.
  Taken take(std::uint32_t width, std::uint32_t height, const std::vector<app::ViewRequest>& views,
             const std::string& shown = "");
  /// Name of the view with a role in the present layout; "" if there is none.
  std::string viewOf(render::ViewRole role) const;

  std::unique_ptr<app::Session> session_;
  scene::CameraView camera_;
};

}  // namespace tyndall::views
