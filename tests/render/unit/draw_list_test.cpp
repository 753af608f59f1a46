// Sorting, culling and the choice of shadow maps, without a GPU.
#include <random>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "culling.hpp"
#include "draw_list.hpp"
#include "light_plan.hpp"
#include "sky.hpp"

namespace tyndall::render {
namespace {

View defaultView() {
  scene::CameraView camera;  // at the origin, looks down -Z
  camera.camera.zfar = 100.0f;
  return makeView(camera, 100, 100);
}

TEST(DrawList, OrdersOpaqueFrontToBackAndBlendedBackToFront) {
  scene::Scene scene;
  SceneResources resources;
  resources.materials.resize(3);
  resources.materials[1].alphaMode = scene::AlphaMode::kBlend;
  resources.materials[2].alphaMode = scene::AlphaMode::kMask;
  std::vector<glm::mat4> matrices;
  for (int i = 0; i < 12; ++i) {
    DrawRange range;
    range.indexCount = 3;
    range.material = static_cast<std::uint32_t>(i % 3);
    range.bounds = {glm::vec3(-0.5f), glm::vec3(0.5f)};
    resources.meshes.push_back({range});
    scene.meshes.emplace_back();
    scene::Node node;
    node.mesh = i;
    scene.nodes.push_back(node);
    matrices.push_back(glm::translate(glm::mat4(1), {0, 0, -static_cast<float>((i * 7) % 12) - 2}));
  }
  const DrawList list = buildDrawList(scene, resources, matrices, {0, 0, 0});
  ASSERT_EQ(list.solid.size(), 8u);
  ASSERT_EQ(list.blended.size(), 4u);
  for (std::size_t i = 1; i < list.solid.size(); ++i) {
    const Draw &a = list.solid[i - 1], &b = list.solid[i];
    EXPECT_LE(a.mask, b.mask) << "one change of pipeline";
    if (a.mask == b.mask) {
      EXPECT_LE(a.distance, b.distance);
    }
  }
  for (std::size_t i = 1; i < list.blended.size(); ++i)
    EXPECT_GE(list.blended[i - 1].distance, list.blended[i].distance);
  // Casters: everything but the blended ones (z -9 -12 -3 -6 for those; solids reach from -2 to -13).
  EXPECT_FLOAT_EQ(list.casters.max.z, -1.5f);
}

TEST(DrawList, NormalsStayPerpendicularUnderAnyTransform) {
  scene::Scene scene;
  scene.meshes.emplace_back();
  scene.nodes.emplace_back();
  scene.nodes[0].mesh = 0;
  SceneResources resources;
  resources.materials.resize(1);
  DrawRange range;
  range.indexCount = 3;
  range.bounds = {glm::vec3(-1), glm::vec3(1)};
  resources.meshes.push_back({range});
  for (const glm::vec3 scale : {glm::vec3(2, 0.5f, 3), glm::vec3(-2, 0.5f, 3), glm::vec3(-1, -1, -1)}) {
    const glm::mat4 m = glm::scale(glm::rotate(glm::mat4(1), 0.7f, glm::normalize(glm::vec3(1, 2, 3))), scale);
    const DrawList list = buildDrawList(scene, resources, {m}, {0, 0, 0});
    const shared::InstanceBlock& block = list.instances[0];
    const glm::vec3 n = glm::normalize(glm::vec3(1, 1, 1)), t1(1, -1, 0), t2(0, 1, -1);
    const glm::vec3 turned = glm::mat3(block.normalX, block.normalY, block.normalZ) * n;
    EXPECT_NEAR(glm::dot(turned, glm::mat3(m) * t1), 0, 1e-5);
    EXPECT_NEAR(glm::dot(turned, glm::mat3(m) * t2), 0, 1e-5);
    EXPECT_GT(glm::dot(turned, glm::mat3(m) * n), 0) << "still outwards";
    EXPECT_EQ(block.mirrored != 0, scale.x * scale.y * scale.z < 0);
    EXPECT_EQ(list.solid[0].facing == Facing::kFrontMirrored, block.mirrored != 0);
  }
}

TEST(Culling, NeverDropsABoxWithAVisiblePoint) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> u(-30, 30), h(0, 5), s(0, 1);
  const View view = defaultView();
  const glm::mat4 m = view.clipFromView * view.viewFromWorld;
  int seen = 0, dropped = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::vec3 center(u(random), u(random), u(random)), half(h(random), h(random), h(random));
    const scene::Bounds box{center - half, center + half};
    bool visible = false, inPrism = false;
    for (int j = 0; j < 40; ++j) {
      const glm::vec4 c = m * glm::vec4(box.min + (box.max - box.min) * glm::vec3(s(random), s(random), s(random)), 1);
      const bool sides = c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w;
      inPrism = inPrism || sides;
      visible = visible || (sides && c.z >= 0 && c.z <= c.w);
    }
    if (visible) {
      EXPECT_TRUE(mayBeSeen(box, m, DepthPlanes::kBoth));
    }
    if (inPrism) {
      EXPECT_TRUE(mayBeSeen(box, m, DepthPlanes::kClamped));
    }
    seen += visible;
    dropped += !mayBeSeen(box, m, DepthPlanes::kBoth);
  }
  EXPECT_GT(seen, 200);
  EXPECT_GT(dropped, 1000) << "culling should cull";
}

TEST(Culling, DepthClampKeepsCastersBeforeTheMap) {
  glm::mat4 m(1);  // clip = world, depth 0..1
  EXPECT_FALSE(mayBeSeen({{-0.1f, -0.1f, -5}, {0.1f, 0.1f, -4}}, m, DepthPlanes::kBoth));
  EXPECT_TRUE(mayBeSeen({{-0.1f, -0.1f, -5}, {0.1f, 0.1f, -4}}, m, DepthPlanes::kClamped));
  EXPECT_FALSE(mayBeSeen({{1.1f, -0.1f, 0}, {1.2f, 0.1f, 0.5f}}, m, DepthPlanes::kClamped));
  EXPECT_FALSE(mayBeSeen(scene::Bounds{}, m, DepthPlanes::kClamped));
}

TEST(TransformBounds, HoldsTheTransformedCorners) {
  const scene::Bounds box{{-1, 2, -3}, {4, 5, 6}};
  const glm::mat4 m = glm::scale(
      glm::rotate(glm::translate(glm::mat4(1), {7, 8, 9}), 1.0f, glm::normalize(glm::vec3(1, 1, 2))), {1, -2, 3});
  scene::Bounds expected;
  for (const glm::vec3& c : boxCorners(box, {})) expected.add(glm::vec3(m * glm::vec4(c, 1)));
  const scene::Bounds got = transformBounds(box, m);
  EXPECT_LT(glm::distance(got.min, expected.min) + glm::distance(got.max, expected.max), 1e-4);
}

std::vector<scene::LightView> someLights() {
  std::vector<scene::LightView> lights(4);
  lights[0].light.kind = scene::LightKind::kPoint;
  lights[0].position = {0, 0, -50};
  lights[1].light.kind = scene::LightKind::kPoint;
  lights[1].light.intensity = 5;
  lights[1].position = {0, 0, -2};
  lights[1].light.name = "lamp";
  lights[2].light.kind = scene::LightKind::kSpot;
  lights[2].position = {0, 0, -5};
  return lights;  // the fourth is a sun
}

TEST(LightPlan, SunsFirstThenByIrradianceWithinTheBudget) {
  const scene::Bounds casters{glm::vec3(-5), glm::vec3(5)};
  const LightPlan all = planLights(defaultView(), someLights(), casters, 256);
  ASSERT_EQ(all.shadowed.size(), 4u);
  EXPECT_EQ(all.shadowed[0].source, 3u);
  EXPECT_EQ(all.shadowed[1].source, 1u);
  EXPECT_EQ(all.shadowed[2].source, 2u);
  EXPECT_TRUE(all.notes.empty());
}

// Nothing lights through walls: whatever the budget, a light has a map or is off, the stronger ones have the larger
// maps, and one line tells of all.
TEST(LightPlan, WeakerLightsGetSmallerMapsUntilAllHaveOne) {
  const scene::Bounds casters{glm::vec3(-5), glm::vec3(5)};
  std::vector<scene::LightView> lights;
  for (int i = 0; i < 60; ++i) {
    lights.emplace_back();
    lights.back().light.kind = i % 3 ? scene::LightKind::kPoint : scene::LightKind::kSpot;
    lights.back().light.intensity = static_cast<float>(1 + i * 7 % 60);
    lights.back().position = {0, 0, -2.0f - static_cast<float>(i)};
  }
  const std::uint64_t whole = 60ull * 6 * 256 * 256 * 4, least = 60ull * 6 * kLeastShadowSide * kLeastShadowSide * 4;
  for (const std::uint64_t budget : {whole, whole / 2, whole / 5, whole / 20, least, least / 3, std::uint64_t{0}}) {
    const LightPlan plan = planLights(defaultView(), lights, casters, 256, budget);
    ASSERT_EQ(plan.shadowed.size() + plan.unshadowed.size(), lights.size());
    std::uint64_t used = 0;
    std::uint32_t smallest = 256, largest = 0;
    for (std::size_t i = 0; i < plan.shadowed.size(); ++i) {
      const PlannedLight& light = plan.shadowed[i];
      EXPECT_EQ(plan.blocks[i].shadowSize, static_cast<float>(light.size));
      used += (lights[light.source].light.kind == scene::LightKind::kPoint ? 6ull : 1ull) * light.size * light.size * 4;
      smallest = std::min(smallest, light.size), largest = std::max(largest, light.size);
      for (const PlannedLight& other : plan.shadowed)
        if (lights[other.source].light.intensity > lights[light.source].light.intensity) {
          EXPECT_GE(other.size, light.size);
        }
    }
    EXPECT_LE(used, budget);
    if (!plan.shadowed.empty()) {
      EXPECT_LE(largest, 2 * smallest);
    }
    EXPECT_EQ(plan.unshadowed.empty(), budget >= least) << budget;
    for (std::size_t i = plan.shadowed.size(); i < lights.size(); ++i)
      EXPECT_EQ(plan.blocks[i].core.intensity, glm::vec3(0)) << "off";
    EXPECT_EQ(plan.notes.size(), std::size_t{smallest < 256} + !plan.unshadowed.empty()) << budget;
    // Sides do not hang on the camera: they are a part of an effect's layout.
    scene::CameraView elsewhere;
    elsewhere.worldFromView[3] = glm::vec4(0, 0, -60, 1);
    for (const PlannedLight& there : planLights(makeView(elsewhere, 64, 64), lights, casters, 256, budget).shadowed)
      for (const PlannedLight& here : plan.shadowed)
        if (here.source == there.source) {
          EXPECT_EQ(here.size, there.size);
        }
  }
}

TEST(Reach, HoldsTheLitPixels) {
  const View view = defaultView();
  scene::LightView light = someLights()[1];
  EXPECT_EQ(reach(view, light).x1, 100) << "no range: everywhere";
  light.position = {1, 2, -20};
  light.light.range = 3.0f;
  const PixelRect rect = reach(view, light);
  EXPECT_GT(rect.x0, 0);
  EXPECT_LT(rect.x1 - rect.x0, 60);
  std::mt19937 random(2);
  std::normal_distribution<float> n;
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 p = light.position + 3.0f * glm::normalize(glm::vec3(n(random), n(random), n(random)));
    const glm::vec4 c = view.clipFromView * view.viewFromWorld * glm::vec4(p, 1);
    const glm::vec2 pixel = (glm::vec2(c) / c.w * 0.5f + 0.5f) * 100.0f;
    if (glm::any(glm::lessThan(pixel, glm::vec2(0))) || glm::any(glm::greaterThan(pixel, glm::vec2(100)))) continue;
    EXPECT_GE(pixel.x, static_cast<float>(rect.x0));
    EXPECT_LE(pixel.x, static_cast<float>(rect.x1));
    EXPECT_GE(pixel.y, static_cast<float>(rect.y0));
    EXPECT_LE(pixel.y, static_cast<float>(rect.y1));
  }
  light.position = {0, 0, 30};
  EXPECT_TRUE(reach(view, light).empty()) << "behind the eye";
  light.position = {0, 0, 0};
  EXPECT_EQ(reach(view, light).y1, 100) << "around the eye";
}

TEST(Sky, GrowsWithTheSunAndStaysModest) {
  shared::ViewBlock block{};
  scene::LightView light;
  light.light.intensity = 100;
  light.direction = {0, -1, 0};
  fillSky(block, {light});
  EXPECT_EQ(block.towardsSun, glm::vec3(0, 1, 0));
  // Irradiance of a uniform sky halfway between zenith and horizon: 10 to 25 percent of the sun's, as on a clear day.
  const float irradiance = 3.1416f * 0.5f * (block.skyZenith.g + block.skyHorizon.g);
  EXPECT_GT(irradiance, 10);
  EXPECT_LT(irradiance, 25);
  fillSky(block, {});
  EXPECT_LT(block.skyZenith.b, 0.02f) << "no sun: night";
}

}  // namespace
}  // namespace tyndall::render
