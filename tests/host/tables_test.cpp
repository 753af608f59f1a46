// Rows of a parameter table, right and wrong.
#include <cmath>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plugin_tables.hpp"

namespace tyndall::host {
namespace {

using testing::HasSubstr;

const char* const kChoices[] = {"one", "two", "three"};
const char* const kTwins[] = {"one", "two", "one"};
const char* const kHoles[] = {"one", nullptr, "three"};

TyParameter number(TyParameterType type = TY_PARAMETER_FLOAT) {
  TyParameter p{};
  p.struct_size = sizeof p;
  p.type = type;
  p.id = "fog.steps";
  p.name = p.unit = p.doc = "";
  p.default_value = 4;
  p.min_value = 1;
  p.max_value = 10;
  return p;
}
TyParameter choice() {
  TyParameter p = number(TY_PARAMETER_ENUM);
  p.choices = kChoices;
  p.choice_count = 3;
  p.default_value = 0;
  return p;
}

TEST(Row, isRead) {
  TyParameter row = number(TY_PARAMETER_INT);
  row.flags = TY_PARAMETER_STRUCTURAL | TY_PARAMETER_LOGARITHMIC;
  const auto p = readParameter(row, "fog");
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_EQ(p->type, params::Type::kInt);
  EXPECT_EQ(p->min, 1);
  EXPECT_EQ(p->max, 10);
  EXPECT_EQ(p->builtMin, 1);
  EXPECT_EQ(p->builtMax, 10);
  EXPECT_TRUE(p->structural && p->logarithmic);
}

TEST(Row, unbuiltValues) {
  TyParameter row = number(TY_PARAMETER_INT);
  row.built_min = 1;
  row.built_max = 3;
  EXPECT_FALSE(params::check(*readParameter(row, "fog"), 4));
  EXPECT_TRUE(params::check(*readParameter(row, "fog"), 3));
  row.built_min = row.built_max = 2;  // a single value: needs bit 0 to say so
  EXPECT_TRUE(params::check(*readParameter(row, "fog"), 4));
  row.unbuilt = 1;
  EXPECT_FALSE(params::check(*readParameter(row, "fog"), 4));
  EXPECT_TRUE(params::check(*readParameter(row, "fog"), 2));

  TyParameter list = choice();
  list.unbuilt = 0b10;
  EXPECT_FALSE(params::check(*readParameter(list, "fog"), 1));
  EXPECT_TRUE(params::check(*readParameter(list, "fog"), 2));
  TyParameter flag = number(TY_PARAMETER_BOOL);
  flag.unbuilt = 0b10;
  EXPECT_FALSE(params::check(*readParameter(flag, "fog"), 1));
  EXPECT_TRUE(params::check(*readParameter(flag, "fog"), 0));
}

TEST(Row, malformedOnesAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  struct Case {
    std::function<void(TyParameter&)> spoil;
    const char* says;
    TyParameter row;
  };
  for (const Case& c : {Case{[](TyParameter& p) { p.id = nullptr; }, "null", number()},
                        {[](TyParameter& p) { p.id = ""; }, "empty", number()},
                        {[](TyParameter& p) { p.id = "steps"; }, "group.name", number()},
                        {[](TyParameter& p) { p.id = ".steps"; }, "group.name", number()},
                        {[](TyParameter& p) { p.id = "fog."; }, "group.name", number()},
                        {[](TyParameter& p) { p.id = "fog.steps=1"; }, "group.name", number()},
                        {[](TyParameter& p) { p.doc = nullptr; }, "doc", number()},
                        {[](TyParameter& p) { p.type = 4; }, "type 4", number()},
                        {[&](TyParameter& p) { p.min_value = nan; }, "finite", number()},
                        {[&](TyParameter& p) { p.max_value = inf; }, "finite", number()},
                        {[](TyParameter& p) { p.min_value = 11; }, "smallest", number()},
                        {[](TyParameter& p) { p.max_value = 9.5; }, "whole", number(TY_PARAMETER_INT)},
                        {[](TyParameter& p) { p.max_value = 1e300; }, "2^53", number(TY_PARAMETER_INT)},
                        {[](TyParameter& p) { p.choices = nullptr; }, "choices", choice()},
                        {[](TyParameter& p) { p.choice_count = 0; }, "choices", choice()},
                        {[](TyParameter& p) { p.choice_count = 65; }, "choices", choice()},
                        {[](TyParameter& p) { p.choices = kTwins; }, "twice", choice()},
                        {[](TyParameter& p) { p.choices = kHoles; }, "null", choice()}}) {
    TyParameter row = c.row;
    c.spoil(row);
    const auto p = readParameter(row, "fog");
    ASSERT_FALSE(p) << c.says;
    EXPECT_THAT(p.error().message, HasSubstr(c.says));
  }
}

}  // namespace
}  // namespace tyndall::host
