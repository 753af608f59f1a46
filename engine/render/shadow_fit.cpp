#include "shadow_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/assert.hpp"
#include "convex.hpp"

namespace tyndall::render {

namespace {

// The filter around a look-up at the map's border reaches two texels further.
constexpr double kMarginTexels = 2;
// A flat or thin box of casters seen edge-on has no area; it is thickened by this share of its diagonal and this
// length. That also keeps the farthest caster from storing 1, which means "nothing".
constexpr double kThickenShare = 1e-4, kThickenMetres = 1e-3;
// The same for the far plane of spot and point lights, as a share of the distance.
constexpr double kFarMargin = 1e-3;

struct Basis {
  glm::dvec3 x, y, z;  // z along the light
  glm::dvec3 apply(const glm::dvec3& p) const { return {glm::dot(p, x), glm::dot(p, y), glm::dot(p, z)}; }
};

Basis basisAlong(const glm::dvec3& direction) {
  const glm::dvec3 z = glm::normalize(direction);
  const glm::dvec3 helper = std::abs(z.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(helper, z));
  return {x, glm::cross(z, x), z};
}

// Rows of a matrix: clip.xyz = (scale * (axis . p - center)).
glm::mat4 orthographic(const Basis& b, const glm::dvec3& center, const glm::dvec3& scale, const glm::dvec3& offset) {
  glm::dmat4 m(1);
  const glm::dvec3 axes[3] = {b.x, b.y, b.z};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) m[column][row] = scale[row] * axes[row][column];
    m[3][row] = offset[row] - scale[row] * center[row];
  }
  return glm::mat4(m);
}

// Depth 0 at `n`, 1 at `f` along b.z; `tangent` of the half angle.
glm::mat4 perspective(const Basis& b, const glm::dvec3& eye, double tangent, double n, double f) {
  glm::dmat4 m(0);
  const double depthScale = f / (f - n);
  for (int column = 0; column < 3; ++column) {
    m[column][0] = b.x[column] / tangent;
    m[column][1] = b.y[column] / tangent;
    m[column][2] = b.z[column] * depthScale;
    m[column][3] = b.z[column];
  }
  const glm::dvec3 e = b.apply(eye);
  m[3][0] = -e.x / tangent;
  m[3][1] = -e.y / tangent;
  m[3][2] = -e.z * depthScale - n * depthScale;
  m[3][3] = -e.z;
  return glm::mat4(m);
}

struct DepthRange {
  double near, far;
};

float curveOf(const DepthRange& range) { return static_cast<float>(range.far / range.near - 1); }

// Distances of the casters from a local light. Depth clamp keeps casters nearer than `near`.
DepthRange localRange(const scene::LightView& light, const scene::Bounds& casters) {
  const glm::dvec3 p(light.position);
  const glm::dvec3 nearest = glm::clamp(p, glm::dvec3(casters.min), glm::dvec3(casters.max));
  double farthest = 0;
  for (const glm::vec3& corner : boxCorners(casters, light.position)) {
    farthest = std::max(farthest, glm::distance(p, glm::dvec3(corner)));
  }
  farthest = farthest * (1 + kFarMargin) + kThickenMetres;
  // Light ends at its range: what lies beyond is unlit anyway.
  if (light.light.range) farthest = std::min(farthest, std::max(static_cast<double>(*light.light.range), 1e-3));
  // A perspective depth's precision is the far distance's share of the near one: a thousandth keeps float depths good
  // to farthest * 6e-5. The face's axis is up to sqrt(3) times shorter than the distance.
  const double near = std::max({0.02, 1e-3 * farthest, 0.99 * glm::distance(p, nearest) / std::sqrt(3.0)});
  return {std::min(near, 0.5 * farthest), farthest};
}

}  // namespace

Corners boxCorners(const scene::Bounds& box, const glm::vec3& fallback) {
  Corners corners;
  for (unsigned i = 0; i < 8; ++i) {
    const glm::vec3 corner(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z);
    corners[i] = box.empty() ? fallback : corner;
  }
  return corners;
}

ShadowFit fitDirectional(const View& view, const glm::vec3& direction, const scene::Bounds& casters,
                         std::uint32_t size) {
  ShadowFit fit;
  const Basis basis = basisAlong(glm::dvec3(direction));
  if (casters.empty()) {
    fit.clipFromWorld[0] = orthographic(basis, basis.apply(glm::dvec3(view.eye)), glm::dvec3(1), glm::dvec3(0, 0, 0.5));
    fit.texelSize = 2.0 / size;
    return fit;
  }

  std::vector<glm::dvec2> points;
  double nearest = std::numeric_limits<double>::max(), farthest = std::numeric_limits<double>::lowest();
  scene::Bounds thick = casters;
  const double diagonal = glm::distance(glm::dvec3(casters.min), glm::dvec3(casters.max));
  const glm::vec3 skin(static_cast<float>(kThickenShare * diagonal + kThickenMetres));
  thick.min -= skin;
  thick.max += skin;
  for (const glm::vec3& corner : boxCorners(thick, view.eye)) {
    const glm::dvec3 p = basis.apply(glm::dvec3(corner));
    points.emplace_back(p);
    nearest = std::min(nearest, p.z);
    farthest = std::max(farthest, p.z);
  }
  const Polygon castersHull = convexHull(points);

  points.assign(1, glm::dvec2(basis.apply(glm::dvec3(view.eye))));
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const glm::dvec4 p = glm::dmat4(view.viewFromClip) * glm::dvec4(x, y, 0, 1);
      const glm::dvec3 world(glm::dmat4(view.worldFromView) * glm::dvec4(glm::dvec3(p) / p.w, 1));
      points.emplace_back(basis.apply(world));
    }
  }
  Polygon shared = intersect(castersHull, convexHull(points));
  fit.useful = !shared.empty();
  if (shared.empty()) shared = castersHull;

  const Rectangle rectangle = smallestRectangle(shared);
  Basis turned = basis;
  turned.x = rectangle.axis.x * basis.x + rectangle.axis.y * basis.y;
  turned.y = -rectangle.axis.y * basis.x + rectangle.axis.x * basis.y;
  // Grown so that the margin is two texels of the grown map; tiny maps grow by the same share of four.
  const double grow = 1 / (1 - 2 * kMarginTexels / std::max<double>(size, 4 * kMarginTexels));
  const glm::dvec2 half = glm::max(rectangle.half * grow, glm::dvec2(0.5e-3));
  const glm::dvec3 world = rectangle.center.x * basis.x + rectangle.center.y * basis.y;
  const glm::dvec3 center(glm::dot(world, turned.x), glm::dot(world, turned.y), nearest);
  fit.clipFromWorld[0] =
      orthographic(turned, center, {1 / half.x, 1 / half.y, 1 / (farthest - nearest)}, glm::dvec3(0));
  fit.texelSize = 2 * std::max(half.x, half.y) / size;
  return fit;
}

ShadowFit fitSpot(const scene::LightView& light, const scene::Bounds& casters, std::uint32_t size) {
  ShadowFit fit;
  // A perspective map cannot see half the sphere; light beyond 89.4 degrees from the axis stays unshadowed.
  constexpr double kWidest = 1.56;
  double half = light.light.outerConeAngle;
  if (half > kWidest) {
    half = kWidest;
    fit.note = "its cone is wider than a shadow map can be; the outermost light is unshadowed";
  }
  const double tangent = std::max(std::tan(half), 1e-4) * (1 + 2 * kMarginTexels / size);
  const DepthRange range = localRange(light, casters);
  fit.clipFromWorld[0] =
      perspective(basisAlong(glm::dvec3(light.direction)), glm::dvec3(light.position), tangent, range.near, range.far);
  fit.useful = !casters.empty();
  fit.texelSize = 2 * tangent / size;
  fit.depthCurve = curveOf(range);
  return fit;
}

ShadowFit fitPoint(const scene::LightView& light, const scene::Bounds& casters, std::uint32_t size) {
  ShadowFit fit;
  fit.faceCount = 6;
  fit.useful = !casters.empty();
  fit.texelSize = 2.0 / size;
  const DepthRange range = localRange(light, casters);
  fit.depthCurve = curveOf(range);
  for (int face = 0; face < 6; ++face) {
    glm::dvec3 axis(0);
    axis[face / 2] = face % 2 ? -1 : 1;
    fit.clipFromWorld[static_cast<std::size_t>(face)] =
        perspective(basisAlong(axis), glm::dvec3(light.position), 1.0, range.near, range.far);
  }
  return fit;
}

ShadowFit fitShadow(const View& view, const scene::LightView& light, const scene::Bounds& casters, std::uint32_t size) {
  TY_ASSERT(size > 0, "a shadow map without texels");
  switch (light.light.kind) {
    case scene::LightKind::kDirectional: return fitDirectional(view, light.direction, casters, size);
    case scene::LightKind::kSpot: return fitSpot(light, casters, size);
    case scene::LightKind::kPoint: break;
  }
  return fitPoint(light, casters, size);
}

}  // namespace tyndall::render
