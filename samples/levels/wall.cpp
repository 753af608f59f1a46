#include "wall.hpp"

#include <algorithm>
#include <string>

#include <glm/gtc/constants.hpp>

#include "base/assert.hpp"

namespace tyndall::levels {
namespace {

/// A vertical polygon of one face; `front` true: seen from the room.
void facePolygon(MeshBuilder& b, std::vector<glm::vec2> points, float depth, bool front) {
  if (!front) std::reverse(points.begin(), points.end());
  std::vector<glm::vec3> corners;
  std::vector<glm::vec2> uv;
  for (const glm::vec2& p : points) {
    corners.emplace_back(p, -depth);
    uv.emplace_back(p.x, -p.y);
  }
  b.flatPolygon(corners, uv);
}

}  // namespace

Outline pointedArch(float halfWidth, float sill, float spring, int steps) {
  Outline outline;
  const float radius = 2.0f * halfWidth;
  for (int i = -steps; i <= steps; ++i) {
    // Equal angles: 60 degrees of arc a side, from the jamb up to the point.
    const float angle = glm::radians(60.0f) * (1.0f - glm::abs(real(i)) / real(steps));
    const float s = radius * glm::cos(angle) - halfWidth, y = spring + radius * glm::sin(angle);
    outline.emplace_back(i < 0 ? -s : s, sill, y);
  }
  return outline;
}

Outline roundArch(float halfWidth, float sill, float spring, int steps) {
  Outline outline;
  for (int i = -steps; i <= steps; ++i) {
    const float angle = glm::half_pi<float>() * real(i) / real(steps);
    outline.emplace_back(halfWidth * glm::sin(angle), sill, spring + halfWidth * glm::cos(angle));
  }
  return outline;
}

Outline circle(float radius, float centreY, int steps) {
  Outline outline;
  for (int i = -steps; i <= steps; ++i) {
    const float angle = glm::half_pi<float>() * real(i) / real(steps);
    outline.emplace_back(radius * glm::sin(angle), centreY - radius * glm::cos(angle),
                         centreY + radius * glm::cos(angle));
  }
  return outline;
}

void wall(MeshBuilder& face, MeshBuilder& reveal, const WallShape& shape, const Outline& inner, const Outline& outer) {
  TY_ASSERT(inner.size() == outer.size(),
            std::to_string(inner.size()) + " and " + std::to_string(outer.size()) + " columns");
  const float h = shape.halfWidth;
  const auto top = [&](float s) { return glm::mix(shape.topMiddle, shape.topEnds, glm::abs(s) / h); };
  for (const bool front : {true, false}) {
    const Outline& hole = front ? inner : outer;
    const float depth = front ? 0.0f : shape.thickness;
    const glm::vec3 first = hole.front(), last = hole.back();
    // Beside the hole: fans whose outer edge has no vertices between its ends, so that the next panel fits without
    // T-junctions.
    facePolygon(face,
                {{-h, shape.bottom},
                 {first.x, shape.bottom},
                 {first.x, first.y},
                 {first.x, first.z},
                 {first.x, top(first.x)},
                 {-h, top(-h)}},
                depth, front);
    facePolygon(face,
                {{h, shape.bottom},
                 {h, top(h)},
                 {last.x, top(last.x)},
                 {last.x, last.z},
                 {last.x, last.y},
                 {last.x, shape.bottom}},
                depth, front);
    for (std::size_t i = 0; i + 1 < hole.size(); ++i) {
      const glm::vec3 a = hole[i], c = hole[i + 1];
      facePolygon(face, {{a.x, shape.bottom}, {c.x, shape.bottom}, {c.x, c.y}, {a.x, a.y}}, depth, front);
      facePolygon(face, {{a.x, a.z}, {c.x, c.z}, {c.x, top(c.x)}, {a.x, top(a.x)}}, depth, front);
    }
  }
  // The hole's sides: its contour counter-clockwise, joined between the faces.
  const auto contour = [](const Outline& hole) {
    std::vector<glm::vec2> points;
    for (const glm::vec3& p : hole) points.emplace_back(p.x, p.y);
    for (auto p = hole.rbegin(); p != hole.rend(); ++p) points.emplace_back(p->x, p->z);
    return points;
  };
  const std::vector<glm::vec2> in = contour(inner), out = contour(outer);
  float run = 0;
  for (std::size_t i = 0; i < in.size(); ++i) {
    const std::size_t next = (i + 1) % in.size();
    const float length = glm::length(in[next] - in[i]), t = shape.thickness;
    reveal.flatQuad({{in[i], 0}, {in[next], 0}, {out[next], -t}, {out[i], -t}},
                    {{run, 0}, {run + length, 0}, {run + length, t}, {run, t}});
    run += length;
  }
}

void wall(MeshBuilder& face, const WallShape& shape) {
  const float h = shape.halfWidth;
  for (const bool front : {true, false}) {
    facePolygon(face,
                {{-h, shape.bottom}, {h, shape.bottom}, {h, shape.topEnds}, {0, shape.topMiddle}, {-h, shape.topEnds}},
                front ? 0.0f : shape.thickness, front);
  }
}

}  // namespace tyndall::levels
