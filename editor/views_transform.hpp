// Where an image lies in its window: zoom and pan. Points are the window's units, texels the image's; both from the
// upper left corner.
#pragma once

#include <algorithm>

#include <glm/glm.hpp>

namespace tyndall::editor {

class ViewTransform {
 public:
  static constexpr float kLeastScale = 1.0f / 64, kMostScale = 128;  ///< points per texel

  glm::vec2 pointOf(glm::vec2 texel) const { return origin_ + texel * scale_; }
  glm::vec2 texelAt(glm::vec2 point) const { return (point - origin_) / scale_; }
  float scale() const { return scale_; }

  void pan(glm::vec2 points) { origin_ += points; }
  /// The texel under `point` stays there.
  void zoomAbout(glm::vec2 point, float factor) {
    const glm::vec2 texel = texelAt(point);
    scale_ = std::clamp(scale_ * factor, kLeastScale, kMostScale);
    origin_ = point - texel * scale_;
  }
  /// All of the image, as large as the window holds it, in its middle.
  void fit(glm::vec2 image, glm::vec2 window) {
    place(image, window, std::min(window.x / image.x, window.y / image.y));
  }
  /// One texel a point, the middle of the image in the window's middle.
  void oneToOne(glm::vec2 image, glm::vec2 window) { place(image, window, 1); }

 private:
  void place(glm::vec2 image, glm::vec2 window, float scale) {
    scale_ = std::clamp(scale, kLeastScale, kMostScale);
    origin_ = 0.5f * (window - image * scale_);
  }
  glm::vec2 origin_{0};  ///< point of texel coordinate (0, 0)
  float scale_ = 1;
};

}  // namespace tyndall::editor
