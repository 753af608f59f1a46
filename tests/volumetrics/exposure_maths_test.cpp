// The maths of automatic exposure: bins that invert, trims that count what they should, an eye that adapts at one rate.
#include <random>

#include <gtest/gtest.h>

#include "lib/cpp.hpp"

namespace tyndall {
namespace {

using namespace lib::f32;

TEST(ExposureMaths, BinsHoldTheLuminancesThatTheirMiddlesSay) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> stops(-39.9f, 39.9f);
  const float half = 0.5f / kToneBinsPerStop;
  for (int i = 0; i < 100000; ++i) {
    const float log = stops(random);
    EXPECT_NEAR(toneOfBin(toneBin(std::exp2(log), 512)), log, half * 1.001f);
  }
  EXPECT_EQ(toneBin(1e-30f, 512), 0);
  EXPECT_EQ(toneBin(1e30f, 512), 511);
  for (const float metres : {0.01f, 1.0f, 17.0f, 1e3f, 1e6f})
    EXPECT_NEAR(distanceOfBin(distanceBin(metres, 192)) / metres, 1, 0.07) << metres;
}

// Whatever the bins, exactly the samples between the trims count.
TEST(ExposureMaths, SharesAddUpToWhatLiesBetweenTheTrims) {
  std::mt19937 random(11);
  for (int run = 0; run < 100; ++run) {
    std::vector<float> counts(64);
    float total = 0;
    for (float& count : counts) total += count = static_cast<float>(random() % 100);
    float before = 0, sum = 0;
    for (const float count : counts) {
      const float share = toneShare(before, count, total);
      EXPECT_GE(share, 0);
      EXPECT_LE(share, count * 1.00001f);
      sum += share;
      before += count;
    }
    EXPECT_NEAR(sum / total, kToneTrimHigh - kToneTrimLow, 1e-4);
  }
}

TEST(ExposureMaths, AdaptationDoesNotDependOnTheFrameRate) {
  float many = 5;
  for (int i = 0; i < 100; ++i) many = toneAdapted(many, -3, 0.01f);
  EXPECT_NEAR(many, toneAdapted(5, -3, 1.0f), 1e-4);
  EXPECT_EQ(toneAdapted(5, -3, 1e6f), -3);
  EXPECT_EQ(toneAdapted(5, -3, 0.0f), 5);
}

}  // namespace
}  // namespace tyndall
