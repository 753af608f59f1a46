// Text to value and back, and what is refused.
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "params/params.hpp"

namespace tyndall::params {
namespace {

using testing::HasSubstr;
using testing::Not;

Parameter steps() {
  Parameter p;
  p.id = "fog.steps";
  p.type = Type::kInt;
  p.min = p.builtMin = 1;
  p.max = 4096;
  p.builtMax = 1024;
  p.defaultValue = 64;
  return p;
}
Parameter density() {
  Parameter p;
  p.id = "fog.density";
  p.min = p.builtMin = 0;
  p.max = p.builtMax = 10;
  p.defaultValue = 0.03;
  return p;
}
Parameter mode() {
  Parameter p;
  p.id = "fog.mode";
  p.type = Type::kEnum;
  p.choices = {"ray_march", "min_max", "64"};
  p.built = {true, false, true};
  return p;
}
Parameter reuse() {
  Parameter p;
  p.id = "fog.reuse";
  p.type = Type::kBool;
  p.built = {true, false};
  return p;
}

struct Case {
  Parameter parameter;
  std::string text;
  double value;
};

TEST(Text, reads) {
  for (const Case& c : {Case{steps(), "17", 17},
                        {steps(), "1", 1},
                        {steps(), "1024", 1024},
                        {density(), "0.03", 0.03},
                        {density(), "1e-3", 1e-3},
                        {density(), "10", 10},
                        {density(), "0", 0},
                        {mode(), "ray_march", 0},
                        {mode(), "64", 2},
                        {reuse(), "false", 0},
                        {reuse(), "0", 0},
                        {reuse(), "off", 0}}) {
    const auto value = fromText(c.parameter, c.text);
    ASSERT_TRUE(value) << c.text << ": " << value.error().message;
    EXPECT_EQ(*value, c.value) << c.text;
  }
}

TEST(Text, roundTrips) {
  for (const double value : {0.03, 1.0 / 3, 1e-7, 9.999999, 0.1 + 0.2})
    EXPECT_EQ(*fromText(density(), toText(density(), value)), value);
  EXPECT_EQ(toText(density(), 0.03), "0.03");
  EXPECT_EQ(toText(steps(), 17), "17");
  EXPECT_EQ(toText(steps(), 100000), "100000");
  EXPECT_EQ(toText(mode(), 1), "min_max");
  EXPECT_EQ(toText(reuse(), 1), "true");
}

struct Refusal {
  Parameter parameter;
  std::string text;
  std::string says;
};

TEST(Text, refuses) {
  for (const Refusal& c : {Refusal{steps(), "17.5", "not a whole number"},
                           {steps(), "", "not a whole number"},
                           {steps(), "1e2", "not a whole number"},
                           {steps(), " 17", "not a whole number"},
                           {steps(), "17 ", "not a whole number"},
                           {steps(), "0x10", "not a whole number"},
                           {steps(), "0", "1 to 4096"},
                           {steps(), "-1", "1 to 4096"},
                           {steps(), "5000", "1 to 4096"},
                           {steps(), "99999999999999999999999", "1 to 4096"},
                           {steps(), "1025", "not built yet"},
                           {steps(), "many\nlines", "'many?lines'"},
                           {steps(), std::string(100000, '9'), "outside the range"},
                           {density(), "nan", "finite"},
                           {density(), "inf", "finite"},
                           {density(), "-inf", "finite"},
                           {density(), "1e999", "outside the range"},
                           {density(), "10.001", "0 to 10"},
                           {density(), "-1e-30", "0 to 10"},
                           {density(), "0,5", "not a number"},
                           {density(), "0.5x", "not a number"},
                           {density(), "", "not a number"},
                           {mode(), "ray_marsh", "'ray_march'"},
                           {mode(), "0", "ray_march, min_max, 64"},
                           {mode(), "min_max", "'min_max' is not built yet; built are: ray_march, 64"},
                           {mode(), "", "no choice"},
                           {reuse(), "maybe", "neither true nor false"},
                           {reuse(), "true", "not built yet; use false"}}) {
    const auto value = fromText(c.parameter, c.text);
    ASSERT_FALSE(value) << c.parameter.id << "=" << c.text;
    EXPECT_EQ(value.error().kind, ErrorKind::kBadCall);
    EXPECT_THAT(value.error().message, HasSubstr(c.parameter.id)) << c.text;
    EXPECT_THAT(value.error().message, HasSubstr(c.says)) << c.text;
    EXPECT_THAT(value.error().message, Not(HasSubstr("\n"))) << c.text;
    EXPECT_LT(value.error().message.size(), 300u);
  }
}

TEST(Check, numbers) {
  EXPECT_TRUE(check(steps(), 17));
  EXPECT_FALSE(check(steps(), 17.5));
  EXPECT_FALSE(check(steps(), std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(check(density(), std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(check(mode(), 3));
  EXPECT_FALSE(check(mode(), -1));
  EXPECT_FALSE(check(mode(), 1));
  EXPECT_FALSE(check(reuse(), 2));
}

}  // namespace
}  // namespace tyndall::params
