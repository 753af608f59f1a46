#include "cellar_textures.hpp"
#include "hall_textures.hpp"
#include "levels/levels.hpp"
#include "town_parts.hpp"
#include "town_textures.hpp"

namespace tyndall::levels {
namespace {

using namespace town;

constexpr float kFar = 70.0f;  // metres: past the gate to the ground beyond
constexpr glm::vec4 kWhite{1};
constexpr glm::vec3 kBounced{0.010f, 0.008f, 0.006f};  ///< the lamps' light, come back from walls and cobbles

Materials addMaterials(LevelBuilder& level, const Cookies& cookies) {
  Materials m{};
  const Surface plain = plaster();
  m.cobbles = {level.material("cobbles", cobbles(), kWhite, kBounced), kCobbleTile};
  m.plaster = {level.material("plaster", plain, {0.74f, 0.72f, 0.68f, 1}, kBounced), kPlasterTile};
  const auto tinted = [&](const char* name, const glm::vec3& tint) {  // the same images, another lime wash
    scene::Material other = level.materialAt(m.plaster.material);
    other.name = name;
    other.baseColor = glm::vec4(tint, 1);
    other.emissive = tint * kBounced;
    return Coat{level.material(other), kPlasterTile};
  };
  m.ochre = tinted("ochre plaster", {0.72f, 0.52f, 0.28f});
  m.rose = tinted("rose plaster", {0.66f, 0.40f, 0.32f});
  m.rubble = {level.material("rubble", cellar::rubble(), kWhite, kBounced), cellar::kRubbleTile};
  m.brick = {level.material("brick", cellar::brick(), kWhite, kBounced), cellar::kBrickTile};
  m.dressed = {level.material("dressed stone", hall::dressed(), kWhite, kBounced), hall::kPillarTile};
  m.planks = {level.material("planks", hall::planks(), kWhite, kBounced), hall::kWoodTile};
  m.timber = {level.material("timber", hall::timber(), {0.6f, 0.58f, 0.55f, 1}, kBounced), hall::kWoodTile};
  m.tiles = {level.material("roof tiles", tiles()), kTileTile};
  m.rust = {level.material("tin", cellar::rust(), kWhite, kBounced), cellar::kRustTile};
  m.stripes = {level.material("striped cloth", stripes(), kWhite, 2.0f * kBounced), kStripeTile};
  m.cloth = {level.material("linen", cellar::sackcloth(), kWhite, kBounced), cellar::kSackTile};
  m.shutter = {level.plain("painted shutters", {0.09f, 0.16f, 0.14f}, 0.6f), 1};
  m.iron = level.plain("iron", {0.10f, 0.10f, 0.10f}, 0.5f, 0.6f);
  m.brass = level.plain("gilt", {0.85f, 0.62f, 0.26f}, 0.35f, 1.0f);
  m.darkGlass = level.plain("dark glass", {0.012f, 0.016f, 0.022f}, 0.08f);
  m.litRoom = level.glowing("lit room", {0.7f, 0.5f, 0.3f, 1}, {0.50f, 0.28f, 0.11f}, 0.9f);
  m.bulb = level.glowing("bulb", {1, 0.9f, 0.7f, 1}, {40.0f, 28.0f, 14.0f}, 0.4f, scene::AlphaMode::kBlend);
  m.lampGlass =
      level.glowing("lamp glass", {1, 0.85f, 0.6f, 0.2f}, {2.6f, 1.6f, 0.75f}, 0.3f, scene::AlphaMode::kBlend);
  m.leaded = level.pane("leaded window", cookies.leaded, {1.5f, 1.0f, 0.5f});
  m.paned = level.pane("paned window", cookies.paned, {1.5f, 0.95f, 0.45f});
  return m;
}

void addCameras(LevelBuilder& level) {
  level.camera("0 along the street", {0.7f, 1.65f, 10.5f}, {-0.25f, 3.1f, -12.0f}, 60, kFar);
  level.camera("1 from the balcony", {-2.75f, 5.0f, 5.6f}, {1.3f, 2.6f, -8.0f}, 62, kFar);
  level.camera("2 up at the lantern", {-0.7f, 1.5f, -0.6f}, {0.45f, 4.0f, -4.6f}, 68, kFar);
  const std::int32_t tour = level.camera("3 down the street", {0, 2, 8}, {0, 2, 0}, 62, kFar);
  level.animateTour(tour,
                    {{{0.2f, 1.9f, 9.6f}, {-0.4f, 3.0f, -6.0f}},
                     {{-0.9f, 2.3f, 4.5f}, {1.2f, 3.0f, -6.0f}},
                     {{-1.2f, 2.1f, -1.0f}, {0.8f, 3.4f, -9.0f}},
                     {{-1.4f, 2.4f, -7.5f}, {0.4f, 4.2f, -20.0f}},
                     {{-1.5f, 2.6f, -11.0f}, {-0.2f, 4.5f, -22.0f}},
                     {{-1.3f, 3.2f, -3.0f}, {0.4f, 3.4f, -16.0f}}},
                    24.0f);
}

}  // namespace

scene::Scene makeTown() {
  LevelBuilder level("town");
  const float elevation = glm::radians(kMoonElevation), azimuth = glm::radians(kMoonAzimuth);
  level.sun({glm::cos(elevation) * glm::sin(azimuth), glm::sin(elevation), -glm::cos(elevation) * glm::cos(azimuth)},
            {0.60f, 0.77f, 1.0f}, 1.0f, "moon");
  const Cookies cookies{level.texture(leadedWindow(), scene::Wrap::kClampToEdge),
                        level.texture(panedWindow(), scene::Wrap::kClampToEdge)};
  addCameras(level);
  const Materials m = addMaterials(level, cookies);
  addHouses(level, m, cookies);
  addRoofs(level, m);
  addGate(level, m);
  addBalconies(level, m);
  addAwnings(level, m);
  addStreet(level, m);
  addLamps(level, m);
  addSigns(level, m);
  return level.take();
}

}  // namespace tyndall::levels
