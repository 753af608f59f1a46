#include <cstdlib>

#include <gtest/gtest.h>

#include "app/outputs.hpp"
#include "base/file.hpp"

namespace tyndall::app {
namespace {

namespace fs = std::filesystem;

class OutputsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "tyndall-outputs-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  static Outputs::Write text(std::string content) {
    return [content](const fs::path& path) { return writeTextAtomically(path, content); };
  }
  fs::path folder_;
};

TEST_F(OutputsTest, NothingIsInPlaceBeforeCommit) {
  Outputs outputs;
  ASSERT_TRUE(outputs.add("--out", folder_ / "a.png", ".png").ok());
  ASSERT_TRUE(outputs.write("--out", text("new")).ok());
  EXPECT_FALSE(fs::exists(folder_ / "a.png"));
  ASSERT_TRUE(outputs.commit().ok());
  EXPECT_EQ(*readText(folder_ / "a.png"), "new");
  EXPECT_EQ(count(), 1u);
}

TEST_F(OutputsTest, AFailureLeavesNothingAndKeepsWhatWasThere) {
  ASSERT_TRUE(writeTextAtomically(folder_ / "a.png", "old").ok());
  {
    Outputs outputs;
    ASSERT_TRUE(outputs.add("--out", folder_ / "a.png", ".png").ok());
    ASSERT_TRUE(outputs.add("--stats", folder_ / "s.json", ".json").ok());
    ASSERT_TRUE(outputs.write("--out", text("new")).ok());
    auto second = outputs.write("--stats", [](const fs::path& path) -> Result<void> {
      return failed(path.string() + ": cannot be written: disk full");
    });
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error().message, "--stats " + (folder_ / "s.json").string() + ": cannot be written: disk full");
  }
  EXPECT_EQ(*readText(folder_ / "a.png"), "old");
  EXPECT_EQ(count(), 1u);
}

TEST_F(OutputsTest, IfOneCannotBePlacedThoseBeforeAreRemoved) {
  Outputs outputs;
  ASSERT_TRUE(outputs.add("--out", folder_ / "a.png", ".png").ok());
  ASSERT_TRUE(outputs.add("--stats", folder_ / "s.json", ".json").ok());
  ASSERT_TRUE(outputs.write("--out", text("a")).ok());
  ASSERT_TRUE(outputs.write("--stats", text("s")).ok());
  fs::create_directory(folder_ / "s.json");  // somebody was faster
  EXPECT_FALSE(outputs.commit().ok());
  EXPECT_FALSE(fs::exists(folder_ / "a.png"));
}

TEST_F(OutputsTest, ChecksBeforeAnyWork) {
  Outputs outputs;
  outputs.protect(folder_ / "in.png");
  EXPECT_EQ(outputs.add("--out", "", ".png").error().kind, ErrorKind::kBadCall);
  EXPECT_EQ(outputs.add("--out", folder_ / "a.jpg", ".png").error().kind, ErrorKind::kBadCall);
  EXPECT_EQ(outputs.add("--out", folder_ / "none" / "a.png", ".png").error().kind, ErrorKind::kFailed);
  EXPECT_EQ(outputs.add("--out", folder_ / "in.png", ".png").error().kind, ErrorKind::kBadCall);
  EXPECT_TRUE(outputs.add("--out", folder_ / "A.PNG", ".png").ok());
  EXPECT_FALSE(outputs.add("--other", folder_ / "." / "A.PNG", ".png").ok());
  EXPECT_EQ(count(), 0u);
}

}  // namespace
}  // namespace tyndall::app
