// Pictures while they are being painted: floats, colours sRGB-coded as in the file, row 0 on top.
#pragma once

#include <functional>
#include <string>

#include "scene/scene.hpp"

namespace tyndall::levels {

/// A surface's texel: what all of a material's images are made from.
struct Texel {
  glm::vec3 color{1};  ///< sRGB-coded
  float height = 0;    ///< in texel widths: a step of 1 between neighbours is a slope of 45 degrees
  float roughness = 1;
};

/// A tileable material: base colour, normals from the heights (which must tile too) and roughness.
struct Surface {
  int width = 0, height = 0;
  std::vector<Texel> texels;
  Surface(int w, int h, const std::function<Texel(glm::vec2 uv)>& paint);

  scene::Image colorImage(const std::string& name) const;
  scene::Image normalImage(const std::string& name) const;
  /// glTF's metallic-roughness: G roughness, B metallic (0).
  scene::Image roughnessImage(const std::string& name) const;
};

/// A cut-out picture: premultiplied while painting, four samples a side for smooth edges.
class Cutout {
 public:
  Cutout(int width, int height)
      : width_(width), height_(height), rgba_(static_cast<std::size_t>(width) * height, glm::vec4(0)) {}
  /// Lays over everything painted so far. `shape` is asked at texture coordinates inside [min, max] (clipped to the
  /// image) and answers colour and coverage.
  void paint(glm::vec2 min, glm::vec2 max, const std::function<glm::vec4(glm::vec2 uv)>& shape);
  /// Where nothing was painted the colour is `background`, so that filtering brings in no dark rim.
  scene::Image image(const std::string& name, const glm::vec3& background) const;

 private:
  int width_, height_;
  std::vector<glm::vec4> rgba_;
};

}  // namespace tyndall::levels
