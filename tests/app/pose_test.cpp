#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "app/pose.hpp"

namespace tyndall::app {
namespace {

TEST(Pose, TextReadsBackToTheBit) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> metres(-1e3f, 1e3f), yaw(-180, 180), pitch(-90, 90);
  for (int i = 0; i < 10000; ++i) {
    const Pose pose{{metres(random), metres(random) * 1e-6f, metres(random)}, yaw(random), pitch(random)};
    auto read = readPose("--pose", poseText(pose));
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(*read, pose) << poseText(pose);
  }
}

TEST(Pose, OtherTextIsRefused) {
  for (const char* text :
       {"", "1,2,3,4", "1,2,3,4,5,6", "1,2,3,4,5,", "a,2,3,4,5", "1 ,2,3,4,5", "1,2,3,4,91", "1,2,3,361,0",
        "nan,0,0,0,0", "inf,0,0,0,0", "1e7,0,0,0,0", "1e99,0,0,0,0", "1;2;3;4;5", "+1,2,3,4,5"}) {
    auto read = readPose("--pose", text);
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().kind, ErrorKind::kBadCall);
    EXPECT_NE(read.error().message.find("--pose"), std::string::npos);
  }
}

TEST(Pose, IsARotationThatLooksWhereItSays) {
  for (float yaw = -180; yaw <= 180; yaw += 15)
    for (float pitch = -90; pitch <= 90; pitch += 15) {
      const Pose pose{{1, 2, 3}, yaw, pitch};
      const glm::mat4 m = placed({}, pose).worldFromView;
      EXPECT_NEAR(glm::determinant(m), 1, 1e-5f);
      EXPECT_NEAR(glm::dot(glm::vec3(m[0]), glm::vec3(m[1])), 0, 1e-6f);
      EXPECT_NEAR(m[0].y, 0, 1e-6f);                               // level horizon
      EXPECT_GE(m[1].y, -1e-6f);                                   // not upside down
      EXPECT_NEAR(-m[2].y, std::sin(glm::radians(pitch)), 1e-6f);  // height of the look
      EXPECT_EQ(glm::vec3(m[3]), pose.position);
      if (std::abs(pitch) > 89 || std::abs(yaw) > 179) continue;  // yaw has no meaning, or two values
      const Pose back = poseOf(placed({}, pose));
      EXPECT_NEAR(back.yaw, yaw, 1e-3f);
      EXPECT_NEAR(back.pitch, pitch, 1e-2f);
    }
}

}  // namespace
}  // namespace tyndall::app
