// Shapes with curved sides: lathe, tube, surface.
#include <string>

#include <glm/gtc/constants.hpp>

#include "base/assert.hpp"
#include "shapes.hpp"

namespace tyndall::levels {
namespace {

constexpr float kTurn = 2.0f * glm::pi<float>();

/// One smooth run of a lathe's profile.
void latheRun(MeshBuilder& b, const std::vector<glm::vec2>& run, int sides, float uMetres, float vStart) {
  const auto rows = static_cast<int>(run.size());
  std::vector<std::uint32_t> index;
  float v = vStart;
  for (int row = 0; row < rows; ++row) {
    const glm::vec2 before = run[glm::max(row - 1, 0)], after = run[glm::min(row + 1, rows - 1)];
    const glm::vec2 tangent = glm::normalize(after - before);
    if (row > 0) v -= glm::length(run[row] - run[row - 1]);
    for (int side = 0; side <= sides; ++side) {
      const float turn = real(side % sides) / real(sides), angle = turn * kTurn;
      const float c = glm::cos(angle), s = glm::sin(angle);
      const glm::vec3 normal{tangent.y * c, -tangent.x, -tangent.y * s};
      index.push_back(
          b.vertex({run[row].x * c, run[row].y, -run[row].x * s}, normal, {real(side) / real(sides) * uMetres, v}));
    }
  }
  for (int row = 0; row + 1 < rows; ++row) {
    for (int side = 0; side < sides; ++side) {
      const int a = row * (sides + 1) + side, c = a + sides + 1;
      b.quad(index[a], index[a + 1], index[c + 1], index[c]);
    }
  }
}

}  // namespace

void lathe(MeshBuilder& b, const std::vector<glm::vec2>& profile, int sides) {
  float widest = 0;
  for (const glm::vec2& p : profile) widest = glm::max(widest, p.x);
  std::vector<glm::vec2> run;
  float v = 0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    run.push_back(profile[i]);
    const bool last = i + 1 == profile.size();
    if (!last && profile[i + 1] != profile[i]) continue;
    if (run.size() >= 2) latheRun(b, run, sides, widest * kTurn, v);
    for (std::size_t k = 1; k < run.size(); ++k) v -= glm::length(run[k] - run[k - 1]);
    run.clear();
  }
}

void tube(MeshBuilder& b, const std::vector<glm::vec3>& path, const std::vector<float>& radii, int sides, bool cap) {
  TY_ASSERT(path.size() >= 2 && path.size() == radii.size(), std::to_string(path.size()) + " points");
  const auto rings = static_cast<int>(path.size());
  const auto tangentAt = [&](int i) {
    return glm::normalize(path[glm::min(i + 1, rings - 1)] - path[glm::max(i - 1, 0)]);
  };
  glm::vec3 tangent = tangentAt(0);
  glm::vec3 side =
      glm::normalize(glm::cross(tangent, glm::abs(tangent.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
  std::vector<std::uint32_t> index;
  std::vector<glm::vec3> sideAt;
  const float around = kTurn * radii[0];  // the first radius sets the width of the texture: bark does not shear
  float v = 0;
  for (int i = 0; i < rings; ++i) {
    tangent = tangentAt(i);
    side = glm::normalize(side - tangent * glm::dot(tangent, side));  // parallel transport
    sideAt.push_back(side);
    const glm::vec3 other = glm::cross(tangent, side);
    if (i > 0) v -= glm::length(path[i] - path[i - 1]);
    for (int k = 0; k <= sides; ++k) {
      const float angle = real(k % sides) / real(sides) * kTurn;
      const glm::vec3 normal = side * glm::cos(angle) + other * glm::sin(angle);
      index.push_back(b.vertex(path[i] + normal * radii[i], normal, {real(k) / real(sides) * around, v}));
    }
  }
  for (int i = 0; i + 1 < rings; ++i) {
    for (int k = 0; k < sides; ++k) {
      const int a = i * (sides + 1) + k, c = a + sides + 1;
      b.quad(index[a], index[a + 1], index[c + 1], index[c]);
    }
  }
  if (!cap) return;
  for (const int end : {0, rings - 1}) {
    const glm::vec3 normal = end == 0 ? -tangentAt(0) : tangentAt(end);
    const std::uint32_t centre = b.vertex(path[end], normal, {0, 0});
    std::vector<std::uint32_t> rim;
    for (int k = 0; k < sides; ++k) {
      const float angle = real(k) / real(sides) * kTurn;
      const glm::vec3 offset =
          (sideAt[end] * glm::cos(angle) + glm::cross(tangentAt(end), sideAt[end]) * glm::sin(angle)) * radii[end];
      rim.push_back(b.vertex(path[end] + offset, normal, radii[end] * glm::vec2(glm::cos(angle), glm::sin(angle))));
    }
    for (int k = 0; k < sides; ++k) {
      const std::uint32_t here = rim[k], next = rim[(k + 1) % sides];
      end == 0 ? b.triangle(centre, next, here) : b.triangle(centre, here, next);
    }
  }
}

void surface(MeshBuilder& b, int columns, int rows, const glm::vec2& metres,
             const std::function<glm::vec3(float u, float v)>& point) {
  constexpr float kStep = 1e-3f;  // of the parameter: far below a cell, far above rounding
  std::vector<std::uint32_t> index;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const float u = real(column) / real(columns), v = real(row) / real(rows);
      const glm::vec3 du = point(u + kStep, v) - point(u - kStep, v), dv = point(u, v + kStep) - point(u, v - kStep);
      index.push_back(b.vertex(point(u, v), glm::normalize(glm::cross(du, dv)), {u * metres.x, -v * metres.y}));
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int a = row * (columns + 1) + column, c = a + columns + 1;
      b.quad(index[a], index[a + 1], index[c + 1], index[c]);
    }
  }
}

}  // namespace tyndall::levels
