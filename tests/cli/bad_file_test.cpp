// Files, folders, plugins and devices that are wrong or missing: exit status 1 and one line.
#include <cstdlib>

#include <sys/wait.h>

#include "process.hpp"

namespace tyndall::cli {
namespace {

namespace fs = std::filesystem;
using BadFile = CliTest;

const fs::path kLevel = fs::path(TYNDALL_BIN_DIR) / "levels" / "hall.glb";

TEST_F(BadFile, Levels) {
  expectRefused({"render", "missing.glb", "--out", "a.png"}, 1, {"missing.glb"});
  writeText(folder_ / "empty.glb", "");
  expectRefused({"render", "empty.glb", "--out", "a.png"}, 1, {"empty.glb"});
  writeText(folder_ / "text.gltf", "this is no JSON");
  expectRefused({"render", "text.gltf", "--out", "a.png"}, 1, {"text.gltf"});
  writeText(folder_ / "outside.gltf",
            R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"../../etc/passwd"}]})");
  expectRefused({"render", "outside.gltf", "--out", "a.png"}, 1, {"outside.gltf"});
  fs::create_directory(folder_ / "folder.glb");
  expectRefused({"render", "folder.glb", "--out", "a.png"}, 1, {"folder.glb"});
  expectRefused({"truth", "missing.glb", "--out", "a.exr"}, 1, {"missing.glb"});
}

TEST_F(BadFile, TruncatedLevel) {
  const std::string whole = readText(kLevel);
  ASSERT_GT(whole.size(), 1000u);
  for (const std::size_t size :
       {std::size_t{11}, std::size_t{20}, std::size_t{500}, whole.size() / 2, whole.size() - 1}) {
    writeText(folder_ / "cut.glb", whole.substr(0, size));
    expectRefused({"render", "cut.glb", "--out", "a.png"}, 1, {"cut.glb"});
  }
}

TEST_F(BadFile, LineFeedInANameStaysOneLine) {
  expectRefused({"render", "two\nlines.glb", "--out", "a.png"}, 1, {"two?lines.glb"});
}

TEST_F(BadFile, Presets) {
  expectRefused({"render", "hall", "--preset", "missing.json"}, 1, {"--preset", "missing.json"});
  writeText(folder_ / "broken.json", "{\"medium.g\": ");
  const Outcome outcome = tyndall({"render", "hall", "--preset", "broken.json"});
  EXPECT_TRUE(outcome.status == 1 || outcome.status == 2) << outcome.status;
  EXPECT_EQ(outcome.errorLines().size(), 1u) << outcome.err;
}

TEST_F(BadFile, OutputFolders) {
  expectRefused({"render", "hall", "--out", "nowhere/a.png"}, 1, {"--out", "nowhere"});
  fs::create_directory(folder_ / "d.png");
  expectRefused({"render", "hall", "--out", "d.png"}, 1, {"--out", "d.png", "folder"});
}

TEST_F(BadFile, ALaterOutputThatFailsLeavesNoEarlierOne) {
  writeText(folder_ / "kept.png", "what was there before");
  // /proc takes no new files, whoever asks.
  expectRefused({"render", "hall", "--size", "32x18", "--out", "kept.png", "--scatter", "new.exr", "--stats",
                 "/proc/tyndall.json"},
                1, {"/proc/tyndall.json"});
  EXPECT_EQ(readText(folder_ / "kept.png"), "what was there before");
}

TEST_F(BadFile, Plugins) {
  fs::create_directory(folder_ / "none");
  expectRefused({"render", "hall", "--plugin-dir", "none", "--out", "a.png"}, 1, {"none"});
  expectRefused({"render", "hall", "--out", "a.png"}, 1, {"none"}, {{"TYNDALL_PLUGIN_DIR", "none"}});
  expectRefused({"describe", "--plugin-dir", "nowhere"}, 1, {"nowhere"});
  fs::create_directory(folder_ / "text");
  writeText(folder_ / "text" / "volumetrics.so", "not a library");
  expectRefused({"render", "hall", "--plugin-dir", "text"}, 1, {"volumetrics.so"});
}

TEST_F(BadFile, PluginOfAnotherAbi) {
  expectRefused({"describe", "--plugin-dir", TYNDALL_OTHER_ABI_DIR}, 1, {"volumetrics.so", "2.0", "1.3"});
}

const Environment kNoDevice = {{"VK_ICD_FILENAMES", "/nonexistent.json"}, {"VK_DRIVER_FILES", "/nonexistent.json"}};

TEST_F(BadFile, NoDevice) {
  expectRefused({"render", "hall", "--out", "a.png"}, 1, {"Vulkan"}, kNoDevice);
  // A wrong call is told before the lack of a device.
  expectRefused({"render", "hall", "--set", "medium.g=9"}, 2, {"medium.g"}, kNoDevice);
  expectRefused({"render", "hall", "--device", "no such device", "--out", "a.png"},
                tyndall({"render", "hall", "--device", "no such device"}).status, {"no such device"});
}

TEST_F(BadFile, FullDiskOnStdout) {
  const std::string command = "'" + std::string(TYNDALL_BIN_DIR) + "/tyndall' describe > /dev/full 2>/dev/null";
  const int state = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(state));
  EXPECT_EQ(WEXITSTATUS(state), 1);
}

}  // namespace
}  // namespace tyndall::cli
