// Calls that are wrong: exit status 2 and one line that names what is wrong and what would be right.
#include "process.hpp"

namespace tyndall::cli {
namespace {

using BadCall = CliTest;

TEST_F(BadCall, NoCommandOrAnUnknownOne) {
  expectRefused({}, 2, {"render"});
  expectRefused({"redner", "hall"}, 2, {"redner", "'render'"});
  expectRefused({"--nonsense"}, 2, {"--nonsense"});
}

TEST_F(BadCall, Options) {
  expectRefused({"render", "hall", "--siez", "64x36"}, 2, {"--siez", "--size"});
  expectRefused({"render", "hall", "--out"}, 2, {"--out"});
  expectRefused({"render", "hall", "forest"}, 2, {"forest"});
  expectRefused({"render"}, 2, {"LEVEL"});
  expectRefused({"levels", "x"}, 2, {"x"});
  expectRefused({"describe", "--jsno"}, 2, {"--jsno", "--json"});
}

TEST_F(BadCall, Sizes) {
  for (const char* size :
       {"0", "0x0", "64x0", "0x36", "-1x5", "64", "64x", "x36", "64x36x2", "1e2x36", " 64x36", "64.0x36", ""})
    expectRefused({"render", "hall", "--size", size, "--out", "a.png"}, 2, {"--size"});
  for (const char* size : {"100000x100000", "100000x36", "64x100000", "99999999999999999999x4"})
    expectRefused({"render", "hall", "--size", size, "--out", "a.png"}, 2, {"--size", "at most"});
  expectRefused({"truth", "hall", "--size", "100000x4", "--out", "a.exr"}, 2, {"--size", "at most"});
}

TEST_F(BadCall, Numbers) {
  for (const char* frames : {"0", "-1", "1.5", "many", "99999999999"})
    expectRefused({"render", "hall", "--frames", frames}, 2, {"--frames"});
  for (const char* camera : {"-1", "one", "0x1"})
    expectRefused({"render", "hall", "--camera", camera}, 2, {"--camera"});
  for (const char* seconds : {"-1", "nan", "inf", "soon"})
    expectRefused({"render", "hall", "--time", seconds}, 2, {"--time"});
  for (const char* pose : {"1,2,3", "1,2,3,4,91", "a,b,c,d,e"})
    for (const char* command : {"render", "truth"})
      expectRefused({command, "hall", "--pose", pose}, 2, {"--pose", "X,Y,Z,YAW,PITCH"});
  expectRefused({"truth", "hall", "--samples", "0", "--out", "a.exr"}, 2, {"--samples"});
}

TEST_F(BadCall, CameraOutOfRangeSaysHowManyThereAre) {
  expectRefused({"render", "hall", "--camera", "999", "--out", "a.png"}, 2, {"--camera 999", "hall"});
}

TEST_F(BadCall, Levels) {
  expectRefused({"render", "hal", "--out", "a.png"}, 2, {"hal", "'hall'", "forest", ".glb"});
  expectRefused({"render", "zzzzzz", "--out", "a.png"}, 2, {"zzzzzz", "hall", "forest"});
}

TEST_F(BadCall, Parameters) {
  expectRefused({"render", "hall", "--set", "volumetrics.technik=moments6", "--out", "a.png"}, 2,
                {"volumetrics.technik", "volumetrics.technique"});
  expectRefused({"render", "hall", "--set", "volumetrics.technique=moments7"}, 2, {"volumetrics.technique", "moments"});
  expectRefused({"render", "hall", "--set", "volumetrics.columns=63"}, 2, {"volumetrics.columns", "64", "4096"});
  expectRefused({"render", "hall", "--set", "volumetrics.columns=4097"}, 2, {"volumetrics.columns", "4096"});
  expectRefused({"render", "hall", "--set", "medium.sigma_t=-1"}, 2, {"medium.sigma_t"});
  expectRefused({"render", "hall", "--set", "medium.sigma_t=nan"}, 2, {"medium.sigma_t"});
  expectRefused({"render", "hall", "--set", "medium.g"}, 2, {"medium.g"});
  expectRefused({"render", "hall", "--set", "medium.g="}, 2, {"medium.g"});
}

TEST_F(BadCall, NotBuiltYetIsSaidByName) {
  expectRefused({"render", "hall", "--set", "volumetrics.reuse=true"}, 2, {"volumetrics.reuse", "not built"});
  expectRefused({"render", "hall", "--set", "shadows.mode=soft"}, 2, {"shadows.mode", "not built"});
  expectRefused({"tune", "hall"}, 2, {"--max-error", "--budget-ms"});
  expectRefused({"tune", "hall", "--max-error", "-1"}, 2, {"--max-error", "above 0"});
  expectRefused({"tune", "hall", "--max-error", "0.1", "--budget-ms", "3"}, 2, {"one of"});
  expectRefused({"tune", "hall", "--max-error", "0.1", "--camera", "99"}, 2, {"99"});
  expectRefused({"tune", "--max-error", "0.1"}, 2, {"LEVEL"});
  expectRefused({"tune", "hall", "--max-error", "0.1", "--hold-out", "99"}, 2, {"99"});
  expectRefused({"tune", "hall", "--max-error", "0.1", "--camera", "1", "--hold-out", "1"}, 2,
                {"--hold-out", "1", "--camera"});
  expectRefused({"tune", "hall", "--max-error", "0.1", "--margin", "2"}, 2, {"--margin", "0 to 0.9"});
  expectRefused({"tune", "hall", "--max-error", "0.1", "--candidates", "none.json"}, 1, {"none.json"});
  expectRefused({"tune", "hall", "--max-error", "0.1", "--out", "p.txt"}, 2, {"--out", ".json"});
  expectRefused({"render", "hall", "--preset", "fsat"}, 2, {"--preset", "fsat", "'fast'"});
}

TEST_F(BadCall, NumbersOfNoView) {
  expectRefused({"render", "hall", "--size", "64x36", "--view-exr", "a.exr"}, 2, {"--view-exr", "--debug-view"});
}
TEST_F(BadCall, DebugView) {
  expectRefused({"render", "hall", "--size", "64x36", "--debug-view", "norml", "--out", "a.png"}, 2,
                {"--debug-view", "norml", "'normal'"});
}

TEST_F(BadCall, OutputNames) {
  expectRefused({"render", "hall", "--out", "a.jpg"}, 2, {"--out", "a.jpg", ".png"});
  expectRefused({"render", "hall", "--scatter", "a.png"}, 2, {"--scatter", ".exr"});
  expectRefused({"render", "hall", "--scatter", "a.exr", "--depth", "./a.exr"}, 2, {"--depth", "--scatter"});
  expectRefused({"truth", "hall"}, 2, {"--out"});
}

TEST_F(BadCall, Presets) {
  writeText(folder_ / "unknown.json", R"({"medium.sigma": 1})");
  expectRefused({"render", "hall", "--preset", "unknown.json"}, 2, {"unknown.json", "medium.sigma"});
  writeText(folder_ / "range.json", R"({"medium.g": 3})");
  expectRefused({"render", "hall", "--preset", "range.json"}, 2, {"range.json", "medium.g"});
}

}  // namespace
}  // namespace tyndall::cli
