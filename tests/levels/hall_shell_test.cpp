// The hall is closed: light gets in where a window, the rose or the door is, and nowhere else.
#include <gtest/gtest.h>

#include "levels/hall_plan.hpp"
#include "levels/levels.hpp"
#include "triangles.hpp"

namespace tyndall::levels {
namespace {

using namespace hall;

/// Does the ray pass through the box, grown by a centimetre?
bool through(const Opening& opening, const glm::vec3& origin, const glm::vec3& direction) {
  const glm::vec3 a = (opening.min - 0.01f - origin) / direction, b = (opening.max + 0.01f - origin) / direction;
  const glm::vec3 near = glm::min(a, b), far = glm::max(a, b);
  return glm::max(glm::max(near.x, near.y), glm::max(near.z, 0.0f)) <= glm::min(far.x, glm::min(far.y, far.z));
}

bool throughAny(const glm::vec3& origin, const glm::vec3& direction) {
  for (const Opening& opening : openings()) {
    if (through(opening, origin, direction)) return true;
  }
  return false;
}

class HallShell : public testing::Test {
 protected:
  /// Floor, walls and roof only: furniture must not be what keeps the light out.
  std::vector<Triangle> shell_ =
      trianglesOf(makeHall(), 0, [](const scene::Node& node) { return node.name == "shell" || node.name == "floor"; });
  /// Anywhere under the roof, 5 cm from everything.
  static glm::vec3 inside(TestRandom& random) {
    const float x = random.range(-kHalfWidth + 0.05f, kHalfWidth - 0.05f);
    const float y = random.range(0.05f, roofY(x) - 0.05f);
    return {x, y, random.range(-kHalfLength + 0.05f, kHalfLength - 0.05f)};
  }
};

TEST_F(HallShell, NoRayLeavesButThroughAnOpening) {
  TestRandom random(1);
  int left = 0;
  for (int i = 0; i < 30000; ++i) {
    const glm::vec3 origin = inside(random), direction = random.direction();
    if (blocked(shell_, origin, direction)) continue;
    ++left;
    EXPECT_TRUE(throughAny(origin, direction)) << origin.x << ' ' << origin.y << ' ' << origin.z << " to "
                                               << direction.x << ' ' << direction.y << ' ' << direction.z;
  }
  // Openings are about 5% of the inner surface: the test must have seen them.
  EXPECT_GT(left, 300);
  EXPECT_LT(left, 3000);
}

/// Leaks hide where parts meet, which random rays seldom hit: aim at the seams.
TEST_F(HallShell, SeamsAreTight) {
  TestRandom random(2);
  // Half the rays within 2 mm of the seam, half within 20 cm, where parts that should overlap have missed each other.
  const auto aim = [&](const glm::vec3& from, const glm::vec3& to) {
    for (int i = 0; i < 1600; ++i) {
      const glm::vec3 origin = inside(random);
      const float reach = i % 2 == 0 ? 0.002f : 0.2f;
      const glm::vec3 target = glm::mix(from, to, random.range(0, 1)) + reach * random.direction();
      const glm::vec3 direction = glm::normalize(target - origin);
      if (!blocked(shell_, origin, direction)) {
        EXPECT_TRUE(throughAny(origin, direction)) << "at " << target.x << ' ' << target.y << ' ' << target.z;
      }
    }
  };
  const float x = kHalfWidth, z = kHalfLength, eaves = roofY(x);
  for (const float side : {-1.0f, 1.0f}) {
    aim({side * x, 0, -z}, {side * x, 0, z});          // wall and floor
    aim({side * x, eaves, -z}, {side * x, eaves, z});  // wall and roof
    aim({-x, 0, side * z}, {x, 0, side * z});          // end wall and floor
    for (const float end : {-1.0f, 1.0f}) {
      aim({side * x, 0, end * z}, {side * x, eaves, end * z});  // corners
      aim({side * x, eaves, end * z}, {0, kRidge, end * z});    // gables
    }
    for (int bay = 1; bay < kBays; ++bay) {
      const float joint = -z + kBay * static_cast<float>(bay);
      aim({side * x, 0, joint}, {side * x, eaves, joint});  // panel and panel
    }
  }
  aim({0, kRidge, -z}, {0, kRidge, z});
}

TEST_F(HallShell, OpeningsAreOpen) {
  const std::vector<Opening> list = openings();
  ASSERT_EQ(list.size(), static_cast<std::size_t>(kBays) + 2);
  for (const Opening& opening : list) {
    const glm::vec3 middle = 0.5f * (opening.min + opening.max), size = opening.max - opening.min;
    glm::vec3 out{0};  // through the wall: the box's thin side
    const int axis = size.x < size.z ? 0 : 2;
    out[axis] = middle[axis] > 0 ? 1.0f : -1.0f;
    EXPECT_FALSE(blocked(shell_, middle - 2.0f * out, out)) << middle.x << ' ' << middle.y << ' ' << middle.z;
  }
}

/// Separate shafts: along the middle of the hall light and shade take turns, once a window.
TEST_F(HallShell, SunlightFallsInAsOneShaftAWindow) {
  const scene::Scene scene = makeHall();
  const std::vector<scene::LightView> lights = scene::placedLights(scene, 0);
  ASSERT_EQ(lights.size(), 1u);
  const glm::vec3 toSun = -lights[0].direction;
  const glm::vec2 across{toSun.x, toSun.y};
  // At x = 2 the windows' upper half is seen from a height of 3 m.
  int rises = 0, lit = 0, count = 0;
  bool before = false;
  for (float z = -17; z < 18.5f; z += 0.05f) {
    const glm::vec3 p{2.0f, 3.0f, z};
    const bool now = !blocked(shell_, p, toSun);
    if (now) {
      EXPECT_TRUE(throughAny(p, toSun)) << z;
    }
    rises += now && !before ? 1 : 0;
    lit += now ? 1 : 0;
    before = now;
    ++count;
  }
  EXPECT_GT(across.x, 0.5f);
  EXPECT_GE(rises, kBays - 1);
  EXPECT_LE(rises, kBays);
  EXPECT_GT(lit, count / 8);  // and the dark between is wider than the light
  EXPECT_LT(lit, count / 2);
}

}  // namespace
}  // namespace tyndall::levels
