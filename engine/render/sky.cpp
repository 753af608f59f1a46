#include "sky.hpp"

namespace tyndall::render {

namespace {

// On a clear day the sky gives about 15 to 20 percent of the sun's irradiance: a mean radiance of about 0.05 of it per
// steradian. Blue above, pale at the horizon.
constexpr glm::vec3 kZenithPerLux{0.022f, 0.038f, 0.065f};
constexpr glm::vec3 kHorizonPerLux{0.068f, 0.074f, 0.080f};
// Ground of albedo 0.2 under the same sun at 30 degrees' elevation: E sin(30)/pi 0.2, slightly warm.
constexpr glm::vec3 kGroundPerLux{0.034f, 0.031f, 0.028f};
// A level without a sun is at night or indoors: enough to tell shapes from black at exposure 1.
constexpr glm::vec3 kNightSky{0.006f, 0.007f, 0.010f};

}  // namespace

void fillSky(shared::ViewBlock& block, const std::vector<scene::LightView>& lights) {
  glm::vec3 irradiance(0), brightest(0);
  block.towardsSun = glm::vec3(0, 1, 0);
  for (const scene::LightView& light : lights) {
    if (light.light.kind != scene::LightKind::kDirectional) continue;
    const glm::vec3 e = light.light.color * light.light.intensity;
    irradiance += e;
    if (glm::dot(e, glm::vec3(1)) <= glm::dot(brightest, glm::vec3(1))) continue;
    brightest = e;
    block.towardsSun = -glm::normalize(light.direction);
  }
  block.sunIrradiance = brightest;
  block.skyZenith = kNightSky + kZenithPerLux * irradiance;
  block.skyHorizon = kNightSky + kHorizonPerLux * irradiance;
  block.ground = 0.5f * kNightSky + kGroundPerLux * irradiance;
}

}  // namespace tyndall::render
