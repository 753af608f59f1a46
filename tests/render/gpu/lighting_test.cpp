// Radiance of lit and shadowed surfaces against an independent evaluation of the glTF reflection model.
#include "stage.hpp"

namespace tyndall::render::test {
namespace {

// glTF 2.0 appendix B in doubles, written from the specification and not from the shaders: radiance towards `v` per
// unit of irradiance on a plane facing the light, times the cosine.
double reflect(double albedo, double roughness, const glm::dvec3& n, const glm::dvec3& l, const glm::dvec3& v) {
  const double pi = std::acos(-1.0), a2 = std::pow(roughness, 4);
  const glm::dvec3 h = glm::normalize(l + v);
  const double nl = glm::dot(n, l), nv = glm::dot(n, v), nh = glm::dot(n, h), vh = glm::dot(v, h);
  const double f = 0.04 + 0.96 * std::pow(1 - vh, 5);
  const double d = a2 / (pi * std::pow(nh * nh * (a2 - 1) + 1, 2));
  const double g =
      2 * nl / (nl + std::sqrt(a2 + (1 - a2) * nl * nl)) * 2 * nv / (nv + std::sqrt(a2 + (1 - a2) * nv * nv));
  // Height-correlated Smith, from the lambdas (Heitz 2014, equation 99); g above is the uncorrelated product.
  const auto lambda = [&](double c) { return (-1 + std::sqrt(1 + a2 * (1 - c * c) / (c * c))) / 2; };
  const double correlated = 1 / (1 + lambda(nl) + lambda(nv));
  EXPECT_NEAR(correlated, g, 0.35);
  return ((1 - f) * albedo / pi + f * d * correlated / (4 * nl * nv)) * nl;
}

struct Floor {
  Level level;
  scene::CameraView camera = lookAt({0, 4, 6}, {0, 0, 0});
  explicit Floor(float roughness = 1) {
    scene::Material m = Level::grey(188);
    m.roughness = roughness;
    level.quad({0, 0, 0}, {8, 0, 0}, {0, 0, -8}, level.material(m));
  }
  // A roof that shadows the floor's middle from above; the camera looks beneath it.
  void addRoof(float half = 3) { level.quad({0, 7, 0}, {half, 0, 0}, {0, 0, -half}, level.material(Level::grey(100))); }
};

using LightingTest = FrameTest;

TEST_F(LightingTest, DirectSunlightIsTheBrdfTimesIrradiance) {
  for (const float roughness : {1.0f, 0.5f}) {
    Floor lit(roughness), dark(roughness);
    dark.addRoof();
    const scene::LightView light = sun({0.2f, -1, 0.1f}, 10);
    // The sun's own share is the difference between light and shadow; the roof hides some of a faint sky.
    Stage::Options options;
    options.settings.skyStrength = 0.01f;
    const Shot a = stage().render(lit.level.scene, lit.camera, {light}, options);
    const Shot b = stage().render(dark.level.scene, dark.camera, {light}, options);
    const std::uint32_t x = 32, y = 32;
    const View view = makeView(lit.camera, a.width, a.height);
    const glm::vec2 ndc = (glm::vec2(x, y) + 0.5f) / 32.0f - 1.0f;
    const glm::vec3 ray = glm::normalize(glm::vec3(
        view.worldFromView * glm::vec4(ndc.x * view.viewFromClip[0][0], ndc.y * view.viewFromClip[1][1], -1, 0)));
    const double expected =
        10 * reflect(linearFromSrgb(188), roughness, {0, 1, 0}, -glm::dvec3(light.direction), -glm::dvec3(ray));
    // Software devices decode sRGB by a polynomial that is 0.14 percent off at this grey.
    EXPECT_NEAR(a.at(x, y).r - b.at(x, y).r, expected, 2e-3 * expected) << "roughness " << roughness;
    EXPECT_GT(expected, 0.5 * linearFromSrgb(188) * 10 / 3.1416);
    EXPECT_GT(b.at(x, y).r, 0) << "the sky still lights the shadow";
    EXPECT_LT(b.at(x, y).r, 0.25 * expected);
  }
}

TEST_F(LightingTest, ShadowOfALocalLightLeavesNoDirectLight) {
  Floor floor;
  floor.addRoof(0.6f);  // its shadow under a light two metres above it: 2.7 m to each side
  const Shot none = stage().render(floor.level.scene, floor.camera, {});
  for (const scene::LightView& light : {pointLight({0, 9, 0}, 500), spotLight({0, 9, 0}, {0, 0, 0}, 500, 0.9f)}) {
    const Shot shot = stage().render(floor.level.scene, floor.camera, {light});
    EXPECT_EQ(shot.at(32, 32), none.at(32, 32));
    EXPECT_GT(radianceAt(floor.camera, shot, {0, 0, -5.5f}).r, 0.2f) << "beyond the roof's shadow";
  }
}

TEST_F(LightingTest, PointLightFallsOffWithDistanceRangeAndCone) {
  Floor floor;
  const Shot none = stage().render(floor.level.scene, floor.camera, {});
  const glm::vec3 place(0.3f, 0, 0.4f);
  const auto direct = [&](const scene::LightView& light) {
    return radianceAt(floor.camera, stage().render(floor.level.scene, floor.camera, {light}), place).r -
           radianceAt(floor.camera, none, place).r;
  };
  const float far = direct(pointLight(place + glm::vec3(0, 4, 0), 10)),
              near = direct(pointLight(place + glm::vec3(0, 2, 0), 10));
  EXPECT_NEAR(near / far, 4, 0.02);
  scene::LightView ranged = pointLight(place + glm::vec3(0, 2, 0), 10);
  ranged.light.range = 3.0f;
  EXPECT_NEAR(direct(ranged) / near, 1 - std::pow(2.0 / 3.0, 4), 0.01) << "KHR_lights_punctual's window";
  ranged.light.range = 1.5f;
  EXPECT_EQ(direct(ranged), 0);
  // Inside the inner cone a spot light is a point light; outside the outer one it is dark.
  EXPECT_NEAR(direct(spotLight(place + glm::vec3(0, 2, 0), place, 10, 0.5f)) / near, 1, 1e-4);
  EXPECT_EQ(direct(spotLight(place + glm::vec3(0, 2, 0), place + glm::vec3(2, 0, 0), 10, 0.5f)), 0);
}

// Cones from a hundredth of a degree to half a sphere, with a soft and a hard edge, from a slant: where a cone is full
// it is as bright as a point light, and KHR_lights_punctual's falloff is met in every pixel; no shadow of the floor on
// itself.
TEST_F(LightingTest, ConesOfAnyWidthAreFullInside) {
  Floor floor;
  const glm::vec3 place(0.3f, 0, 0.4f), lamp = place + glm::vec3(1.2f, 2.4f, -0.9f);
  constexpr double kRadians = 3.14159265358979 / 180;
  for (const double degrees : {0.01, 0.2, 1.0, 2.0, 3.0, 20.0, 60.0, 90.0})
    for (const double share : {0.5, 1.0}) {
      const double outer = degrees * kRadians, inner = share * outer;
      // So that the cone is a quarter of the picture's height.
      const scene::CameraView camera = lookAt({0.1f, 3, 2}, place, static_cast<float>(std::min(8 * outer, 1.2)));
      scene::LightView spot = spotLight(lamp, place, 10, static_cast<float>(outer));
      spot.light.innerConeAngle = static_cast<float>(inner);
      const Shot none = stage().render(floor.level.scene, camera, {});
      const Shot round = stage().render(floor.level.scene, camera, {pointLight(lamp, 10)});
      const Shot cone = stage().render(floor.level.scene, camera, {spot});
      const View view = makeView(camera, cone.width, cone.height);
      // Corners of the shadow filters' footprints, of either light, may touch the floor in maps of coarse texels.
      const double tolerance = degrees < 10 ? 0.01 : 0.12;
      int inside = 0, outside = 0, wrong = 0;
      for (std::uint32_t y = 0; y < cone.height; ++y)
        for (std::uint32_t x = 0; x < cone.width; ++x) {
          const glm::vec2 ndc = (glm::vec2(x, y) + 0.5f) / 32.0f - 1.0f;
          const glm::dvec3 ray(glm::dmat4(view.worldFromView) * glm::dvec4(ndc.x * double{view.viewFromClip[0][0]},
                                                                           ndc.y * double{view.viewFromClip[1][1]}, -1,
                                                                           0));
          const glm::dvec3 eye(view.eye), at = eye - ray * (eye.y / ray.y);
          if (ray.y >= 0 || std::max(std::abs(at.x), std::abs(at.z)) > 7.5) continue;
          const glm::dvec3 from = glm::normalize(at - glm::dvec3(lamp)),
                           axis = glm::normalize(glm::dvec3(spot.direction));
          const double angle = std::atan2(glm::length(glm::cross(from, axis)), glm::dot(from, axis));
          const double full = round.at(x, y).r - none.at(x, y).r, found = (cone.at(x, y).r - none.at(x, y).r) / full;
          if (full < 1e-3) continue;
          // A pixel's place is known to a thousandth of the cone or so.
          const auto falloff = [&](double a) {
            const double linear = inner < outer ? (std::cos(a) - std::cos(outer)) / (std::cos(inner) - std::cos(outer))
                                                : (a < outer ? 1.0 : 0.0);
            return std::pow(std::clamp(linear, 0.0, 1.0), 2);
          };
          const double low = falloff(angle + 0.01 * outer), high = falloff(angle - 0.01 * outer);
          inside += angle<0.98 * inner, outside += angle> 1.02 * outer;
          wrong += found < low - tolerance || found > high + tolerance;
        }
      EXPECT_GT(inside, 25) << degrees;
      EXPECT_GT(outside, degrees < 20 ? 100 : -1) << degrees;
      EXPECT_LE(wrong, degrees < 10 ? 0 : 30) << degrees << " degrees, inner " << share;
    }
}

TEST_F(LightingTest, ManyShadowedLightsAddUp) {
  Floor floor;
  floor.level.quad({0.5f, 1.5f, 0}, {0.4f, 0, 0}, {0, 0, -0.4f}, 0);
  std::vector<scene::LightView> lights{sun({0.3f, -1, 0.2f}, 3), pointLight({1, 4, 1}, 20)};
  for (int i = 0; i < 7; ++i) {
    const float a = 0.9f * static_cast<float>(i);
    lights.push_back(spotLight({3 * std::cos(a), 3, 3 * std::sin(a)}, {0, 0, 0}, 10, 0.5f));
    if (i % 2) lights.back().light.range = 6.0f;
  }
  const Shot all = stage().render(floor.level.scene, floor.camera, lights);
  EXPECT_EQ(std::count_if(all.passes.begin(), all.passes.end(),
                          [](const PassTime& p) { return p.name.starts_with("lighting"); }),
            3);
  // The sky belongs to the sun: render it once with the sun only and add what each local light adds.
  const Shot none = stage().render(floor.level.scene, floor.camera, {}),
             sunny = stage().render(floor.level.scene, floor.camera, {lights[0]});
  std::vector<glm::vec4> sum = sunny.color;
  for (std::size_t i = 1; i < lights.size(); ++i) {
    const Shot one = stage().render(floor.level.scene, floor.camera, {lights[i]});
    for (std::size_t p = 0; p < sum.size(); ++p) sum[p] += one.color[p] - none.color[p];
  }
  for (std::size_t p = 0; p < sum.size(); ++p)
    ASSERT_NEAR(all.color[p].g, sum[p].g, 2e-4 + 1e-3 * sum[p].g) << "pixel " << p;
}

TEST_F(LightingTest, APointLightsSixFacesEachShadowTheirSide) {
  Level level;
  const std::int32_t wall = level.material(Level::grey(188));
  for (int face = 0; face < 6; ++face) {
    glm::vec3 d(0), u(0), v(0);
    d[face / 2] = face % 2 ? -1.0f : 1.0f;
    u[(face / 2 + 1) % 3] = 1;
    v = glm::cross(-d, u);
    level.quad(5.0f * d, 5.0f * u, 5.0f * v, wall);
    level.quad(2.0f * d, 0.5f * u, 0.5f * v, wall);
  }
  const scene::LightView light = pointLight({0, 0, 0}, 30);
  for (int face = 0; face < 6; ++face) {
    glm::vec3 d(0), u(0);
    d[face / 2] = face % 2 ? -1.0f : 1.0f;
    u[(face / 2 + 1) % 3] = 1;
    const scene::CameraView camera = lookAt(2.2f * u, 2.2f * u + 4.9f * d, 1.6f);
    const Shot dark = stage().render(level.scene, camera, {}), shot = stage().render(level.scene, camera, {light});
    const glm::vec3 behind = 5.0f * d, beside = 5.0f * d + 2.5f * u;
    EXPECT_EQ(radianceAt(camera, shot, behind), radianceAt(camera, dark, behind)) << "face " << face;
    EXPECT_GT(radianceAt(camera, shot, beside).r, radianceAt(camera, dark, beside).r + 0.1f) << "face " << face;
  }
}

TEST_F(LightingTest, NoAcneOnTiltedSurfacesAndNoLeaks) {
  // A floor lit at a grazing angle shadows nothing: each pixel must have all of its light.
  for (const float slope : {1.0f, 0.3f, 0.1f}) {
    Floor floor;
    const scene::LightView light = sun({1, -slope, 0.3f}, 10);
    Stage::Options options;
    options.settings.shadowResolution = 256;
    const Shot shot = stage().render(floor.level.scene, floor.camera, {light}, options);
    const double cosine = -glm::normalize(light.direction).y;
    int lit = 0;
    for (std::size_t p = 0; p < shot.color.size(); ++p) {
      if (shot.distance[p] > 50) continue;
      ++lit;
      ASSERT_GT(shot.color[p].r, 0.8 * 10 * cosine * linearFromSrgb(188) / 3.1416)
          << "slope " << slope << ", pixel " << p;
    }
    EXPECT_GT(lit, 1000);
  }
}

}  // namespace
}  // namespace tyndall::render::test
