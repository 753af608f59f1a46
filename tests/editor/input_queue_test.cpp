// What the hand did reaches the interface in its order, an edge at a time.
#include <gtest/gtest.h>

#include "input_queue.hpp"

namespace tyndall::editor {
namespace {

using Kind = InputEvent::Kind;

InputEvent motion(float x, double seconds) { return {.kind = Kind::kMotion, .seconds = seconds, .at = {x, 0}}; }
InputEvent button(bool down, double seconds) { return {.kind = Kind::kButton, .seconds = seconds, .down = down}; }
InputEvent key(int code, bool down) { return {.kind = Kind::kKey, .code = code, .named = code, .down = down}; }
InputEvent text(char c) { return {.kind = Kind::kText, .text = static_cast<std::uint32_t>(c)}; }

TEST(InputQueue, MotionIsTakenAtOnceUpToTheNextEdge) {
  InputQueue queue;
  EXPECT_TRUE(queue.empty());
  EXPECT_TRUE(queue.take().empty());
  for (int i = 0; i < 5; ++i) queue.add(motion(static_cast<float>(i), i));
  queue.add(button(true, 5));
  for (int i = 6; i < 9; ++i) queue.add(motion(static_cast<float>(i), i));
  queue.add(button(false, 9));
  queue.add(motion(100, 10));
  const float places[] = {4, 0, 8, 0, 100};
  const double times[] = {4, 5, 8, 9, 10};
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(queue.pressNext(), i == 1);
    const auto step = queue.take();
    ASSERT_EQ(step.size(), 1u);
    EXPECT_EQ(step[0].kind, i % 2 == 1 ? Kind::kButton : Kind::kMotion);
    EXPECT_EQ(step[0].at.x, places[i]);
    EXPECT_EQ(step[0].seconds, times[i]);
  }
  EXPECT_TRUE(queue.empty());
}

TEST(InputQueue, EachEdgeOfAKeyIsAStepWithWhatItTypes) {
  InputQueue queue;
  for (const char c : std::string("zz")) queue.add(key(c, true)), queue.add(text(c)), queue.add(key(c, false));
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(queue.pressNext());
    const auto down = queue.take(), up = queue.take();
    ASSERT_EQ(down.size(), 2u);
    EXPECT_TRUE(down[0].down);
    EXPECT_EQ(down[1].text, 'z');
    ASSERT_EQ(up.size(), 1u);
    EXPECT_FALSE(up[0].down);
  }
  EXPECT_TRUE(queue.empty());
}

TEST(InputQueue, TheWheelsTurnsAddUp) {
  InputQueue queue;
  for (int i = 0; i < 4; ++i) queue.add({.kind = Kind::kWheel, .seconds = 1.0 + i, .at = {0, 1}});
  queue.add({.kind = Kind::kLeave, .seconds = 6});
  const auto turned = queue.take();
  ASSERT_EQ(turned.size(), 1u);
  EXPECT_EQ(turned[0].at.y, 4);
  EXPECT_EQ(turned[0].seconds, 4);
  EXPECT_EQ(queue.take()[0].kind, Kind::kLeave);
}

}  // namespace
}  // namespace tyndall::editor
