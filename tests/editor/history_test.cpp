// Undoing every edit gives the state at the start, exactly.
#include <random>

#include <gtest/gtest.h>

#include "history.hpp"

namespace tyndall::editor {
namespace {

params::Parameter number(const char* id, params::Type type, double low, double high, double standard) {
  params::Parameter p;
  p.id = p.name = id, p.type = type, p.owner = "test";
  p.min = p.builtMin = low, p.max = p.builtMax = high, p.defaultValue = standard;
  return p;
}

params::Table makeTable() {
  params::Table table;
  params::Parameter choice = number("a.choice", params::Type::kEnum, 0, 1, 1);
  choice.choices = {"one", "two", "three"};
  EXPECT_TRUE(table.add({number("a.float", params::Type::kFloat, -10, 10, 0.1),
                         number("a.int", params::Type::kInt, 1, 4096, 64),
                         number("a.flag", params::Type::kBool, 0, 1, 1), choice}));
  EXPECT_TRUE(table.set("a.float", 1.0 / 3));  // a start other than the defaults
  return table;
}

/// The editor without its window: a table, a camera, a level.
struct Hand {
  params::Table table = makeTable();
  std::optional<app::Pose> pose;
  std::uint32_t camera = 0;
  SceneEdits scene;
  History history;
  EditState now() const { return {settingsOf(table), pose, camera, scene}; }
  bool observe(bool busy = false) { return history.observe(table, now(), busy); }
  void restore(const EditState* state) {
    ASSERT_NE(state, nullptr);
    EXPECT_TRUE(applySettings(table, state->settings).empty());
    pose = state->pose, camera = state->camera, scene = state->scene;
  }
};

void edit(Hand& hand, std::mt19937& random) {
  const auto unit = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  const auto below = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); };
  switch (below(11)) {
    case 0:
    case 1: ASSERT_TRUE(hand.table.set("a.float", -10 + 20 * unit())); break;
    case 2: ASSERT_TRUE(hand.table.set("a.int", 1 + below(4096))); break;
    case 3: ASSERT_TRUE(hand.table.set("a.flag", below(2))); break;
    case 4: ASSERT_TRUE(hand.table.set("a.choice", below(3))); break;
    case 5:
      hand.pose = below(4)
                      ? std::optional(app::Pose{{float(unit()), float(unit()), float(unit())}, float(unit() * 90), 3})
                      : std::nullopt;
      break;
    case 6: hand.scene.lights[below(3)].intensity = float(unit()); break;
    case 7: hand.scene.nodes[below(3)].translation.y = float(unit()); break;
    case 8: hand.scene.materials[below(3)].roughness = float(unit()); break;
    case 9: hand.camera = static_cast<std::uint32_t>(below(3)); break;
    default:
      below(2) ? hand.table.resetToDefaults()
               : (void)hand.table.readPreset(R"({"a.int": 7, "a.choice": "one"})", "preset");
  }
}

TEST(History, TenThousandEditsUndoneAreTheStartAndRedoneTheEnd) {
  Hand hand;
  std::mt19937 random(3);
  hand.observe();
  const EditState start = hand.now();
  const std::string startPreset = hand.table.writePreset(false);
  std::vector<EditState> seen{start};
  for (int i = 0; i < 10000; ++i) {
    edit(hand, random);
    if (hand.observe()) seen.push_back(hand.now());
  }
  ASSERT_GT(seen.size(), 8000u);  // some edits change nothing
  ASSERT_EQ(hand.history.steps().size(), seen.size());
  const std::string endPreset = hand.table.writePreset(false);
  for (std::size_t i = seen.size() - 1; i-- > 0;) {
    hand.restore(hand.history.undo());
    ASSERT_EQ(hand.now(), seen[i]) << i;
    ASSERT_FALSE(hand.observe());  // what was restored is no new edit
  }
  EXPECT_FALSE(hand.history.canUndo());
  EXPECT_EQ(hand.now(), start);
  EXPECT_EQ(hand.table.writePreset(false), startPreset);
  EXPECT_EQ(hand.table.assigned(), std::vector<std::string>{"a.float"});
  while (hand.history.canRedo()) hand.restore(hand.history.redo());
  EXPECT_EQ(hand.now(), seen.back());
  EXPECT_EQ(hand.table.writePreset(false), endPreset);
}

TEST(History, ADragIsOneStep) {
  Hand hand;
  hand.observe();
  for (int i = 1; i <= 50; ++i) {
    ASSERT_TRUE(hand.table.set("a.int", i));
    EXPECT_FALSE(hand.observe(true));
  }
  EXPECT_TRUE(hand.observe());
  ASSERT_EQ(hand.history.steps().size(), 2u);
  EXPECT_EQ(hand.history.steps()[1].label, "a.int 64 -> 50");
  hand.restore(hand.history.undo());
  EXPECT_EQ(hand.table.value("a.int"), 64);
}

TEST(History, AnEditAfterUndoForgetsWhatWasUndone) {
  Hand hand;
  hand.observe();
  for (int i = 1; i <= 3; ++i) {
    ASSERT_TRUE(hand.table.set("a.int", i));
    hand.observe();
  }
  hand.restore(hand.history.undo());
  hand.restore(hand.history.undo());
  EXPECT_EQ(hand.table.value("a.int"), 1);
  ASSERT_TRUE(hand.table.set("a.flag", 0));
  EXPECT_TRUE(hand.observe());
  EXPECT_FALSE(hand.history.canRedo());
  EXPECT_EQ(hand.history.redo(), nullptr);
  EXPECT_EQ(hand.history.steps().size(), 3u);
  EXPECT_EQ(hand.history.jump(9), nullptr);
}

}  // namespace
}  // namespace tyndall::editor
