// Collects triangles for one primitive. Shapes (shapes.hpp) add to it in a local frame; finish() scales the texture
// coordinates, which shapes give in metres, and derives the tangents.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.hpp"

namespace tyndall::levels {

class MeshBuilder {
 public:
  glm::mat4 frame{1};     ///< applied to what is added next; rotation, translation and uniform scale only
  glm::vec4 color{1};     ///< linear tint of what is added next; what exceeds 1 counts as 1, as in glTF
  glm::vec2 uvOffset{0};  ///< metres, added to texture coordinates: shifts the pattern from piece to piece

  std::uint32_t vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv);
  /// Counter-clockwise seen from the front. Triangles without area are left out.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
  /// Flat quad with corners counter-clockwise; uv of each corner in metres.
  void flatQuad(const glm::vec3 (&corner)[4], const glm::vec2 (&uv)[4]);
  /// Flat polygon, convex, counter-clockwise.
  void flatPolygon(const std::vector<glm::vec3>& corners, const std::vector<glm::vec2>& uv);

  bool empty() const { return primitive_.indices.empty(); }
  /// `metresPerTile`: the size of one repetition of the material's textures.
  scene::Primitive finish(std::int32_t material, float metresPerTile = 1.0f) const;

 private:
  scene::Primitive primitive_;
};

/// Tangents from positions and texture coordinates, with glTF's handedness: the bitangent points to decreasing v,
/// which is up in the image. Where the mapping has no area any tangent across the normal is taken.
void deriveTangents(scene::Primitive& primitive);

/// -Wconversion wants every int to float conversion said; this says it briefly.
inline constexpr float real(int value) { return static_cast<float>(value); }

}  // namespace tyndall::levels
