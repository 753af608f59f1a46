// The table: registration, unknown ids, removal and return of a plugin's parameters, the engine's own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "params/params.hpp"

namespace tyndall::params {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Parameter number(std::string id, double low, double high, double def, std::string owner = "plug") {
  Parameter p;
  p.id = std::move(id);
  p.owner = std::move(owner);
  p.min = p.builtMin = low;
  p.max = p.builtMax = high;
  p.defaultValue = def;
  return p;
}
Parameter choice(std::string id, std::vector<std::string> choices) {
  Parameter p;
  p.id = std::move(id);
  p.owner = "plug";
  p.type = Type::kEnum;
  p.choices = std::move(choices);
  return p;
}

TEST(Table, engineParametersHaveTheContractsIdsAndDefaults) {
  Table table;
  ASSERT_TRUE(table.add(engineParameters()));
  for (const Parameter& p : table.parameters()) {
    EXPECT_TRUE(check(p, p.defaultValue)) << p.id;
    EXPECT_FALSE(p.doc.empty()) << p.id;
    EXPECT_EQ(p.owner, "engine");
  }
  EXPECT_EQ(table.value("shadows.resolution"), 2048);
  EXPECT_EQ(table.value("view.exposure"), 1);
  EXPECT_EQ(table.value("sky.strength"), 1);
  EXPECT_TRUE(table.setAssignment("sky.strength=0"));
  EXPECT_FALSE(table.setAssignment("sky.strength=-1"));
  EXPECT_FALSE(table.setAssignment("sky.strength=101"));
  EXPECT_EQ(toText(*table.find("shadows.mode"), table.value("shadows.mode")), "pcf");
  EXPECT_EQ(toText(*table.find("shadows.precision"), table.value("shadows.precision")), "64");
  EXPECT_TRUE(table.setAssignment("shadows.precision=128"));
  EXPECT_TRUE(table.setAssignment("shadows.resolution=8192"));
  EXPECT_FALSE(table.setAssignment("shadows.resolution=63"));
  EXPECT_FALSE(table.setAssignment("shadows.resolution=8193"));
  EXPECT_FALSE(table.setAssignment("view.exposure=0"));
  EXPECT_TRUE(table.setText("shadows.mode", "moments"));
  for (const char* mode : {"soft", "variance", "exponential_variance"}) {
    const auto set = table.setText("shadows.mode", mode);
    ASSERT_FALSE(set);
    EXPECT_THAT(set.error().message, HasSubstr(std::string("'") + mode + "' is not built yet"));
  }
}

TEST(Table, unknownIdIsAnsweredWithTheNearest) {
  Table table;
  ASSERT_TRUE(table.add(engineParameters()));
  const auto set = table.setAssignment("view.exposur=2");
  ASSERT_FALSE(set);
  EXPECT_EQ(set.error().kind, ErrorKind::kBadCall);
  EXPECT_THAT(set.error().message, HasSubstr("'view.exposure'"));
  EXPECT_THAT(table.setAssignment("zzzzzz=2").error().message, HasSubstr("no such parameter"));
  EXPECT_THAT(table.setAssignment("view.exposure").error().message, HasSubstr("id=value"));
  EXPECT_FALSE(table.setAssignment(""));
  EXPECT_FALSE(table.setAssignment("="));
  EXPECT_EQ(table.value("view.exposure"), 1);
}

TEST(Table, duplicatesAreRefusedWhole) {
  Table table;
  ASSERT_TRUE(table.add({number("a.x", 0, 1, 0.5)}));
  EXPECT_THAT(table.add({number("a.y", 0, 1, 0), number("a.x", 0, 1, 0)}).error().message, HasSubstr("a.x"));
  EXPECT_EQ(table.find("a.y"), nullptr);
  EXPECT_FALSE(table.add({number("b.x", 0, 1, 0), number("b.x", 0, 1, 0)}));
  EXPECT_FALSE(table.add({number("", 0, 1, 0)}));
  EXPECT_EQ(table.parameters().size(), 1u);
}

TEST(Table, assignedAndChanged) {
  Table table;
  ASSERT_TRUE(table.add({number("a.x", 0, 1, 0.5), number("a.y", 0, 1, 0.5)}));
  ASSERT_TRUE(table.setAssignment("a.y=0.5"));
  EXPECT_FALSE(table.changed("a.y"));
  EXPECT_THAT(table.assigned(), ElementsAre("a.y"));
  ASSERT_TRUE(table.set("a.x", 0.25));
  EXPECT_TRUE(table.changed("a.x"));
  table.resetToDefaults();
  EXPECT_FALSE(table.changed("a.x"));
  EXPECT_TRUE(table.assigned().empty());
}

TEST(Table, aReloadedPluginKeepsItsValues) {
  Table table;
  ASSERT_TRUE(table.add(engineParameters()));
  ASSERT_TRUE(table.add({number("p.kept", 0, 1, 0.5), number("p.tooFar", 0, 10, 1), number("p.untouched", 0, 1, 0.5),
                         choice("p.mode", {"one", "two", "three"}), choice("p.gone", {"old", "new"})}));
  ASSERT_TRUE(table.setAssignment("p.kept=0.75"));
  ASSERT_TRUE(table.setAssignment("p.tooFar=9"));
  ASSERT_TRUE(table.setAssignment("p.mode=two"));
  ASSERT_TRUE(table.setAssignment("p.gone=new"));
  ASSERT_TRUE(table.setAssignment("view.exposure=2"));
  table.remove("plug");
  EXPECT_EQ(table.find("p.kept"), nullptr);
  EXPECT_EQ(table.value("view.exposure"), 2);
  // The rebuilt plugin: a narrower range, another default, choices in another order, one choice dropped.
  ASSERT_TRUE(table.add({choice("p.gone", {"old", "other"}), choice("p.mode", {"zero", "one", "two"}),
                         number("p.untouched", 0, 1, 0.25), number("p.tooFar", 0, 5, 1), number("p.kept", 0, 1, 0.5)}));
  EXPECT_EQ(table.value("p.kept"), 0.75);
  EXPECT_EQ(table.value("p.tooFar"), 1);
  EXPECT_EQ(table.value("p.untouched"), 0.25);
  EXPECT_EQ(table.value("p.mode"), 2);
  EXPECT_EQ(table.value("p.gone"), 0);
  EXPECT_EQ(table.value("view.exposure"), 2);
  EXPECT_THAT(table.assigned(), ElementsAre("view.exposure", "p.mode", "p.kept"));
}

}  // namespace
}  // namespace tyndall::params
