// The window's parts: dragged, hidden, with larger text, kept between runs; memory by resource.
#include <cmath>

#include "session.hpp"

namespace tyndall::editor_test {
namespace {

class PanelsTest : public SessionTest {
 protected:
  std::vector<double> rect(const char* widget) const { return state()["widgets"][widget].get<std::vector<double>>(); }
  double width(const char* widget) const { return rect(widget)[2]; }
  double height(const char* widget) const { return rect(widget)[3]; }
  bool settles(const char* widget, std::size_t side, double size) {
    return !waitFor(
                [&](const Json& s) {
                  return std::abs(s["widgets"][widget][side].get<double>() - size) <= 1.5 &&
                         s["facts"]["picture"] == "current";
                },
                20)
                .is_null();
  }
  bool contains(const std::string& widget) const { return state()["widgets"].contains(widget); }
};

TEST_F(PanelsTest, BarsDividePictureAndPanelsAndAreKept) {
  startTiny("900x600");
  const double picture = width("viewport"), pictures = state()["pictures"].get<double>();
  // The picture is rendered once for its new size, not at every step of the drag.
  pull("side edge", -90, 0);
  ASSERT_TRUE(settles("viewport", 2, picture - 90)) << width("viewport") << " " << picture;
  EXPECT_EQ(state()["pictures"].get<double>(), pictures + 1);
  const double graph = rect("figures edge")[1];
  pull("figures edge", 0, 60);
  ASSERT_TRUE(settles("figures edge", 1, graph + 60)) << rect("figures edge")[1] << " " << graph;
  EXPECT_EQ(state()["history"]["present"], 0);  // no edits
  quit();

  startEditor({tiny().string(), "--size", "900x600", "--set", "volumetrics.technique=none"});
  ASSERT_FALSE(waitFor([](const Json& s) { return s["frames"] >= 3; }).is_null()) << errors();
  focus();
  ASSERT_TRUE(settles("viewport", 2, picture - 90)) << width("viewport");
  ASSERT_TRUE(settles("figures edge", 1, graph + 60)) << rect("figures edge")[1];
  // A double click makes it automatic again.
  move(rect("side edge")[0] + 2, 300);
  input({"click", "--repeat", "2", "--delay", "120", "1"});
  ASSERT_TRUE(settles("viewport", 2, picture)) << width("viewport");
  quit();
}

TEST_F(PanelsTest, F10GivesThePictureTheWholeWindow) {
  startTiny("640x420");
  const double divided = width("viewport");
  keys({"F10"});
  ASSERT_TRUE(settles("viewport", 2, 640));
  EXPECT_FALSE(contains("volumetrics.technique"));
  keys({"F10"});
  ASSERT_TRUE(settles("viewport", 2, divided));
  EXPECT_TRUE(contains("volumetrics.technique"));
  quit();
}

TEST_F(PanelsTest, TextGrowsByTheKeyboard) {
  startTiny("1000x700", {"--validate"});
  const image::ByteImage before = look();
  const double row = height("volumetrics.technique");
  for (int i = 0; i < 4; ++i) keys({"ctrl", "equal"});  // 1 to 2
  ASSERT_FALSE(waitFor(
                   [&](const Json& s) {
                     return std::abs(s["widgets"]["volumetrics.technique"][3].get<double>() / row - 2) < 0.1;
                   },
                   20)
                   .is_null())
      << height("volumetrics.technique") << " " << row;
  EXPECT_GT(changedShare(before, look()), 0.1);
  keys({"ctrl", "minus"});
  ASSERT_FALSE(
      waitFor([&](const Json& s) { return s["widgets"]["volumetrics.technique"][3] < 1.9 * row; }, 20).is_null());
  keys({"ctrl", "0"});
  ASSERT_FALSE(waitFor([&](const Json& s) { return s["widgets"]["volumetrics.technique"][3] == row; }, 20).is_null());
  // The same text, pixel by pixel, but for the times below, which no two pictures share.
  const image::ByteImage after = look();
  const Area above = Area::of({0, 0, 1000, rect("figures edge")[1]});
  EXPECT_LT(changedShare(part(before, above), part(after, above)), 0.002);
  quit();
}

TEST_F(PanelsTest, MemoryIsListedByResource) {
  startTiny("900x700", {"--set", "volumetrics.technique=exact"});
  click("tab memory");
  ASSERT_TRUE(appears("memory filter"));
  const Json shown = waitFor([](const Json& s) { return s["facts"].contains("memory.resources"); }, 20);
  ASSERT_FALSE(shown.is_null());
  EXPECT_GT(std::stoi(fact("memory.resources")), 15);
  const auto listed = [](const Json& s) {
    std::size_t count = 0;
    for (const auto& [name, unused] : s["widgets"].items()) count += name.starts_with("memory of ");
    return count;
  };
  ASSERT_GT(listed(state()), 4u);  // those that there is room for
  // Only the rows of what matches stay.
  click("memory filter");
  input({"type", "--delay", "60", "depth"});
  const Json filtered =
      waitFor([&](const Json& s) { return listed(s) > 0 && !s["widgets"].contains("memory of transient images"); }, 20);
  ASSERT_FALSE(filtered.is_null()) << state()["widgets"];
  quit();
}

}  // namespace
}  // namespace tyndall::editor_test
