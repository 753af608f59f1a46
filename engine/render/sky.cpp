#include "sky.hpp"

namespace tyndall::render {

namespace {

// On a clear day the sky gives about 15 to 20 percent of the sun's irradiance, a mean radiance of about 0.05 of it per
// steradian. That light is not shadowed here (only by occlusion maps), so interiors would glow with all of it: a third is
// used, and the visible sky has the same radiance, so that picture and light agree. Colours: blue above, pale at the horizon.
constexpr glm::vec3 kZenithPerLux{0.010f, 0.019f, 0.036f};
constexpr glm::vec3 kHorizonPerLux{0.034f, 0.040f, 0.046f};
// Ground of albedo 0.2 under the same sun at 30 degrees' elevation, E sin(30)/pi, of which the same third is used.
constexpr glm::vec3 kGroundPerLux{0.011f, 0.010f, 0.009f};
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
