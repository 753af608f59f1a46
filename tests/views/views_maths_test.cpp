// Zoom and pan, percentiles, colours, projection: against what they promise.
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "views_colour.hpp"
#include "views_project.hpp"
#include "views_transform.hpp"

namespace tyndall::editor {
namespace {

TEST(Transform, ZoomKeepsTheTexelUnderTheCursor) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(0, 800), factor(0.5f, 2.0f);
  ViewTransform transform;
  transform.fit({1024, 512}, {800, 600});
  for (int i = 0; i < 1000; ++i) {
    const glm::vec2 cursor(place(random), place(random));
    const glm::vec2 before = transform.texelAt(cursor);
    transform.zoomAbout(cursor, factor(random));
    const glm::vec2 after = transform.pointOf(before);
    ASSERT_NEAR(after.x, cursor.x, 0.02f) << i;
    ASSERT_NEAR(after.y, cursor.y, 0.02f) << i;
    if (glm::length(transform.pointOf({512, 256})) > 4000)
      transform.fit({1024, 512}, {800, 600});  // float's grain far away is no matter
  }
}

TEST(Transform, FitShowsAllOfItAndPanMovesByPoints) {
  ViewTransform transform;
  transform.fit({200, 100}, {400, 400});
  EXPECT_FLOAT_EQ(transform.scale(), 2);
  EXPECT_EQ(transform.pointOf({0, 0}), glm::vec2(0, 100));
  EXPECT_EQ(transform.pointOf({200, 100}), glm::vec2(400, 300));
  transform.pan({10, -5});
  EXPECT_EQ(transform.pointOf({0, 0}), glm::vec2(10, 95));
  transform.oneToOne({200, 100}, {400, 400});
  EXPECT_FLOAT_EQ(transform.scale(), 1);
  EXPECT_EQ(transform.texelAt({100, 150}), glm::vec2(0, 0));
}

TEST(Transform, ScaleHasBounds) {
  ViewTransform transform;
  for (int i = 0; i < 200; ++i) transform.zoomAbout({5, 5}, 2);
  EXPECT_FLOAT_EQ(transform.scale(), ViewTransform::kMostScale);
  for (int i = 0; i < 400; ++i) transform.zoomAbout({5, 5}, 0.5f);
  EXPECT_FLOAT_EQ(transform.scale(), ViewTransform::kLeastScale);
}

TEST(Percentiles, AreNearestRanksOfTheChannelsFiniteValues) {
  std::vector<float> values;
  for (int i = 100; i >= 1; --i) values.insert(values.end(), {static_cast<float>(i), -1.0f});
  values.insert(values.end(), {std::numeric_limits<float>::quiet_NaN(), 0, std::numeric_limits<float>::infinity(), 0});
  const Range range = percentiles(values, 2, 0, 0.05, 0.95);
  EXPECT_EQ(range.low, 5);
  EXPECT_EQ(range.high, 95);
  EXPECT_EQ(percentiles(values, 2, 0, 0, 1).low, 1);
  EXPECT_EQ(percentiles(values, 2, 0, 0, 1).high, 100);
}

TEST(Percentiles, OfAConstantAreARangeAboutIt) {
  const std::vector<float> values(30, 3.0f);
  const Range range = percentiles(values, 3, 4, 0.01, 0.99);
  EXPECT_LT(range.low, 3);
  EXPECT_GT(range.high, 3);
  const std::vector<float> none(4, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(percentiles(none, 1, 0, 0, 1).low, 0);
  EXPECT_EQ(percentiles(none, 1, 0, 0, 1).high, 1);
}

double brightness(const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

TEST(Colours, FalseColoursGrowBrighterAllTheWay) {
  for (int i = 0; i < 100; ++i)
    EXPECT_LE(brightness(falseColour(static_cast<float>(i) / 100)),
              brightness(falseColour(static_cast<float>(i + 1) / 100)) + 0.5)
        << i;
  EXPECT_EQ(falseColour(-1), falseColour(0));
  EXPECT_EQ(falseColour(2), falseColour(1));
}

TEST(Colours, SignedOnesAreBlueBelowWhiteAtAndRedAboveZero) {
  const Rgb zero = signedColour(0);
  EXPECT_NEAR(zero[0], zero[2], 3);
  EXPECT_GT(zero[0], 240);
  for (const float t : {0.2f, 0.5f, 1.0f, 5.0f}) {
    EXPECT_GT(signedColour(t)[0], signedColour(t)[2]) << t;
    EXPECT_LT(signedColour(-t)[0], signedColour(-t)[2]) << t;
  }
}

TEST(Colours, StretchMapsItsEndsToBlackAndWhite) {
  const std::vector<float> values = {1, 9, 2, 9, 3, 9, std::numeric_limits<float>::quiet_NaN(), 9};
  const auto grey = stretched(values, 2, {0, false, 1, 3});
  ASSERT_EQ(grey.size(), 16u);
  EXPECT_EQ(grey[0], 0);
  EXPECT_EQ(grey[4], 128);
  EXPECT_EQ(grey[8], 255);
  EXPECT_EQ((Rgb{grey[12], grey[13], grey[14]}), kNotFinite);
  // Swapped ends show the negative.
  EXPECT_EQ(stretched(values, 2, {0, false, 3, 1})[0], 255);
  const std::vector<float> colour = {0, 0.5f, 1};
  const auto coded = stretched(colour, 3, {4, false, 0, 1});
  EXPECT_EQ(coded[0], 0);
  EXPECT_EQ(coded[1], 188);  // sRGB of one half
  EXPECT_EQ(coded[2], 255);
}

TEST(Colours, ErrorMapIsWhiteWhereBothAreEqualAndHasTheSign) {
  const std::vector<float> image = {1, 1, 1, 2, 2, 2, 0, 0, 0}, reference = {1, 1, 1, 1, 1, 1, 1, 1, 1};
  const auto bytes = errorMap(image, reference, 3, 1);
  const auto at = [&](std::size_t i) { return Rgb{bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2]}; };
  EXPECT_EQ(at(0), signedColour(0));
  EXPECT_EQ(at(1), signedColour(1));   // too bright: red
  EXPECT_EQ(at(2), signedColour(-1));  // too dark: blue
}

TEST(Projection, PointsBehindTheCameraAreCutOff) {
  // Reversed depth does not matter: x, y and w are read.
  const glm::mat4 clip = glm::perspectiveRH_ZO(1.2f, 2.0f, 0.1f, 100.0f);
  const glm::vec2 size(200, 100);
  const auto ahead = projectSegment(clip, {0, 0, -5}, {0, 0, -10}, size);
  ASSERT_TRUE(ahead);
  EXPECT_NEAR(glm::distance(ahead->first, glm::vec2(100, 50)), 0, 1e-4);
  EXPECT_FALSE(projectSegment(clip, {0, 0, 5}, {1, 0, 10}, size));
  const auto through = projectSegment(clip, {1, 0, -5}, {1, 0, 5}, size);
  ASSERT_TRUE(through);
  EXPECT_GT(through->second.x, 1000);  // the cut end is far off to the right, not mirrored to the left
  const auto reversed = projectSegment(clip, {1, 0, 5}, {1, 0, -5}, size);
  ASSERT_TRUE(reversed);
  EXPECT_NEAR(glm::distance(reversed->second, through->first), 0, 1e-3);
  EXPECT_FALSE(projectedPoint(clip, {0, 0, 1}, size));
}

}  // namespace
}  // namespace tyndall::editor
