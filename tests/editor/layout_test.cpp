#include "layout.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace tyndall::editor {
namespace {

TEST(Layout, SizesAreAutomaticUntilDraggedAndStayWithinTheRoom) {
  EXPECT_EQ(Layout::sizeOf(0, 300, 200, 800), 300);
  EXPECT_EQ(Layout::sizeOf(500.7f, 300, 200, 800), 500);
  EXPECT_EQ(Layout::sizeOf(50, 300, 200, 800), 200);
  EXPECT_EQ(Layout::sizeOf(5000, 300, 200, 800), 800);
  // A window of a few pixels has no room even for the least; what was kept comes back with the room.
  EXPECT_EQ(Layout::sizeOf(500, 300, 200, 10), 10);
  EXPECT_EQ(Layout::sizeOf(0, 300, 200, 10), 10);
  EXPECT_EQ(Layout::sizeOf(0, 0.5f, 200, 0.8f), 1);
}

TEST(Layout, TextGrowsAndShrinksByTheSameSteps) {
  float scale = 1;
  std::size_t steps = 0;
  for (float next = Layout::largerText(scale); next != scale; next = Layout::largerText(scale), ++steps) {
    EXPECT_GT(next, scale);
    EXPECT_EQ(Layout::smallerText(next), scale);
    scale = next;
  }
  EXPECT_GE(steps, 4u);
  EXPECT_GE(scale, 3);  // a display of 4K at arm's length
  Layout largest;
  largest.textScale = scale;
  EXPECT_TRUE(isSound(largest));
  while (Layout::smallerText(scale) != scale) scale = Layout::smallerText(scale);
  EXPECT_LT(scale, 1);
  // What a display asks for need not be one of the steps.
  EXPECT_GT(Layout::largerText(1.1f), 1.1f);
  EXPECT_LT(Layout::smallerText(1.1f), 1.1f);
}

TEST(Layout, NumbersThatNoEditorWroteAreUnsound) {
  EXPECT_TRUE(isSound(Layout()));
  for (float Layout::*size : {&Layout::side, &Layout::figures, &Layout::fields, &Layout::textScale}) {
    for (const float bad : {-1.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
      Layout layout;
      layout.*size = bad;
      EXPECT_FALSE(isSound(layout)) << bad;
    }
  }
  Layout layout;
  layout.textScale = 40;
  EXPECT_FALSE(isSound(layout));
}

}  // namespace
}  // namespace tyndall::editor
