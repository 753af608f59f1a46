// Small levels, and the medium's formulas once more, written without looking at engine/truth: plain quadrature and the
// projection matrix turned round.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "truth/truth.hpp"

namespace truth_test {

namespace scene = tyndall::scene;
namespace truth = tyndall::truth;

/// Adds a parallelogram with corners a, a+u, a+u+v, a+v, whose front is where cross(u, v) points; uv 0..1 along u and
/// v.
inline scene::Primitive& addQuad(scene::Scene& level, glm::vec3 a, glm::vec3 u, glm::vec3 v,
                                 const scene::Material& material = {}) {
  scene::Primitive primitive;
  for (const glm::vec2 uv : {glm::vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    scene::Vertex vertex;
    vertex.position = a + u * uv.x + v * uv.y;
    vertex.normal = glm::normalize(glm::cross(u, v));
    vertex.uv = uv;
    primitive.vertices.push_back(vertex);
    primitive.bounds.add(vertex.position);
  }
  primitive.indices = {0, 1, 2, 0, 2, 3};
  primitive.material = static_cast<std::int32_t>(level.materials.size());
  level.materials.push_back(material);
  scene::Node node;
  node.mesh = static_cast<std::int32_t>(level.meshes.size());
  level.nodes.push_back(node);
  level.meshes.push_back({"quad", {primitive}});
  return level.meshes.back().primitives.front();
}

inline scene::CameraView cameraAt(glm::vec3 eye, glm::vec3 towards, float yfov = 1.0f, float znear = 0.1f,
                                  float zfar = 20.0f) {
  const glm::vec3 up = std::abs(glm::normalize(towards).y) > 0.99f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return {glm::inverse(glm::lookAt(eye, eye + towards, up)), {"camera", yfov, znear, zfar}, "camera"};
}

inline scene::LightView sunAlong(glm::vec3 travel, glm::vec3 irradiance = glm::vec3(1)) {
  scene::LightView sun;
  sun.light.color = irradiance;
  sun.direction = glm::normalize(travel);
  return sun;
}

inline scene::LightView pointAt(glm::vec3 position, glm::vec3 candela = glm::vec3(1)) {
  scene::LightView light;
  light.light.kind = scene::LightKind::kPoint;
  light.light.color = candela;
  light.position = position;
  return light;
}

struct Ray {
  glm::dvec3 eye, direction;
  double cosine;  ///< to the optical axis
  glm::dvec3 at(double t) const { return eye + t * direction; }
};

/// The ray through a pixel's centre, by the inverse of the usual projection matrix.
inline Ray rayThrough(const scene::CameraView& view, const truth::Settings& settings, double x, double y) {
  const glm::dmat4 clipFromView =
      glm::perspective(double{view.camera.yfov}, double(settings.width) / settings.height, 0.5, 2.0);
  const glm::dvec4 ndc(2 * (x + 0.5) / settings.width - 1, 1 - 2 * (y + 0.5) / settings.height, 0.3, 1);
  const glm::dvec4 h = glm::inverse(clipFromView) * ndc;
  const glm::dvec3 inView = glm::normalize(glm::dvec3(h) / h.w);
  const glm::dmat4 worldFromView(view.worldFromView);
  return {glm::dvec3(worldFromView[3]), glm::normalize(glm::dvec3(worldFromView * glm::dvec4(inView, 0))), -inView.z};
}

inline double henyeyGreenstein(double g, double cosine) {
  return 0.25 / std::numbers::pi * (1 - g * g) / std::pow(1 + g * g - 2 * g * cosine, 1.5);
}

/// Integral of exp(-sigma t) over [a, b].
inline double fog(double sigma, double a, double b) {
  if (sigma < 1e-9) return b - a;
  return (std::exp(-sigma * a) - std::exp(-sigma * b)) / sigma;
}

/// Adaptive Simpson quadrature.
inline double quadrature(const std::function<double(double)>& f, double a, double b, double tolerance = 1e-10) {
  const std::function<double(double, double, double, double, double, double, int)> part =
      [&](double l, double r, double fl, double fm, double fr, double whole, int depth) {
        const double m = (l + r) / 2, fa = f((l + m) / 2), fb = f((m + r) / 2);
        const double left = (m - l) / 6 * (fl + 4 * fa + fm), right = (r - m) / 6 * (fm + 4 * fb + fr);
        if (depth == 0 || std::abs(left + right - whole) < 15 * tolerance * (std::abs(left + right) + 1e-30))
          return left + right;
        return part(l, m, fl, fa, fm, left, depth - 1) + part(m, r, fm, fb, fr, right, depth - 1);
      };
  // Beginning with many pieces keeps narrow peaks from being missed.
  double sum = 0;
  constexpr int kPieces = 256;
  for (int i = 0; i < kPieces; ++i) {
    const double l = a + (b - a) * i / kPieces, r = a + (b - a) * (i + 1) / kPieces;
    const double fl = f(l), fm = f((l + r) / 2), fr = f(r);
    sum += part(l, r, fl, fm, fr, (r - l) / 6 * (fl + 4 * fm + fr), 20);
  }
  return sum;
}

inline truth::Picture rendered(const scene::Scene& level, const scene::CameraView& camera,
                               const std::vector<scene::LightView>& lights, const truth::Settings& settings) {
  auto picture = truth::render(level, camera, lights, settings);
  EXPECT_TRUE(picture) << picture.error().message;
  return picture ? picture.take() : truth::Picture{};
}

/// One pixel: its ray is the optical axis.
inline truth::Settings onePixel(truth::Medium medium, std::uint32_t samples = 1024) {
  truth::Settings settings;
  settings.width = settings.height = 1;
  settings.medium = medium;
  settings.samples = samples;
  settings.threads = 1;
  return settings;
}

}  // namespace truth_test
