// Shapes with flat sides: box, beam, bar, card; and placement.
#include <algorithm>
#include <string>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "base/assert.hpp"
#include "shapes.hpp"

namespace tyndall::levels {
namespace {

/// Texture coordinates of a point on a box's side whose normal is `axis`.
glm::vec2 boxUv(const glm::vec3& p, const glm::vec3& size, int axis, Mapping mapping) {
  int uAxis = axis == 0 ? 2 : 0, vAxis = axis == 1 ? 2 : 1;
  if (mapping == Mapping::kGrain && size[vAxis] > size[uAxis]) std::swap(uAxis, vAxis);
  return {p[uAxis], -p[vAxis]};
}

}  // namespace

void chamferBox(MeshBuilder& b, const glm::vec3& min, const glm::vec3& max, float chamfer, Mapping mapping) {
  const glm::vec3 size = max - min, centre = 0.5f * (min + max), half = 0.5f * size;
  const float smallest = glm::min(half.x, glm::min(half.y, half.z));
  TY_ASSERT(smallest > chamfer && chamfer >= 0,
            "half side " + std::to_string(smallest) + ", chamfer " + std::to_string(chamfer));
  // Corner of the side `axis` next to the box corner `sign`: on that side, drawn in by the chamfer along the others.
  const auto corner = [&](int axis, const glm::vec3& sign) {
    glm::vec3 p = centre + sign * (half - chamfer);
    p[axis] = centre[axis] + sign[axis] * half[axis];
    return p;
  };
  const auto add = [&](std::vector<glm::vec3> points, const glm::vec3& outward, int uvAxis) {
    if (glm::dot(glm::cross(points[1] - points[0], points[2] - points[0]), outward) < 0)
      std::reverse(points.begin(), points.end());
    std::vector<glm::vec2> uv;
    for (const glm::vec3& p : points) uv.push_back(boxUv(p, size, uvAxis, mapping));
    b.flatPolygon(points, uv);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    for (const float side : {-1.0f, 1.0f}) {
      const auto at = [&](float a, float c) {
        glm::vec3 s;
        s[axis] = side, s[i] = a, s[j] = c;
        return s;
      };
      glm::vec3 outward{0};
      outward[axis] = side;
      add({corner(axis, at(-1, -1)), corner(axis, at(1, -1)), corner(axis, at(1, 1)), corner(axis, at(-1, 1))}, outward,
          axis);
      if (chamfer == 0) continue;
      for (const float other : {-1.0f, 1.0f}) {  // the edge between this side and the next axis' side
        glm::vec3 edge = outward;
        edge[i] = other;
        add({corner(axis, at(other, -1)), corner(axis, at(other, 1)), corner(i, at(other, 1)),
             corner(i, at(other, -1))},
            edge, axis);
      }
    }
  }
  if (chamfer == 0) return;
  for (int k = 0; k < 8; ++k) {
    const glm::vec3 s{k & 1 ? 1.0f : -1.0f, k & 2 ? 1.0f : -1.0f, k & 4 ? 1.0f : -1.0f};
    add({corner(0, s), corner(1, s), corner(2, s)}, s, 0);
  }
}

void beam(MeshBuilder& b, const glm::vec3& from, const glm::vec3& to, float width, float height, float chamfer,
          const glm::vec3& up) {
  const glm::vec3 along = to - from;
  const glm::mat4 before = b.frame;
  b.frame = before * glm::translate(glm::mat4(1), 0.5f * (from + to)) * glm::mat4_cast(lookRotation(along, up));
  const glm::vec3 half{0.5f * width, 0.5f * height, 0.5f * glm::length(along)};
  chamferBox(b, -half, half, chamfer, Mapping::kGrain);
  b.frame = before;
}

void bar(MeshBuilder& b, const std::vector<glm::vec3>& path, const glm::vec3& planeNormal, float width, float depth,
         bool closed) {
  const auto count = static_cast<int>(path.size());
  TY_ASSERT(count >= 2, std::to_string(count) + " points");
  const glm::vec3 n = glm::normalize(planeNormal);
  // Mitred offset to the left of the path at point i.
  const auto across = [&](int i) {
    const auto segment = [&](int k) {
      k = closed ? (k + count) % count : glm::clamp(k, 0, count - 2);
      return glm::normalize(glm::cross(n, path[(k + 1) % count] - path[k]));
    };
    const glm::vec3 s0 = segment(i - 1), s1 = segment(i);
    return (s0 + s1) / (1.0f + glm::dot(s0, s1));
  };
  float run = 0;
  for (int i = 0; i < (closed ? count : count - 1); ++i) {
    const int next = (i + 1) % count;
    glm::vec3 ring[2][4];
    for (int end = 0; end < 2; ++end) {
      const int at = end == 0 ? i : next;
      const glm::vec3 w = across(at) * (0.5f * width), d = n * (0.5f * depth);
      ring[end][0] = path[at] - w - d, ring[end][1] = path[at] + w - d;
      ring[end][2] = path[at] + w + d, ring[end][3] = path[at] - w + d;
    }
    const float length = glm::length(path[next] - path[i]);
    for (int side = 0; side < 4; ++side) {
      const int other = (side + 1) % 4;
      const float v = side % 2 == 0 ? width : depth;
      b.flatQuad({ring[0][side], ring[0][other], ring[1][other], ring[1][side]},
                 {{run, 0}, {run, v}, {run + length, v}, {run + length, 0}});
    }
    const std::vector<glm::vec2> capUv{{0, 0}, {width, 0}, {width, depth}, {0, depth}};
    if (!closed && i == 0) b.flatPolygon({ring[0][3], ring[0][2], ring[0][1], ring[0][0]}, capUv);
    if (!closed && i == count - 2) b.flatPolygon({ring[1][0], ring[1][1], ring[1][2], ring[1][3]}, capUv);
    run += length;
  }
}

void card(MeshBuilder& b, const glm::vec3& base, const glm::vec3& right, const glm::vec3& up, const glm::vec3& normal,
          const glm::vec2& uvMin, const glm::vec2& uvMax) {
  const bool turned = glm::dot(glm::cross(right, up), normal) < 0;
  const glm::vec3 r = turned ? -right : right;
  const std::uint32_t a = b.vertex(base - 0.5f * r, normal, {uvMin.x, uvMax.y}),
                      c = b.vertex(base + 0.5f * r, normal, {uvMax.x, uvMax.y});
  const std::uint32_t d = b.vertex(base + 0.5f * r + up, normal, {uvMax.x, uvMin.y}),
                      e = b.vertex(base - 0.5f * r + up, normal, {uvMin.x, uvMin.y});
  b.quad(a, c, d, e);
}

glm::quat lookRotation(const glm::vec3& forward, const glm::vec3& up) {
  const glm::vec3 back = -glm::normalize(forward);
  const glm::vec3 helper =
      glm::abs(glm::dot(back, glm::normalize(up))) < 0.999f ? up : glm::vec3(back.y, back.z, back.x);
  const glm::vec3 right = glm::normalize(glm::cross(helper, back));
  return glm::normalize(glm::quat_cast(glm::mat3(right, glm::cross(back, right), back)));
}

glm::mat4 placed(const glm::vec3& at, float yaw, float scale) {
  return glm::scale(glm::rotate(glm::translate(glm::mat4(1), at), yaw, glm::vec3(0, 1, 0)), glm::vec3(scale));
}

}  // namespace tyndall::levels
