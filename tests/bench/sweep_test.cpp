// Sweeps: what comes with the program can be read, and what is wrong in a user's is named.
#include <gtest/gtest.h>

#include "bench/sweep.hpp"

namespace tyndall::bench {
namespace {

std::string refusal(const std::string& json) {
  auto sweep = readSweep(json, "mine.json");
  EXPECT_FALSE(sweep) << json;
  if (sweep) return "";
  EXPECT_EQ(sweep.error().kind, ErrorKind::kBadCall);
  EXPECT_EQ(sweep.error().message.find('\n'), std::string::npos);
  return sweep.error().message;
}

void expectRefused(const std::string& json, const std::vector<std::string>& words) {
  const std::string message = refusal(json);
  EXPECT_NE(message.find("mine.json"), std::string::npos) << message;
  for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << word << " in: " << message;
}

TEST(Sweep, WhatIsWrongIsNamed) {
  expectRefused("[", {"no JSON"});
  expectRefused("3", {"the file", "an object"});
  expectRefused(R"({"levles": ["hall"]})", {"levles", "'levels'"});
  expectRefused(R"({"levels": []})", {"levels", "not empty"});
  expectRefused(R"({"levels": ["hall", 3]})", {"levels[1]", "a text"});
  expectRefused(R"({"size": [640]})", {"size", "[width, height]"});
  expectRefused(R"({"size": [640, 0]})", {"size[1]", "whole number"});
  expectRefused(R"({"repetitions": 0})", {"repetitions", "from 1"});
  expectRefused(R"({"repetitions": 2.5})", {"repetitions", "2.5"});
  expectRefused(R"({"settings": {"medium.g": [1]}})", {"settings.medium.g", "[1]"});
  expectRefused(R"({"knobs": [{"id": "volumetrics.steps"}]})", {"knobs[0]", "'values'"});
  expectRefused(R"({"knobs": [{"id": "volumetrics.steps", "values": [1], "plots": ["eror"]}]})",
                {"knobs[0].plots[0]", "error_time"});
  expectRefused(R"({"points": [{"series": "a", "label": "b"}]})", {"points[0]", "'settings'"});
  expectRefused(R"({"points": [{"series": "a", "label": "b", "settings": {"x": 1}, "paper": {"paper": "K"}}]})",
                {"points[0].paper", "'table'"});
  expectRefused(R"({"motion": {"turn_degrees": 1}})", {"motion", "'frames'"});
  // Numbers have bounds.
  expectRefused(R"({"motion": {"frames": 2, "seconds": 1e308}})", {"motion.seconds", "from -1000000 to 1000000"});
  expectRefused(R"({"motion": {"frames": 2, "turn_degrees": -1e9}})",
                {"motion.turn_degrees", "from -360000 to 360000"});
  expectRefused(R"({"seconds_per_point": -1})", {"seconds_per_point", "from 0"});
  expectRefused(R"({"every_technique": 1})", {"every_technique", "true or false"});
}

TEST(Sweep, IsReadAsItIsWritten) {
  auto sweep = readSweep(
      R"({"levels": ["hall"], "cameras": [0, 2], "size": [64, 36], "error_size": [32, 18], "repetitions": 4, "truth_samples": 8,
    "settings": {"medium.g": 0.25, "volumetrics.prefix_bounds": false}, "march": {"volumetrics.steps": 9}, "every_technique": false,
    "knobs": [{"id": "a", "values": [1, "x", true], "together": ["b"], "with": {"c": 2}}], "resolutions": [[16, 9]],
    "points": [{"series": "s", "label": "l", "settings": {"d": 1}, "paper": {"paper": "P", "table": "T", "row": "R", "ms": 1.5}, "baseline": true}],
    "motion": {"frames": 3, "turn_degrees": -1.5, "seconds": 0.5}})",
      "folder/mine.json");
  ASSERT_TRUE(sweep) << sweep.error().message;
  EXPECT_EQ(sweep->name, "mine");
  EXPECT_EQ(sweep->cameras, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(sweep->size, (Size{64, 36}));
  EXPECT_EQ(sweep->errorSize, (Size{32, 18}));
  EXPECT_EQ(sweep->settings, (Assignments{{"medium.g", "0.25"}, {"volumetrics.prefix_bounds", "false"}}));
  ASSERT_EQ(sweep->knobs.size(), 1u);
  EXPECT_EQ(sweep->knobs[0].values, (std::vector<std::string>{"1", "x", "true"}));
  EXPECT_EQ(sweep->knobs[0].together, std::vector<std::string>{"b"});
  ASSERT_EQ(sweep->singles.size(), 1u);
  EXPECT_EQ(sweep->singles[0].paper->milliseconds, 1.5);
  EXPECT_FALSE(sweep->singles[0].paper->ratio);
  EXPECT_TRUE(sweep->singles[0].baseline);
  EXPECT_EQ(sweep->motion.frames, 3u);
  EXPECT_EQ(sweep->motion.turn, -1.5);
}

TEST(Sweep, ThoseOfTheProgramAreThere) {
  for (const char* name : {"quick", "full", "papers", "scaling", "motion"}) {
    auto sweep = findSweep(name);
    EXPECT_TRUE(sweep) << sweep.error().message;
  }
  auto missing = findSweep("quik");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("'quick'"), std::string::npos);
  EXPECT_FALSE(findSweep("there/is/none.json"));
}

}  // namespace
}  // namespace tyndall::bench
