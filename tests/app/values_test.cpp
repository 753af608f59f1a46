#include <gtest/gtest.h>

#include "app/values.hpp"

namespace tyndall::app {
namespace {

TEST(Values, CountsAreWholeNumbersInTheirRange) {
  EXPECT_EQ(*readCount("--n", "1", 1, 10), 1u);
  EXPECT_EQ(*readCount("--n", "10", 1, 10), 10u);
  for (const char* text : {"0", "11", "-1", "+1", "1.0", "1e1", " 1", "1 ", "", "0x1", "184467440737095516160"}) {
    auto count = readCount("--n", text, 1, 10);
    ASSERT_FALSE(count.ok()) << text;
    EXPECT_EQ(count.error().kind, ErrorKind::kBadCall);
    EXPECT_NE(count.error().message.find("--n"), std::string::npos);
  }
}

TEST(Values, Sizes) {
  EXPECT_EQ(*readSize("--size", "1280x720"), (std::pair<std::uint32_t, std::uint32_t>{1280, 720}));
  for (const char* text : {"0x1", "1x0", "1", "x", "1x", "x1", "1X1", "1x1x1", "-1x1", "1x 1"})
    EXPECT_FALSE(readSize("--size", text).ok()) << text;
  // Too great for 32 bits is not an overflow but a size beyond every limit.
  auto vast = readSize("--size", "99999999999999999999x2");
  ASSERT_TRUE(vast.ok());
  EXPECT_FALSE(checkSize("--size", *vast, 16384, "the device takes").ok());
  EXPECT_TRUE(checkSize("--size", {16384, 16384}, 16384, "the device takes").ok());
  EXPECT_FALSE(checkSize("--size", {16385, 1}, 16384, "the device takes").ok());
}

TEST(Values, Seconds) {
  EXPECT_EQ(*readSeconds("--time", "0"), 0);
  EXPECT_EQ(*readSeconds("--time", "1.5"), 1.5);
  for (const char* text : {"-1", "nan", "inf", "1s", "", "1,5"}) EXPECT_FALSE(readSeconds("--time", text).ok()) << text;
}

}  // namespace
}  // namespace tyndall::app
