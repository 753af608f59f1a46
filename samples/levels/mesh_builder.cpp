#include "mesh_builder.hpp"

#include <string>

#include "base/assert.hpp"

namespace tyndall::levels {

std::uint32_t MeshBuilder::vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv) {
  scene::Vertex v;
  v.position = glm::vec3(frame * glm::vec4(position, 1.0f));
  v.normal = glm::normalize(glm::mat3(frame) * normal);
  v.uv = uv + uvOffset;
  v.color = glm::min(color, glm::vec4(1));  // glTF colours are factors in [0, 1]
  primitive_.vertices.push_back(v);
  return static_cast<std::uint32_t>(primitive_.vertices.size() - 1);
}

void MeshBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const auto at = [&](std::uint32_t i) { return primitive_.vertices[i].position; };
  // 1e-6 m^2: a millimetre squared; thinner slivers only cost raster time.
  if (glm::length(glm::cross(at(b) - at(a), at(c) - at(a))) < 1e-6f) return;
  primitive_.indices.insert(primitive_.indices.end(), {a, b, c});
}

void MeshBuilder::quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  triangle(a, b, c);
  triangle(a, c, d);
}

void MeshBuilder::flatQuad(const glm::vec3 (&corner)[4], const glm::vec2 (&uv)[4]) {
  flatPolygon({corner, corner + 4}, {uv, uv + 4});
}

void MeshBuilder::flatPolygon(const std::vector<glm::vec3>& corners, const std::vector<glm::vec2>& uv) {
  TY_ASSERT(corners.size() >= 3 && corners.size() == uv.size(), std::to_string(corners.size()) + " corners");
  glm::vec3 normal{0};  // Newell: right for any polygon, also when three corners are in line
  for (std::size_t i = 0; i < corners.size(); ++i) normal += glm::cross(corners[i], corners[(i + 1) % corners.size()]);
  if (glm::length(normal) < 1e-6f) return;
  const auto first = static_cast<std::uint32_t>(primitive_.vertices.size());
  for (std::size_t i = 0; i < corners.size(); ++i) vertex(corners[i], glm::normalize(normal), uv[i]);
  for (std::uint32_t i = 2; i < corners.size(); ++i) triangle(first, first + i - 1, first + i);
}

scene::Primitive MeshBuilder::finish(std::int32_t material, float metresPerTile) const {
  TY_ASSERT(metresPerTile > 0, std::to_string(metresPerTile));
  scene::Primitive result = primitive_;
  result.material = material;
  for (scene::Vertex& v : result.vertices) {
    v.uv /= metresPerTile;
    result.bounds.add(v.position);
  }
  deriveTangents(result);
  return result;
}

void deriveTangents(scene::Primitive& primitive) {
  std::vector<glm::vec3> along(primitive.vertices.size(), glm::vec3(0)), up = along;
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const std::uint32_t* index = &primitive.indices[i];
    const scene::Vertex &a = primitive.vertices[index[0]], &b = primitive.vertices[index[1]],
                        &c = primitive.vertices[index[2]];
    const glm::vec3 e1 = b.position - a.position, e2 = c.position - a.position;
    const glm::vec2 d1 = b.uv - a.uv, d2 = c.uv - a.uv;
    const float area = d1.x * d2.y - d2.x * d1.y;
    if (glm::abs(area) < 1e-12f) continue;
    const glm::vec3 t = (e1 * d2.y - e2 * d1.y) / area, v = (e2 * d1.x - e1 * d2.x) / area;
    for (int k = 0; k < 3; ++k) {
      along[index[k]] += t;
      up[index[k]] -= v;
    }
  }
  for (std::size_t i = 0; i < primitive.vertices.size(); ++i) {
    scene::Vertex& vertex = primitive.vertices[i];
    const glm::vec3 n = vertex.normal;
    glm::vec3 t = along[i] - n * glm::dot(n, along[i]);
    if (glm::length(t) < 1e-6f) t = glm::cross(n, glm::abs(n.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0));
    t = glm::normalize(t);
    vertex.tangent = glm::vec4(t, glm::dot(glm::cross(n, t), up[i]) < 0 ? -1.0f : 1.0f);
  }
}

}  // namespace tyndall::levels
