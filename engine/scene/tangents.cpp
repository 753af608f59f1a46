#include <cmath>

#include "import_parts.hpp"

namespace tyndall::scene {
namespace {

/// Twice the triangle's area times its unit normal, in double: coordinates may be large.
glm::dvec3 areaNormal(const Primitive& p, std::size_t triangle) {
  const glm::dvec3 a(p.vertices[p.indices[3 * triangle]].position), b(p.vertices[p.indices[3 * triangle + 1]].position),
      c(p.vertices[p.indices[3 * triangle + 2]].position);
  return glm::cross(b - a, c - a);
}

}  // namespace

glm::vec3 perpendicular(const glm::vec3& n) {
  // Across the axis along which n is shortest, so that the cross product is never near zero.
  const glm::vec3 a = glm::abs(n);
  const glm::vec3 axis = a.x <= a.y && a.x <= a.z ? glm::vec3(1, 0, 0)
                         : a.y <= a.z             ? glm::vec3(0, 1, 0)
                                                  : glm::vec3(0, 0, 1);
  return glm::normalize(glm::cross(axis, n));
}

std::size_t repairNormals(Primitive& p) {
  std::vector<glm::dvec3> sums;
  std::size_t repaired = 0;
  for (const Vertex& v : p.vertices) repaired += v.normal == glm::vec3(0);
  if (!repaired) return 0;
  sums.resize(p.vertices.size(), glm::dvec3(0));
  for (std::size_t t = 0; t < p.indices.size() / 3; ++t) {
    const glm::dvec3 normal = areaNormal(p, t);
    for (int corner = 0; corner < 3; ++corner) sums[p.indices[3 * t + corner]] += normal;
  }
  for (std::size_t i = 0; i < p.vertices.size(); ++i) {
    if (p.vertices[i].normal != glm::vec3(0)) continue;
    const double length = std::sqrt(glm::dot(sums[i], sums[i]));
    // A degenerate triangle is never seen; any unit vector keeps later arithmetic finite.
    p.vertices[i].normal = length > 1e-300 && std::isfinite(length) ? glm::vec3(sums[i] / length) : glm::vec3(0, 1, 0);
  }
  return repaired;
}

void computeTangents(Primitive& p) {
  // Lengyel, "Computing Tangent Space Basis Vectors for an Arbitrary Mesh" (2001): solve edge = du T + dv B for each
  // triangle, sum over the triangles of a vertex, orthogonalise against its normal.
  std::vector<glm::dvec3> along(p.vertices.size(), glm::dvec3(0)), across(p.vertices.size(), glm::dvec3(0));
  for (std::size_t t = 0; t < p.indices.size() / 3; ++t) {
    const std::uint32_t* corner = &p.indices[3 * t];
    const Vertex &a = p.vertices[corner[0]], &b = p.vertices[corner[1]], &c = p.vertices[corner[2]];
    const glm::dvec3 e1 = glm::dvec3(b.position) - glm::dvec3(a.position),
                     e2 = glm::dvec3(c.position) - glm::dvec3(a.position);
    const glm::dvec2 d1 = glm::dvec2(b.uv) - glm::dvec2(a.uv), d2 = glm::dvec2(c.uv) - glm::dvec2(a.uv);
    const double area = d1.x * d2.y - d2.x * d1.y;
    if (area == 0) continue;
    // Only the sign of the area matters: the unnormalised sums weigh triangles by their size.
    const double sign = area > 0 ? 1 : -1;
    const glm::dvec3 u = sign * (e1 * d2.y - e2 * d1.y), v = sign * (e2 * d1.x - e1 * d2.x);
    for (int k = 0; k < 3; ++k) {
      along[corner[k]] += u;
      across[corner[k]] += v;
    }
  }
  for (std::size_t i = 0; i < p.vertices.size(); ++i) {
    const glm::dvec3 n(p.vertices[i].normal);
    const glm::dvec3 t = along[i] - n * glm::dot(n, along[i]);
    const double length = std::sqrt(glm::dot(t, t));
    const bool usable =
        length > 1e-200 && std::isfinite(length) && length > 1e-6 * std::sqrt(glm::dot(along[i], along[i]));
    const glm::vec3 direction = usable ? glm::vec3(t / length) : perpendicular(p.vertices[i].normal);
    const bool mirrored = usable && glm::dot(glm::cross(n, t), across[i]) < 0;
    p.vertices[i].tangent = glm::vec4(direction, mirrored ? -1.0f : 1.0f);
  }
}

}  // namespace tyndall::scene
