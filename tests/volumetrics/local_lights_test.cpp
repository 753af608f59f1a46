// Spot and point lights on the CPU: blocks, what reaches the view, layouts and passes left out.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "lib/cpp.hpp"
#include "registry.hpp"
#include "stages/local_lights.hpp"
#include "tyndall/plugin.h"

extern "C" const TyPlugin tyndall_plugin;

namespace volumetrics {
namespace {

std::vector<std::string> lines;
void keep(void*, std::uint32_t, const char* line) { lines.emplace_back(line); }

TyLight spotLight(const glm::vec3& position, const glm::vec3& direction, float outer, float range) {
  TyLight light{};
  light.struct_size = sizeof(light);
  light.kind = TY_LIGHT_SPOT;
  for (int i = 0; i < 3; ++i)
    light.position[i] = position[i], light.direction[i] = direction[i], light.radiance[i] = 10;
  light.range = range;
  light.cos_inner = std::cos(0.5f * outer);
  light.cos_outer = std::cos(outer);
  light.cone_inner = 0.5f * outer;
  light.cone_outer = outer;
  light.face_count = 1;
  light.shadow_size = 512;
  for (int i = 0; i < 4; ++i) light.shadow_clip_from_world[0][i * 5] = 1;
  return light;
}

RayBlock frustum(const glm::vec3& eye, const glm::vec3& forward, float zfar) {
  RayBlock rays{};
  rays.eye = eye;
  rays.forward = glm::normalize(forward);
  const glm::vec3 right = glm::normalize(glm::cross(rays.forward, glm::vec3(0.1f, 1, 0)));
  rays.right = 0.9f * right;
  rays.up = 0.5f * glm::cross(right, rays.forward);
  rays.znear = 0.1f;
  rays.zfar = zfar;
  return rays;
}

/// Layout and one prepared frame of ray_march through the exported tables.
struct Frame : testing::Test {
  std::uint32_t count = 0;
  const TyParameter* table = tyndall_plugin.parameters(&count);
  std::vector<double> values;
  TyInstance* instance = tyndall_plugin.create();
  const TyLayout* layout = nullptr;
  std::vector<std::uint8_t> skip;
  std::uint32_t stride = 1;
  TyHost host{};

  Frame() {
    for (std::uint32_t i = 0; i < count; ++i) values.push_back(table[i].default_value);
    technique("ray_march");
    lines.clear();
    host.struct_size = sizeof(host);
    host.abi_version = TY_ABI_VERSION;
    host.log = keep;
    tyndall_plugin.init(&host);
  }
  ~Frame() override {
    tyndall_plugin.destroy(instance);
    tyndall_plugin.shutdown();
  }
  void technique(const std::string& name) {
    for (std::uint32_t i = 0; i < count; ++i)
      if (std::string(table[i].id) == "volumetrics.technique")
        for (std::uint32_t c = 0; c < table[i].choice_count; ++c)
          if (name == table[i].choices[c]) values[i] = c;
  }
  void ask(const std::vector<std::uint32_t>& kinds, std::vector<std::uint32_t> cookies = {}) {
    TyDevice device{};
    device.struct_size = sizeof(device);
    device.max_push_descriptors = 32;
    const std::vector<std::uint32_t> sizes(kinds.size(), 512);
    TyStructure s{};
    s.struct_size = sizeof(s);
    s.width = 64;
    s.height = 36;
    s.light_count = static_cast<std::uint32_t>(kinds.size());
    s.light_kinds = kinds.data();
    s.shadow_sizes = sizes.data();
    cookies.resize(kinds.size());
    s.light_cookies = cookies.data();
    s.values = values.data();
    s.value_count = count;
    layout = tyndall_plugin.layout(instance, &device, &s);
    ASSERT_NE(layout, nullptr);
  }
  void prepare(const std::vector<TyLight>& lights) {
    std::vector<std::uint32_t> kinds;
    for (const TyLight& light : lights) kinds.push_back(light.kind);
    ask(kinds);
    stride = std::max<std::uint32_t>(1, static_cast<std::uint32_t>(lights.size()));
    std::vector<std::vector<std::uint8_t>> memory;
    std::vector<std::uint8_t*> data;
    std::vector<std::uint32_t> strides;
    for (std::uint32_t i = 0; i < layout->uniform_count; ++i) {
      memory.emplace_back(std::size_t{layout->uniforms[i].size} * stride);
      data.push_back(memory.back().data());
      strides.push_back(layout->uniforms[i].size);
    }
    skip.assign(std::size_t{layout->pass_count} * stride, 0);
    TyView view{};
    view.width = 64;
    view.height = 36;
    view.znear = 0.1f;
    view.zfar = 100;
    view.clip_from_view[0] = view.clip_from_view[5] = 1;
    for (int i = 0; i < 4; ++i) view.world_from_view[i * 5] = 1;
    TyFrame frame{};
    frame.view = &view;
    frame.lights = lights.data();
    frame.light_count = static_cast<std::uint32_t>(lights.size());
    frame.values = values.data();
    frame.value_count = count;
    const TyUniformData out{sizeof(TyUniformData), layout->uniform_count, data.data(),
                            strides.data(),        skip.data(),           stride};
    ASSERT_TRUE(tyndall_plugin.prepare(instance, &frame, &out));
  }
  const TyPass* pass(const std::string& name) const {
    for (std::uint32_t i = 0; i < layout->pass_count; ++i)
      if (name == layout->passes[i].name) return &layout->passes[i];
    return nullptr;
  }
  bool skipped(const std::string& name, std::uint32_t light = 0) const {
    return skip[static_cast<std::size_t>(pass(name) - layout->passes) * stride + light] != 0;
  }
  bool writesAlone(const std::string& name) const { return pass(name)->specializations[0].value == 1; }
};

const glm::vec3 kAhead{0, 0, -5}, kBehind{0, 0, 30}, kAway{0, 0, 1};

}  // namespace

TEST(LocalLights, BlockIsRelativeToTheEye) {
  const glm::vec3 eye(1000, 20, -3000);
  TyLight light = spotLight({1003, 22, -3001}, {0, -1, 0}, 0.6f, 7);
  const glm::mat4 clip = glm::perspective(1.2f, 1.0f, 0.1f, 9.0f) *
                         glm::lookAt(glm::vec3(1003, 22, -3001), glm::vec3(1003, 0, -3001), glm::vec3(1, 0, 0));
  std::memcpy(light.shadow_clip_from_world[0], &clip[0][0], sizeof clip);
  const LocalBlock block = localBlock(light, eye);
  EXPECT_EQ(block.position, glm::vec3(3, 2, -1));
  EXPECT_EQ(block.kind, kLocalSpot);
  const glm::vec3 point(2.5f, -1, -0.5f), w = point - block.position;
  const glm::dvec4 h = glm::dmat4(clip) * glm::dvec4(glm::dvec3(eye) + glm::dvec3(point), 1);
  const float along = glm::dot(w, block.axis);
  EXPECT_NEAR(glm::dot(block.faceX[0], w) / along, h.x / h.w, 1e-4);
  EXPECT_NEAR(glm::dot(block.faceY[0], w) / along, h.y / h.w, 1e-4);
  EXPECT_NEAR(block.depthScale - block.depthOffset / along, h.z / h.w, 1e-5);
  // Cone: 1 up to the inner angle, 0 from the outer one.
  const auto cone = [&](float angle) {
    return std::clamp((block.coneOuter - (1 - std::cos(angle))) * block.coneScale, 0.0f, 1.0f);
  };
  EXPECT_NEAR(cone(0.3f), 1, 1e-5);
  EXPECT_NEAR(cone(0.6f), 0, 1e-5);
  // A host of before the angles has cosines alone.
  TyLight older = light;
  older.struct_size = offsetof(TyLight, cone_inner);
  EXPECT_NEAR(localBlock(older, eye).coneOuter, block.coneOuter, 1e-6);
  EXPECT_NEAR(localBlock(older, eye).coneScale, block.coneScale, 1e-3 * block.coneScale);
  light.kind = TY_LIGHT_POINT;
  EXPECT_EQ(localBlock(light, eye).coneScale, 1);
  EXPECT_EQ(localBlock(light, eye).coneOuter, 1);
}

// Never a light left out that a view ray meets; and most of those that none meets are.
TEST(LocalLights, ReachesViewAgreesWithSampledRays) {
  std::mt19937 source(3);
  std::normal_distribution<float> normal;
  std::uniform_real_distribution<float> uniform;
  const auto vector = [&] { return glm::vec3(normal(source), normal(source), normal(source)); };
  int unreached = 0, leftOut = 0;
  for (int i = 0; i < 3000; ++i) {
    const RayBlock rays = frustum(2.0f * vector(), vector(), 5 + 30 * uniform(source));
    TyLight light = spotLight(8.0f * vector(), glm::normalize(vector()), 0.05f + 1.5f * uniform(source),
                              uniform(source) < 0.3f ? 0 : 8 * uniform(source));
    if (uniform(source) < 0.4f) light.kind = TY_LIGHT_POINT;
    const LocalBlock block = localBlock(light, rays.eye);
    bool met = false;
    for (int k = 0; k < 3000 && !met; ++k) {
      const float x = 2 * uniform(source) - 1, y = 2 * uniform(source) - 1, t = rays.zfar * uniform(source);
      const glm::vec3 w = t * (rays.forward + x * rays.right + y * rays.up) - block.position;
      using namespace tyndall::lib::f32;
      const float versine = block.kind == kLocalSpot ? versineToAxis(w, block.axis, glm::dot(w, w), 0) : 0;
      met = localAttenuation(glm::dot(w, w), block.range, versine, block.coneOuter, block.coneScale) > 0;
    }
    const bool reaches = reachesView(block, rays);
    EXPECT_TRUE(reaches || !met) << i;
    unreached += !met;
    leftOut += !reaches;
  }
  std::printf("%d lights met no sampled ray, %d were left out\n", unreached, leftOut);
  EXPECT_GT(leftOut, unreached * 7 / 10);
}

TEST_F(Frame, AllKindsOfLightAddUp) {
  ask({TY_LIGHT_DIRECTIONAL, TY_LIGHT_SPOT, TY_LIGHT_POINT});
  EXPECT_EQ(pass("clear")->per_light, 0u);
  EXPECT_EQ(pass("march")->light_kinds, 1u << TY_LIGHT_DIRECTIONAL);
  EXPECT_EQ(pass("march local")->light_kinds, 1u << TY_LIGHT_SPOT | 1u << TY_LIGHT_POINT);
  EXPECT_FALSE(writesAlone("march"));
  EXPECT_FALSE(writesAlone("march local"));
  // One light of any kind writes the result itself.
  ask({TY_LIGHT_DIRECTIONAL});
  EXPECT_TRUE(writesAlone("march"));
  EXPECT_EQ(pass("clear"), nullptr);
  EXPECT_EQ(pass("march local"), nullptr);
  for (const std::uint32_t kind : {TY_LIGHT_SPOT, TY_LIGHT_POINT}) {
    ask({kind});
    EXPECT_TRUE(writesAlone("march local"));
    EXPECT_EQ(pass("march"), nullptr);
  }
  // Two of one kind add.
  ask({TY_LIGHT_POINT, TY_LIGHT_POINT});
  EXPECT_FALSE(writesAlone("march local"));
}

TEST_F(Frame, ALightThatReachesNoViewRayCostsNoPass) {
  TyLight seen = spotLight(kAhead, kAway, 0.5f, 10), unseen = spotLight(kBehind, kAway, 0.5f, 10), sun{};
  sun.direction[1] = -1;
  sun.shadow_size = 512;
  for (int i = 0; i < 4; ++i) sun.shadow_clip_from_world[0][i * 5] = 1;
  prepare({sun, seen, unseen});
  EXPECT_FALSE(skipped("march", 0));
  EXPECT_FALSE(skipped("march local", 1));
  EXPECT_TRUE(skipped("march local", 2));
  EXPECT_TRUE(skipped("debug dense march local", 2));
  EXPECT_FALSE(skipped("clear"));
  // The only light: either its pass or the clearing one writes the result.
  prepare({seen});
  EXPECT_FALSE(skipped("march local"));
  EXPECT_TRUE(skipped("clear"));
  prepare({unseen});
  EXPECT_TRUE(skipped("march local"));
  EXPECT_FALSE(skipped("clear"));
}

// A lamp near the eye is left to a march in the pass that writes the result: no rows are made for it.
TEST_F(Frame, ALampNearTheEyeCostsNoRows) {
  const TyLight beside = spotLight({0.3f, 0, 0}, {0, 0, -1}, 0.5f, 0),
                fading = spotLight({1.5f, 0, 0}, {0, 0, -1}, 0.5f, 0), far = spotLight(kAhead, kAway, 0.5f, 0);
  for (const Technique& each : techniques()) {
    technique(each.id);
    ask({TY_LIGHT_SPOT});
    if (!each.localLights || pass("rectify") == nullptr) continue;
    prepare({beside, fading, far});
    // Strengths of light rays have passes of their own by technique.
    EXPECT_TRUE(pass("strength") != nullptr || (pass("shine") != nullptr && pass("lit") != nullptr)) << each.id;
    for (const char* name : {"slices", "rectify", "unshadowed", "shine", "lit", "strength"}) {
      if (pass(name) == nullptr) continue;
      EXPECT_TRUE(skipped(name, 0)) << each.id << ' ' << name;
      EXPECT_FALSE(skipped(name, 1)) << each.id << ' ' << name;
      EXPECT_FALSE(skipped(name, 2)) << each.id << ' ' << name;
    }
    for (std::uint32_t light = 0; light < 3; ++light) EXPECT_FALSE(skipped("evaluate", light)) << each.id;
  }
}

// Levels without cookies neither bind one nor have its code in their pipelines.
TEST_F(Frame, ACookieCostsOnlyWhereALightHasOne) {
  const auto cookieOf = [&](const std::string& name) {
    const TyPass& march = *pass(name);
    const std::uint32_t bound = static_cast<std::uint32_t>(
        std::count_if(march.bindings, march.bindings + march.binding_count,
                      [](const TyBinding& b) { return b.source == TY_SOURCE_LIGHT_COOKIE; }));
    for (std::uint32_t i = 0; i < march.specialization_count; ++i)
      if (march.specializations[i].id == 1) {
        EXPECT_EQ(march.specializations[i].value, bound) << name;
      }
    return bound == 1;
  };
  for (const bool sun : {false, true})
    for (const bool point : {false, true}) {
      ask({TY_LIGHT_DIRECTIONAL, TY_LIGHT_DIRECTIONAL, TY_LIGHT_SPOT, TY_LIGHT_POINT},
          {0, sun ? 1u : 0u, 0, point ? 6u : 0u});
      for (const char* name : {"march", "debug dense march"}) EXPECT_EQ(cookieOf(name), sun) << name;
      for (const char* name : {"march local", "debug dense march local"}) EXPECT_EQ(cookieOf(name), point) << name;
    }
}

TEST_F(Frame, OnlyTechniquesThatLeaveASunsCookieOutSaySo) {
  for (const Technique& each : techniques()) {
    lines.clear();
    technique(each.id);
    ask({TY_LIGHT_DIRECTIONAL, TY_LIGHT_DIRECTIONAL}, {1, 0});
    ask({TY_LIGHT_DIRECTIONAL, TY_LIGHT_DIRECTIONAL}, {1, 0});
    ASSERT_EQ(lines.size(), each.localLights ? 0u : 1u) << each.id;
    if (each.localLights) continue;
    EXPECT_NE(lines[0].find("1 directional light(s) scatter without their cookie"), std::string::npos) << lines[0];
    EXPECT_NE(lines[0].find(each.id), std::string::npos) << lines[0];
  }
}

TEST_F(Frame, OnlyTechniquesWithoutLocalLightsSaySo) {
  EXPECT_TRUE(findTechnique("ray_march")->localLights);
  for (const Technique& each : techniques()) {
    lines.clear();
    technique(each.id);
    ask({TY_LIGHT_DIRECTIONAL});
    ask({TY_LIGHT_DIRECTIONAL, TY_LIGHT_SPOT, TY_LIGHT_POINT});
    ASSERT_EQ(lines.size(), each.localLights ? 0u : 1u) << each.id;
    if (each.localLights) continue;
    EXPECT_NE(lines[0].find("2 spot or point light(s)"), std::string::npos) << lines[0];
    EXPECT_NE(lines[0].find(each.id), std::string::npos) << lines[0];
  }
}

}  // namespace volumetrics
