// Presets: what is taken, what is refused, and that a refusal changes nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "params/params.hpp"

namespace tyndall::params {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

struct Preset : testing::Test {
  void SetUp() override {
    ASSERT_TRUE(table.add(engineParameters()));
    Parameter flag;
    flag.id = "fog.flag";
    flag.type = Type::kBool;
    ASSERT_TRUE(table.add({flag}));
  }
  Table table;
};

TEST_F(Preset, takesNumbersBooleansStringsAndSettings) {
  ASSERT_TRUE(table.readPreset(R"({"view.exposure": 2.5, "settings": {"fog.flag": true, "shadows.resolution": "512",
                                   "shadows.precision": 128, "shadows.mode": "pcf"}})",
                               "p.json"));
  EXPECT_EQ(table.value("view.exposure"), 2.5);
  EXPECT_EQ(table.value("fog.flag"), 1);
  EXPECT_EQ(table.value("shadows.resolution"), 512);
  EXPECT_EQ(table.value("shadows.precision"), 1);
  EXPECT_EQ(table.assigned().size(), 5u);
  EXPECT_TRUE(table.readPreset("{}", "p.json"));
  EXPECT_TRUE(table.readPreset(R"({"settings": {}})", "p.json"));
  EXPECT_TRUE(table.readPreset(R"({"shadows.resolution": 1024.0})", "p.json"));
}

TEST_F(Preset, writesWhatItReads) {
  ASSERT_TRUE(table.setAssignment("view.exposure=0.3"));
  ASSERT_TRUE(table.setAssignment("shadows.precision=128"));
  const std::string all = table.writePreset(false), changed = table.writePreset(true);
  EXPECT_THAT(changed, HasSubstr("\"view.exposure\": 0.3"));
  EXPECT_THAT(changed, Not(HasSubstr("shadows.resolution")));
  EXPECT_THAT(all, HasSubstr("\"shadows.resolution\": 2048"));
  for (const std::string& text : {all, changed}) {
    table.resetToDefaults();
    ASSERT_TRUE(table.readPreset(text, "p.json"));
    EXPECT_EQ(table.value("view.exposure"), 0.3);
    EXPECT_EQ(table.value("shadows.precision"), 1);
  }
}

struct Bad {
  std::string json, says;
  ErrorKind kind = ErrorKind::kBadCall;
};

TEST_F(Preset, refusesAllOrNothing) {
  const std::string good = R"({"view.exposure": 3, )";
  for (const Bad& c : {Bad{good + R"("view.exposur": 1})", "'view.exposure'"},
                       {good + R"("settings": {"shadows.resolutoin": 1}})", "'shadows.resolution'"},
                       {good + R"("shadows.resolution": 17.5})", "whole number"},
                       {good + R"("shadows.resolution": 1e300})", "64 to 8192"},
                       {good + R"("shadows.resolution": null})", "is null"},
                       {good + R"("shadows.resolution": [1]})", "a list"},
                       {good + R"("shadows.resolution": {"a": 1}})", "an object"},
                       {good + R"("shadows.resolution": true})", "whole number"},
                       {good + R"("shadows.mode": 0})", "no choice '0'"},
                       {good + R"("shadows.mode": "soft"})", "not built yet"},
                       {good + R"("fog.flag": 2})", "neither true nor false"},
                       {good + R"("view.exposure": 4})", "twice"},
                       {good + R"("settings": {"view.exposure": 4}})", "twice"},
                       {good + R"("settings": {}, "settings": {}})", "twice"},
                       {good + R"("settings": 4})", "object"},
                       {good + R"("settings": {"settings": {}}})", "an object"},
                       {good + R"("fog.flag")", "not valid JSON", ErrorKind::kFailed},
                       {good + "\n\n\"a\" 1}", "line 3", ErrorKind::kFailed},
                       {"", "not valid JSON", ErrorKind::kFailed},
                       {"{} {}", "not valid JSON", ErrorKind::kFailed},
                       {"[1]", "a list", ErrorKind::kFailed},
                       {"7", "single value", ErrorKind::kFailed},
                       {std::string("{\"\0\": 1}", 8), "not valid JSON", ErrorKind::kFailed},
                       {"{\"view.exposure\": NaN}", "not valid JSON", ErrorKind::kFailed},
                       {"{\"view.exposure\": 1e999}", "not valid JSON", ErrorKind::kFailed},
                       {"\xff\xfe\x00", "not valid JSON", ErrorKind::kFailed}}) {
    const auto read = table.readPreset(c.json, "p.json");
    ASSERT_FALSE(read) << c.json;
    EXPECT_THAT(read.error().message, StartsWith("p.json: ")) << c.json;
    EXPECT_THAT(read.error().message, HasSubstr(c.says)) << c.json;
    EXPECT_THAT(read.error().message, Not(HasSubstr("\n"))) << c.json;
    EXPECT_EQ(read.error().kind, c.kind) << c.json;
    EXPECT_EQ(table.value("view.exposure"), 1) << c.json;
    EXPECT_TRUE(table.assigned().empty()) << c.json;
  }
}

TEST_F(Preset, deepNestingIsRefusedNotACrash) {
  for (const std::string& unit : {std::string("["), std::string(R"({"settings":)")}) {
    std::string deep;
    for (int i = 0; i < 1000000; ++i) deep += unit;
    EXPECT_FALSE(table.readPreset(deep, "p.json"));
    EXPECT_FALSE(table.readPreset("{\"view.exposure\":" + deep, "p.json"));
  }
}

}  // namespace
}  // namespace tyndall::params
