// The project's own tree against the arrows of docs/architecture.md.
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "include_rules.hpp"

namespace tyndall::arrows {
namespace fs = std::filesystem;

namespace {

std::map<std::string, std::string> readTree() {
  std::map<std::string, std::string> tree;
  const fs::path root = TYNDALL_SOURCE_DIR;
  for (const char* part : {"engine", "plugins", "editor", "samples", "shaders", "tests"}) {
    if (!fs::exists(root / part)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / part)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".cpp" && extension != ".hpp" && extension != ".c" && extension != ".h" && extension != ".glsl")
        continue;
      std::ifstream file(entry.path());
      tree[entry.path().lexically_relative(root).generic_string()] = {std::istreambuf_iterator<char>(file), {}};
    }
  }
  return tree;
}

std::string lines(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& line : list) text += "\n  " + line;
  return text;
}

}  // namespace

TEST(Arrows, PointDownOnly) {
  const auto tree = readTree();
  // Files that must have been read, so that an empty tree cannot pass.
  ASSERT_TRUE(tree.count("engine/app/session.cpp"));
  ASSERT_TRUE(tree.count("plugins/abi/include/tyndall/plugin.h"));
  const auto broken = brokenArrows(tree);
  EXPECT_TRUE(broken.empty()) << lines(broken);
}

TEST(Arrows, TreeWasRead) {
  std::size_t includes = 0;
  for (const auto& [path, text] : readTree()) includes += includesOf(text).size();
  EXPECT_GT(includes, 300u);
}

}  // namespace tyndall::arrows
