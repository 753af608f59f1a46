#include "hall_parts.hpp"
#include "hall_textures.hpp"
#include "levels/levels.hpp"

namespace tyndall::levels {
namespace {

using namespace hall;

// What comes back from floor and walls under the windows: the sky itself does not reach the hall's far side.
constexpr glm::vec3 kBounced{0.13f, 0.115f, 0.095f};
constexpr float kFar = 100.0f;  // metres: the hall's diagonal twice over, so that views out of a window end in mist

std::int32_t emissive(LevelBuilder& level, const std::string& name, const glm::vec3& color, const glm::vec3& light) {
  scene::Material m;
  m.name = name;
  m.baseColor = glm::vec4(color, 1);
  m.metallic = 0;
  m.roughness = 0.6f;
  m.emissive = light;
  return level.material(m);
}

std::int32_t cloth(LevelBuilder& level, const std::string& name, const Surface& surface) {
  scene::Material m;
  m.name = name;
  m.metallic = 0;
  m.roughness = 0.92f;
  m.doubleSided = true;
  m.baseColorTexture.texture = level.texture(surface.colorImage(name + " colour"));
  m.normalTexture.texture = level.texture(surface.normalImage(name + " normal"));
  return level.material(m);
}

Materials addMaterials(LevelBuilder& level) {
  Materials m{};
  m.ashlar = level.material("ashlar", ashlar(), glm::vec4(1), kBounced);
  m.flags = level.material("floor tiles", flags(), glm::vec4(1), kBounced);
  m.dressed = level.material("dressed stone", dressed(), glm::vec4(1), kBounced);
  m.planks = level.material("planks", planks(), glm::vec4(1), kBounced);
  m.timber = level.material("timber", timber(), glm::vec4(1), kBounced);
  m.runner = level.material("runner", runner(), glm::vec4(1), kBounced);
  m.bannerSun = cloth(level, "banner with a sun", banner({0.52f, 0.075f, 0.085f}, {0.86f, 0.68f, 0.28f}, 0));
  m.bannerCross = cloth(level, "banner with a cross", banner({0.085f, 0.16f, 0.42f}, {0.83f, 0.80f, 0.70f}, 1));
  m.iron = level.plain("iron", {0.16f, 0.155f, 0.15f}, 0.55f, 0.6f);
  m.gold = level.plain("brass", {0.78f, 0.57f, 0.26f}, 0.35f, 1.0f);
  m.wax = level.plain("wax", {0.82f, 0.75f, 0.58f}, 0.5f);
  m.earth = level.plain("grass outside", {0.13f, 0.16f, 0.07f}, 1.0f);
  m.flame = emissive(level, "flame", {1, 0.8f, 0.4f}, glm::vec3(9.0f, 4.6f, 1.4f));
  m.lamp = emissive(level, "lamp", {1, 0.8f, 0.5f}, glm::vec3(3.4f, 1.9f, 0.7f));
  scene::Material glass;
  glass.name = "stained glass";
  glass.metallic = 0;
  glass.roughness = 0.15f;
  glass.alphaMode = scene::AlphaMode::kBlend;
  glass.doubleSided = true;
  glass.baseColorTexture.texture = level.texture(stainedGlass());
  m.glass = level.material(glass);
  return m;
}

void addCameras(LevelBuilder& level) {
  level.camera("0 nave, shafts across", {-3.2f, 1.65f, 7.3f}, {4.8f, 3.05f, -6.2f}, 58, kFar);
  level.camera("1 towards the windows", {-3.2f, 1.5f, 2.4f}, {7.0f, 5.9f, -3.6f}, 68, kFar);
  level.camera("2 from the gallery", {-2.6f, 5.9f, 17.2f}, {1.4f, 2.9f, 2.0f}, 60, kFar);
  const std::int32_t tour = level.camera("3 tour", {0, 2, 10}, {0, 3, 0}, 60, kFar);
  level.animateTour(tour,
                    {{{0.0f, 1.8f, 12.0f}, {0.5f, 3.2f, -8.0f}},
                     {{-1.0f, 2.2f, 5.0f}, {5.0f, 4.5f, -6.0f}},
                     {{0.0f, 2.6f, -4.0f}, {6.0f, 5.0f, -9.0f}},
                     {{-0.4f, 3.0f, -11.0f}, {-4.0f, 3.0f, -3.0f}},
                     {{-5.0f, 2.2f, -6.2f}, {2.0f, 3.4f, 4.0f}},
                     {{-5.2f, 2.0f, 5.6f}, {3.0f, 3.4f, 0.0f}}},
                    24.0f);
}

}  // namespace

scene::Scene makeHall() {
  LevelBuilder level("hall");
  const float elevation = glm::radians(kSunElevation), slant = glm::radians(kSunSlant);
  const glm::vec3 toSun{glm::cos(elevation) * glm::cos(slant), glm::sin(elevation),
                        -glm::cos(elevation) * glm::sin(slant)};
  level.sun(toSun, {1.0f, 0.86f, 0.66f}, 10.0f);
  addCameras(level);
  Materials m = addMaterials(level);
  m.darkTimber = m.timber;
  addShell(level, m);
  addTracery(level, m);
  addPillars(level, m);
  addTimber(level, m);
  addGallery(level, m);
  addFurniture(level, m);
  addHangings(level, m);
  addDoor(level, m);
  return level.take();
}

}  // namespace tyndall::levels
