// Loading, refusing, unloading and reloading plugins.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/file.hpp"
#include "host/host.hpp"
#include "temporary_folder.hpp"
#include "tyndall/plugin.h"

namespace tyndall::host {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

fs::path library(const std::string& name) { return fs::path(TYNDALL_TEST_PLUGINS) / (name + ".so"); }

/// Lines of the memory map that belong to loaded copies of plugins.
std::size_t mappedPluginParts() {
  std::ifstream maps("/proc/self/maps");
  std::size_t count = 0;
  for (std::string line; std::getline(maps, line);) count += line.find("tyndall-plugin-") != std::string::npos;
  return count;
}
std::size_t mappedParts() {
  std::ifstream maps("/proc/self/maps");
  std::size_t count = 0;
  for (std::string line; std::getline(maps, line);) ++count;
  return count;
}

TEST(Load, copiesEverything) {
  auto plugin = Plugin::load(library("good"));
  ASSERT_TRUE(plugin) << plugin.error().message;
  EXPECT_EQ((*plugin)->id(), "variant");
  EXPECT_EQ((*plugin)->name(), "Variant");
  EXPECT_EQ((*plugin)->version(), "1.0.0");
  EXPECT_EQ((*plugin)->path(), library("good"));
  ASSERT_EQ((*plugin)->parameters().size(), 4u);
  EXPECT_EQ((*plugin)->parameters()[0].id, "variant.kept");
  EXPECT_EQ((*plugin)->parameters()[0].owner, "variant");
  EXPECT_EQ((*plugin)->selector(), 2u);
  ASSERT_EQ((*plugin)->techniques().size(), 1u);
  EXPECT_EQ((*plugin)->techniques()[0].reads.at(0), "variant.kept");
  // A choice of the selector that no technique has is refused by name; "none" always works.
  const auto& mode = (*plugin)->parameters()[2];
  EXPECT_TRUE(params::fromText(mode, "none"));
  EXPECT_TRUE(params::fromText(mode, "plain"));
  EXPECT_THAT(params::fromText(mode, "fancy").error().message, HasSubstr("'fancy' is not built yet"));
  EXPECT_FALSE((*plugin)->fileChanged());
}

TEST(Load, theTemplateIsAPlugin) {
  auto plugin = Plugin::load(fs::path(TYNDALL_BIN_DIR) / "sample_plugins/fog_depth.so");
  ASSERT_TRUE(plugin) << plugin.error().message;
  EXPECT_EQ((*plugin)->id(), "fog_depth");
  EXPECT_EQ((*plugin)->selector(), TY_NONE);
  EXPECT_TRUE((*plugin)->techniques().empty());
}

TEST(Load, refusesInOneLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"newer_major", "built for plugin ABI 2.0; this program takes 1.3"},
      {"newer_minor", "built for plugin ABI 1.4; this program takes 1.3"},
      {"zero_struct", "id"},
      {"no_symbol", "no symbol 'tyndall_plugin'"},
      {"init_fails", "its init failed: I do not want to; not today"},
      {"create_fails", "its create failed"},
      {"no_layout", "'layout' is missing"},
      {"bad_id", "'../variant'"},
      {"null_name", "name: is null"},
      {"null_table", "null"},
      {"endless_table", "4294967295"},
      {"duplicate_id", "variant.kept: appears twice"},
      {"unsized_row", "parameters[3]: struct_size is 0"},
      {"nan_default", "variant.nan"},
      {"bad_selector", "selector is parameter 99"},
      {"default_not_built", "variant.mode: 'fancy' is not built yet"},
      {"unresolved", "tyndall_test_function_that_nobody_defines"},
  };
  const std::size_t before = mappedPluginParts();
  for (const auto& [name, says] : cases) {
    testing::internal::CaptureStderr();
    const auto plugin = Plugin::load(library(name));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "the refusal is the one line";
    ASSERT_FALSE(plugin) << name;
    EXPECT_THAT(plugin.error().message,
                AllOf(StartsWith(library(name).string() + ": "), HasSubstr(says), Not(HasSubstr("\n"))))
        << name;
    EXPECT_EQ(plugin.error().kind, ErrorKind::kFailed);
  }
  EXPECT_EQ(mappedPluginParts(), before) << "a refused plugin stays loaded";
}

TEST(Load, anOlderShorterStructIsTaken) {
  auto plugin = Plugin::load(library("short_struct"));
  ASSERT_TRUE(plugin) << plugin.error().message;
}

TEST(Load, refusesWhatIsNoLibrary) {
  test::TemporaryFolder folder;
  const auto refused = [&](const fs::path& file, const char* says) {
    const auto plugin = Plugin::load(file);
    ASSERT_FALSE(plugin) << file;
    EXPECT_THAT(plugin.error().message, AllOf(StartsWith(file.string() + ": "), HasSubstr(says), Not(HasSubstr("\n"))))
        << file;
  };
  refused(folder.path() / "missing.so", "No such file");
  refused(folder.path(), "regular file");
  ASSERT_TRUE(writeTextAtomically(folder.path() / "text.so", "hello"));
  refused(folder.path() / "text.so", "not a whole shared library");
  ASSERT_TRUE(writeTextAtomically(folder.path() / "empty.so", ""));
  refused(folder.path() / "empty.so", "not a whole shared library");
  refused("/proc/self/exe", "");
  // Cut anywhere, a library is refused, not mapped and run.
  const auto whole = readFile(library("good"));
  ASSERT_TRUE(whole);
  for (std::size_t tenth = 0; tenth < 10; ++tenth) {
    ASSERT_TRUE(writeFileAtomically(folder.path() / "cut.so", std::span(*whole).first(whole->size() * tenth / 10)));
    refused(folder.path() / "cut.so", "not a whole shared library");
  }
}

TEST(Load, fiftyTimesWithoutGrowth) {
  test::TemporaryFolder temporary;
  ::setenv("TMPDIR", temporary.path().c_str(), 1);
  ASSERT_TRUE(Plugin::load(library("good")));  // what the first load leaves behind (heap) is not counted
  const std::size_t mapped = mappedParts();
  for (int i = 0; i < 50; ++i) {
    auto first = Plugin::load(library("good"));
    auto second = Plugin::load(library(i % 2 ? "good" : "rebuilt"));  // two at once, also of the same file
    ASSERT_TRUE(first && second);
    EXPECT_GT(mappedPluginParts(), 0u);
  }
  EXPECT_EQ(mappedPluginParts(), 0u);
  // Everything else in the process may map a little too (a sanitizer's allocator does); one part left by each load is
  // 100.
  EXPECT_LE(mappedParts(), mapped + 20);
  EXPECT_TRUE(fs::is_empty(temporary.path())) << "a copy was left behind";
  ::unsetenv("TMPDIR");
}

TEST(Load, aRebuiltPluginReplacesTheOldOneAndKeepsItsValues) {
  test::TemporaryFolder folder;
  const fs::path file = folder.path() / "variant.so";
  fs::copy_file(library("good"), file);
  auto plugin = Plugin::load(file);
  ASSERT_TRUE(plugin) << plugin.error().message;
  params::Table table;
  ASSERT_TRUE(table.add((*plugin)->parameters()));
  ASSERT_TRUE(table.setAssignment("variant.kept=7.5"));
  ASSERT_TRUE(table.setAssignment("variant.far=9"));
  ASSERT_TRUE(table.setAssignment("variant.mode=plain"));

  EXPECT_FALSE((*plugin)->fileChanged());
  fs::copy_file(library("rebuilt"), file, fs::copy_options::overwrite_existing);
  EXPECT_TRUE((*plugin)->fileChanged());
  EXPECT_EQ((*plugin)->version(), "1.0.0");
  const std::string owner = (*plugin)->id();
  plugin->reset();
  table.remove(owner);
  auto again = Plugin::load(file);
  ASSERT_TRUE(again) << again.error().message;
  ASSERT_TRUE(table.add((*again)->parameters()));
  EXPECT_EQ((*again)->version(), "2.0.0");
  EXPECT_FALSE((*again)->fileChanged());
  EXPECT_EQ(table.value("variant.kept"), 7.5);
  EXPECT_EQ(table.value("variant.mode"), 1);
  EXPECT_EQ(table.value("variant.far"), 1) << "9 is beyond the rebuilt plugin's range";
  EXPECT_EQ(table.value("variant.untouched"), 3) << "the new default";
}

TEST(Load, aFolderGivesPluginsAndErrors) {
  test::TemporaryFolder folder;
  EXPECT_EQ(loadPlugins(folder.path() / "missing").errors.size(), 1u);
  EXPECT_TRUE(loadPlugins(folder.path()).plugins.empty());
  fs::copy_file(library("good"), folder.path() / "b_good.so");
  fs::copy_file(library("newer_major"), folder.path() / "a_newer.so");
  fs::copy_file(library("rebuilt"), folder.path() / "c_same_id.so");
  fs::copy_file(TYNDALL_BIN_DIR "/sample_plugins/fog_depth.so", folder.path() / "d_fog.so");
  ASSERT_TRUE(writeTextAtomically(folder.path() / "readme.txt", "no plugin"));
  const PluginSet set = loadPlugins(folder.path());
  ASSERT_EQ(set.plugins.size(), 2u);
  EXPECT_EQ(set.plugins[0]->id(), "variant");
  EXPECT_EQ(set.plugins[0]->version(), "1.0.0");
  EXPECT_EQ(set.plugins[1]->id(), "fog_depth");
  ASSERT_EQ(set.errors.size(), 2u);
  EXPECT_THAT(set.errors[0].message, HasSubstr("a_newer.so"));
  EXPECT_THAT(set.errors[1].message, HasSubstr("already that of"));
}

}  // namespace
}  // namespace tyndall::host
