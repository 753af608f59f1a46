// Lamps from the eye itself to more than a metre from it, and beams of a hundredth of a degree: every technique that
// scatters lamps against a dense march, and the march against the truth. Figures are printed.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "app/catalogue.hpp"
#include "laboratory.hpp"
#include "lamp_level.hpp"
#include "scene/gltf.hpp"
#include "scene/write_glb.hpp"
#include "truth/truth.hpp"

namespace tyndall::local_lights {
namespace {

using figures::operator+;
using figures::errorOf;
using figures::Laboratory;
using figures::Settings;
using scene::LightKind;

const glm::vec3 kEye{0, 2, 8};  // of lamp_level.hpp
const Settings kSmall = {"volumetrics.columns=256", "volumetrics.slices=256", "shadows.resolution=1024"};

/// The level with its lamp at `places`, one a second.
std::string moving(const std::string& name, const Lamp& lamp, const std::vector<Bar>& bars,
                   const std::vector<glm::vec3>& places) {
  const std::string path = writeLevel(name, {lamp}, bars);
  auto level = scene::loadGltf(path);
  if (!level) throw std::runtime_error(level.error().message);
  scene::AnimationChannel channel{static_cast<std::int32_t>(level->scene.nodes.size()) - 1,
                                  scene::AnimationTarget::kTranslation,
                                  scene::Interpolation::kStep,
                                  {},
                                  {}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    channel.times.push_back(static_cast<float>(i));
    channel.values.emplace_back(places[i], 0);
  }
  // The animation begins anew at its last key.
  channel.times.push_back(static_cast<float>(places.size()));
  channel.values.emplace_back(places.back(), 0);
  level->scene.animations = {{"steps", channel.times.back(), {channel}}};
  if (const auto written = scene::writeGlb(level->scene, path); !written)
    throw std::runtime_error(written.error().message);
  return path;
}

/// All that are registered but the march, and but those that leave lamps out (and give nothing at all).
const std::vector<std::string>& lampTechniques(Laboratory& lab) {
  static std::vector<std::string> ids;
  if (!ids.empty()) return ids;
  for (const host::TechniqueInfo& each : lab.session().catalogue().effectPlugin().techniques()) {
    const auto scatter = lab.shoot(kSmall + Settings{"volumetrics.technique=" + each.id}).scatter.values;
    double sum = 0;
    for (std::size_t i = 0; i < scatter.size(); ++i) sum += i % 4 == 3 ? 0 : scatter[i];
    if (each.id != "ray_march" && sum > 0) ids.push_back(each.id);
  }
  EXPECT_GE(ids.size(), 4u);
  return ids;
}

image::FloatImage traced(Laboratory& lab, double seconds, std::uint32_t width, std::uint32_t height) {
  const app::Level& level = *lab.session().level();
  truth::Settings settings;
  settings.width = width, settings.height = height;
  settings.samples = 512;
  settings.seconds = seconds;
  auto picture = truth::render(level.scene, level.cameras(seconds).at(0), level.lights(seconds), settings);
  if (!picture) throw std::runtime_error(picture.error().message);
  image::FloatImage result{width, height, 4, {}};
  for (const glm::vec4& p : picture->scatter) result.values.insert(result.values.end(), {p.r, p.g, p.b, p.a});
  return result;
}

struct Case {
  const char* name;
  LightKind kind;
  glm::vec3 side;  ///< where from the eye the lamp stands, length one
  bool cookie;
  std::optional<float> range;
  std::vector<float> distances;  ///< m; from 1.2 on the march near the eye fades into the rows
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

const Case kCases[] = {
    {"spot_beside", LightKind::kSpot, {0.86f, -0.5f, 0.1f}, false, {}, {0, 2e-4f, 0.002f, 0.05f, 1, 1.3f, 1.5f}},
    {"spot_behind", LightKind::kSpot, {0.1f, 0.1f, 0.99f}, true, 9.0f, {0, 0.001f, 1}},
    {"point_before", LightKind::kPoint, {0.1f, 0.2f, -0.97f}, false, {}, {0, 0.001f, 1.5f}}};

class NearTheEye : public testing::TestWithParam<Case> {};

TEST_P(NearTheEye, EveryTechniqueIsTheMarchWithoutAJump) {
  const Case& c = GetParam();
  const std::vector<float>& distances = c.distances;
  std::vector<glm::vec3> places;
  for (const float d : distances) places.push_back(kEye + d * c.side);
  Lamp lamp;
  lamp.kind = c.kind;
  lamp.position = kEye;
  lamp.towards = {-0.1f, -0.1f, -1};
  lamp.cookie = c.cookie;
  lamp.range = c.range;
  Laboratory lab(moving(std::string("near_") + c.name, lamp, slatsBefore(lamp, 1.8f), places), 0, 80, 45);
  const std::vector<std::string>& techniques = lampTechniques(lab);
  for (std::size_t i = 0; i < places.size(); ++i) {
    lab.at(static_cast<double>(i));
    const image::FloatImage march =
        lab.shoot(kSmall + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=2048"}).scatter;
    if (i % 2 == 0) {
      const double error = errorOf(march, traced(lab, static_cast<double>(i), 80, 45)).nRmse;
      std::printf("%-14s %.4f m  march against truth %.4f\n", c.name, distances[i], error);
      EXPECT_LT(error, 0.05) << distances[i];
    }
    for (const std::string& technique : techniques) {
      const double error =
          errorOf(lab.shoot(kSmall + Settings{"volumetrics.technique=" + technique}).scatter, march).nRmse;
      std::printf("%-14s %.4f m  %-10s nRMSE %.4f\n", c.name, distances[i], technique.c_str(), error);
      // Every one is within 0.1 up to a metre; beyond it a spot fades into what its rows leave.
      EXPECT_LT(error, distances[i] <= 1 ? 0.05 : 0.2) << technique << " at " << distances[i];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Lamps, NearTheEye, testing::ValuesIn(kCases),
                         [](const auto& each) { return std::string(each.param.name); });

// A narrow beam across the view, towards the eye and away from it. Its width is that of few pixels or none, so that it
// is looked at through a lens as narrow as itself.
TEST(NarrowBeams, EveryTechniqueHoldsThem) {
  struct Beam {
    double degrees;
    glm::vec3 from;
  };
  // Across the view, towards the eye.
  for (const auto& [degrees, from] : {Beam{0.01, {-4, 2.6f, 0}}, Beam{0.2, {1.5f, 2, -6}}}) {
    const glm::vec3 aim(0.2f, 2.1f, 1);
    Lamp lamp;
    lamp.position = from;
    lamp.towards = aim - from;
    lamp.outer = static_cast<float>(degrees * 3.14159265 / 180);
    lamp.inner = 0.5f * lamp.outer;
    const std::string path = writeLevel("beam", {lamp}, {});
    auto level = scene::loadGltf(path);
    ASSERT_TRUE(level) << level.error().message;
    // As wide as the beam where it is aimed at, times four.
    const float wide = 8 * lamp.outer * glm::distance(from, aim) / glm::distance(kEye, aim);
    level->scene.cameras[0].yfov = std::min(wide, 0.8f);
    for (scene::Node& node : level->scene.nodes)
      if (node.camera == 0) node.rotation = glm::quatLookAt(glm::normalize(aim - kEye), glm::vec3(0, 1, 0));
    ASSERT_TRUE(scene::writeGlb(level->scene, path));
    Laboratory lab(path, 0, 80, 45);
    const image::FloatImage truth = traced(lab, 0, 80, 45);
    const auto error = [&](const std::string& technique, const Settings& more) {
      const double found =
          errorOf(lab.shoot(kSmall + Settings{"volumetrics.technique=" + technique} + more).scatter, truth).nRmse;
      std::printf("%.2f degrees from (%.1f %.1f %.1f) %-10s nRMSE %.4f\n", degrees, from.x, from.y, from.z,
                  technique.c_str(), found);
      return found;
    };
    EXPECT_LT(error("ray_march", {"volumetrics.steps=512"}), 0.03) << degrees;
    for (const std::string& technique : lampTechniques(lab)) EXPECT_LT(error(technique, {}), 0.1) << degrees;
  }
}

}  // namespace
}  // namespace tyndall::local_lights
