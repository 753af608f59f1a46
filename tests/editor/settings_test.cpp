#include <fstream>

#include <gtest/gtest.h>
#include <stdlib.h>

#include "presets.hpp"
#include "settings_file.hpp"

namespace tyndall::editor {
namespace {

namespace fs = std::filesystem;

class FilesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "tyndall-settings-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path write(const char* name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  fs::path folder_;
};

params::Table makeTable() {
  params::Table table;
  params::Parameter whole;
  whole.id = whole.name = "a.whole", whole.type = params::Type::kInt, whole.min = whole.builtMin = 0,
  whole.max = whole.builtMax = 100, whole.defaultValue = 5;
  params::Parameter fraction = whole;
  fraction.id = fraction.name = "a.fraction", fraction.type = params::Type::kFloat;
  EXPECT_TRUE(table.add({whole, fraction}));
  return table;
}

TEST_F(FilesTest, SettingsComeBack) {
  const fs::path path = folder_ / "new" / "folder" / "editor.json";
  Settings settings;
  for (int i = 0; i < 12; ++i) settings.opened("level" + std::to_string(i));
  settings.opened("level7");
  ASSERT_EQ(settings.recentLevels.size(), 10u);
  EXPECT_EQ(settings.recentLevels[0], "level7");
  EXPECT_EQ(settings.recentLevels[1], "level11");
  settings.captureFolder = "/some/where", settings.captureDepth = true, settings.budgetMs = 8.25;
  settings.layout = {.panels = false, .side = 312, .figures = 200.5f, .fields = 90, .textScale = 1.5f};
  std::string problem;
  SettingsFile first(path);
  EXPECT_EQ(first.read(problem), Settings());
  ASSERT_TRUE(first.write(settings));
  SettingsFile second(path);
  EXPECT_EQ(second.read(problem), settings);
  EXPECT_EQ(problem, "");
}

TEST_F(FilesTest, BrokenSettingsAreSetAsideAndSaid) {
  for (const char* text : {"{", "[]", "12", "{\"recent_levels\": 3}", "{\"budget_ms\": -1}",
                           "{\"layout\": {\"side\": -3}}", "{\"layout\": {\"text_scale\": 90}}",
                           "{\"layout\": {\"panels\": 1}}", "{\"capture\": {\"picture\": \"yes\"}}", ""}) {
    SCOPED_TRACE(text);
    const fs::path path = write("editor.json", text);
    SettingsFile file(path);
    std::string problem;
    EXPECT_EQ(file.read(problem), Settings());
    EXPECT_NE(problem.find("editor.json"), std::string::npos);
    EXPECT_EQ(std::count(problem.begin(), problem.end(), '\n'), 0);
    EXPECT_FALSE(fs::exists(path));
    EXPECT_TRUE(fs::exists(folder_ / "editor.json.broken"));
    Settings changed;
    changed.budgetMs = 3;
    EXPECT_TRUE(file.write(changed));  // a new one takes its place
    EXPECT_EQ(file.read(problem), changed);
  }
}

TEST_F(FilesTest, APresetSetsWhatItNames) {
  params::Table table = makeTable();
  ASSERT_TRUE(table.set("a.fraction", 99));
  const fs::path file = write("p.json", R"({"a.whole": 7})");
  ASSERT_TRUE(loadPreset(table, file));
  EXPECT_EQ(table.value("a.whole"), 7);
  EXPECT_EQ(table.value("a.fraction"), 99) << "what it does not name stays";
  ASSERT_TRUE(table.set("a.fraction", 1.0 / 3));
  EXPECT_TRUE(comparePreset(table, file)->empty()) << "nor is it compared";
  ASSERT_TRUE(table.set("a.whole", 8));
  auto apart = comparePreset(table, file);
  ASSERT_TRUE(apart);
  ASSERT_EQ(apart->size(), 1u);
  EXPECT_EQ((*apart)[0].id, "a.whole");
  EXPECT_EQ((*apart)[0].there, "7");
  ASSERT_TRUE(savePreset(table, folder_ / "saved.json"));
  EXPECT_TRUE(comparePreset(table, folder_ / "saved.json")->empty());  // to the last digit
}

TEST_F(FilesTest, ABadPresetChangesNothing) {
  params::Table table = makeTable();
  ASSERT_TRUE(table.set("a.whole", 9));
  for (const char* text : {"{", R"({"a.whole": 7, "a.fraction": 101})", R"({"a.whole": 7, "a.other": 1})"}) {
    auto loaded = loadPreset(table, write("bad.json", text));
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error().message.find("bad.json"), std::string::npos);
    EXPECT_EQ(table.value("a.whole"), 9);
  }
  EXPECT_FALSE(comparePreset(table, folder_ / "missing.json"));
}

}  // namespace
}  // namespace tyndall::editor
