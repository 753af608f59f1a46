// What is kept of a session that was cut off.
#include <gtest/gtest.h>

#include <fstream>

#include <stdlib.h>

#include "presets.hpp"
#include "recovery.hpp"

namespace tyndall::editor {
namespace {

namespace fs = std::filesystem;

class RecoveryTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "tyndall-recovery-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    params::Parameter parameter;
    parameter.id = "view.exposure", parameter.name = "Exposure", parameter.owner = "engine";
    parameter.type = params::Type::kFloat;
    parameter.defaultValue = 1, parameter.min = parameter.builtMin = 0, parameter.max = parameter.builtMax = 10;
    ASSERT_TRUE(table_.add({parameter}));
    ASSERT_TRUE(table_.set("view.exposure", 2.5));
  }
  void TearDown() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  fs::path folder_;
  params::Table table_;
};

TEST_F(RecoveryTest, SettingsComeBackAndNothingIsWrittenOver) {
  EXPECT_EQ(recoveryNote(folder_), "");
  EXPECT_EQ(recoveryNote(folder_ / "missing"), "");
  const fs::path deep = folder_ / "not yet there";
  for (const char* name : {"recovered-1.json", "recovered-2.json"}) {
    auto kept = writeRecovery(deep, table_, nullptr);
    ASSERT_TRUE(kept) << kept.error().message;
    EXPECT_EQ(*kept, (deep / name).string());
    EXPECT_NE(recoveryNote(deep).find(*kept), std::string::npos);
    params::Table other = table_;
    other.resetToDefaults();
    ASSERT_TRUE(loadPreset(other, *kept));
    EXPECT_EQ(other.value("view.exposure"), 2.5);
    ASSERT_TRUE(table_.set("view.exposure", 2.5));
  }
}

TEST_F(RecoveryTest, AnEditedLevelIsKeptBeside) {
  scene::Scene level;
  auto kept = writeRecovery(folder_, table_, &level);
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_TRUE(fs::exists(folder_ / "recovered-1.glb"));
  EXPECT_NE(recoveryNote(folder_).find("recovered-1.glb"), std::string::npos);
}

TEST_F(RecoveryTest, WhatCannotBeKeptIsSaid) {
  std::ofstream(folder_ / "file") << "x";
  EXPECT_FALSE(writeRecovery(folder_ / "file", table_, nullptr));
}

}  // namespace
}  // namespace tyndall::editor
