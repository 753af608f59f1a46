// Vault and cage are closed: no ray that starts inside gets out, so no lamp's light does, and none comes in.
#include <functional>

#include <gtest/gtest.h>

#include "levels/cage_plan.hpp"
#include "levels/levels.hpp"
#include "levels/vault_plan.hpp"
#include "triangles.hpp"

namespace tyndall::levels {
namespace {

/// Floor, walls and ceiling only: furniture must not be what keeps the light in.
std::vector<Triangle> shellOf(const scene::Scene& scene) {
  return trianglesOf(scene, 0, [](const scene::Node& node) {
    return node.name == "shell" || node.name == "floor" || node.name == "well" || node.name == "chamber";
  });
}

struct Room {
  std::vector<Triangle> shell;
  std::function<glm::vec3(TestRandom&)> inside;

  void expectClosed(int rays) const {
    TestRandom random(1);
    for (int i = 0; i < rays; ++i) {
      const glm::vec3 origin = inside(random), direction = random.direction();
      ASSERT_TRUE(blocked(shell, origin, direction)) << origin.x << ' ' << origin.y << ' ' << origin.z << " to "
                                                     << direction.x << ' ' << direction.y << ' ' << direction.z;
    }
  }
  /// Leaks hide where parts meet: half the rays within 2 mm of the seam, half within 20 cm.
  void expectTight(const glm::vec3& from, const glm::vec3& to) const {
    TestRandom random(2);
    for (int i = 0; i < 1200; ++i) {
      const glm::vec3 origin = inside(random);
      const float reach = i % 2 == 0 ? 0.002f : 0.2f;
      const glm::vec3 target = glm::mix(from, to, random.range(0, 1)) + reach * random.direction();
      ASSERT_TRUE(blocked(shell, origin, glm::normalize(target - origin)))
          << "at " << target.x << ' ' << target.y << ' ' << target.z;
    }
  }
};

Room vaultRoom() {
  using namespace vault;
  return {shellOf(makeVault()), [](TestRandom& random) {
            if (random.range(0, 1) < 0.2f) {  // in the well
              const float h = kWellHalf - 0.05f;
              return random.inside({-h, kApex, kWellZ - h}, {h, kWellTop - 0.05f, kWellZ + h});
            }
            const float x = random.range(-kHalfWidth + 0.05f, kHalfWidth - 0.05f);
            const float y = random.range(0.05f, vaultY(x) - 0.1f);
            return glm::vec3(x, y, random.range(-kHalfLength + 0.05f, kHalfLength - 0.05f));
          }};
}

TEST(Vault, IsClosed) {
  using namespace vault;
  const Room room = vaultRoom();
  room.expectClosed(20000);
  const float x = kHalfWidth, z = kHalfLength, h = kWellHalf;
  for (const float side : {-1.0f, 1.0f}) {
    room.expectTight({side * x, 0, -z}, {side * x, 0, z});
    room.expectTight({side * x, kSpring, -z}, {side * x, kSpring, z});
    room.expectTight({-x, 0, side * z}, {x, 0, side * z});
    for (const float end : {-1.0f, 1.0f}) {
      room.expectTight({side * x, 0, end * z}, {side * x, kSpring, end * z});
      room.expectTight({side * x, kSpring, end * z}, {0, kApex, end * z});
      room.expectTight({side * h, vaultY(h), kWellZ + end * h}, {side * h, kWellTop, kWellZ + end * h});
    }
    room.expectTight({side * h, vaultY(h), kWellZ - h}, {side * h, vaultY(h), kWellZ + h});
    room.expectTight({-h, vaultY(h), kWellZ + side * h}, {h, vaultY(h), kWellZ + side * h});
    for (int bay = 1; bay < 4; ++bay) {
      const float joint = -z + kBay * static_cast<float>(bay);
      room.expectTight({side * x, 0, joint}, {side * x, kSpring, joint});
    }
  }
}

/// The chamber behind the window and the niche keep what gets into them: aim at their openings.
TEST(Vault, LeaksNeitherThroughTheWindowNorTheNiche) {
  using namespace vault;
  const Room room = vaultRoom();
  TestRandom random(3);
  int beyond = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::vec3 target = i % 2 == 0 ? glm::vec3(kHalfWidth, kWindowY, kWindowZ) + kWindowRadius * random.direction()
                                        : glm::vec3(0, 1.6f, -kHalfLength) + 1.3f * random.direction();
    const glm::vec3 origin = room.inside(random), direction = glm::normalize(target - origin);
    const std::optional<float> hit = nearest(room.shell, origin, direction);
    ASSERT_TRUE(hit) << target.x << ' ' << target.y << ' ' << target.z;
    beyond += (origin + *hit * direction).x > kHalfWidth + kThickness ? 1 : 0;
  }
  EXPECT_GT(beyond, 1000);  // the window is open: rays do reach the chamber
}

TEST(Cage, IsClosed) {
  using namespace cage;
  const Room room{shellOf(makeCage()), [](TestRandom& random) {
                    return random.inside({-kHalfWidth + 0.05f, 0.05f, -kHalfLength + 0.05f},
                                         {kHalfWidth - 0.05f, kCeiling - 0.05f, kHalfLength - 0.05f});
                  }};
  room.expectClosed(20000);
  const float x = kHalfWidth, z = kHalfLength;
  for (const float y : {0.0f, kCeiling}) {
    for (const float side : {-1.0f, 1.0f}) {
      room.expectTight({side * x, y, -z}, {side * x, y, z});
      room.expectTight({-x, y, side * z}, {x, y, side * z});
    }
  }
  for (const float side : {-1.0f, 1.0f}) {
    for (const float end : {-1.0f, 1.0f}) room.expectTight({side * x, 0, end * z}, {side * x, kCeiling, end * z});
  }
}

}  // namespace
}  // namespace tyndall::levels
