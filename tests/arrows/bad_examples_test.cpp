// The arrow test must be able to fail: trees with one arrow broken, and what is said about each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "include_rules.hpp"

namespace tyndall::arrows {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> check(const std::string& path, const std::string& text) {
  return brokenArrows({{path, text},
                       {"engine/scene/include/scene/scene.hpp", ""},
                       {"engine/gpu/include/gpu/device.hpp", ""},
                       {"engine/gpu/state.hpp", ""},
                       {"plugins/volumetrics/geometry/epipolar.hpp", ""},
                       {"shaders/lib/medium.glsl", ""},
                       {"shaders/shared/types.h", ""}});
}

TEST(BadExamples, GpuSeesScene) {
  EXPECT_THAT(check("engine/gpu/x.cpp", "#include <vector>\n#include \"scene/scene.hpp\"\n"),
              ElementsAre("engine/gpu/x.cpp:2 includes scene/scene.hpp: gpu may not see scene"));
}

TEST(BadExamples, UpwardArrows) {
  EXPECT_THAT(check("engine/scene/x.cpp", "#include <gpu/device.hpp>\n"),
              ElementsAre(HasSubstr("scene may not see gpu")));
  EXPECT_THAT(check("engine/render/x.cpp", "#include \"params/params.hpp\"\n"),
              ElementsAre(HasSubstr("render may not see params")));
  EXPECT_THAT(check("engine/render/x.cpp", "#include \"tyndall/plugin.h\"\n"),
              ElementsAre(HasSubstr("render may not see abi")));
  EXPECT_THAT(check("engine/truth/x.cpp", "#include \"render/frame.hpp\"\n"),
              ElementsAre(HasSubstr("truth may not see render")));
  EXPECT_THAT(check("engine/truth/x.cpp", "#include \"lib/medium.glsl\"\n"),
              ElementsAre(HasSubstr("truth may not see lib")));
  EXPECT_THAT(check("engine/base/x.cpp", "#include \"image/image_io.hpp\"\n"),
              ElementsAre(HasSubstr("base may not see image")));
  EXPECT_THAT(check("engine/host/x.cpp", "#include \"app/session.hpp\"\n"),
              ElementsAre(HasSubstr("host may not see app")));
}

TEST(BadExamples, RelativePathIntoAnotherRoom) {
  EXPECT_THAT(check("engine/scene/x.cpp", "#include \"../gpu/state.hpp\"\n"),
              ElementsAre(HasSubstr("scene may not see gpu")));
}

TEST(BadExamples, Plugins) {
  EXPECT_THAT(check("plugins/volumetrics/plugin.cpp", "#include \"gpu/device.hpp\"\n"),
              ElementsAre(HasSubstr("plugin:volumetrics may not see gpu")));
  EXPECT_THAT(check("plugins/volumetrics/plugin.cpp", "#include <vulkan/vulkan.h>\n"),
              ElementsAre(HasSubstr("Vulkan may not be used in plugin:volumetrics")));
  EXPECT_THAT(check("plugins/volumetrics/plugin.cpp", "#include <unistd.h>\n"),
              ElementsAre(HasSubstr("may use only the ABI")));
  EXPECT_THAT(check("plugins/other/plugin.cpp", "#include \"../volumetrics/geometry/epipolar.hpp\"\n"),
              ElementsAre(HasSubstr("plugin:other may not see plugin:volumetrics")));
}

TEST(BadExamples, Libraries) {
  EXPECT_THAT(check("engine/render/x.cpp", "#include <imgui.h>\n"),
              ElementsAre(HasSubstr("Dear ImGui may not be used in render")));
  EXPECT_THAT(check("engine/gpu/x.cpp", "#include <GLFW/glfw3.h>\n"),
              ElementsAre(HasSubstr("GLFW may not be used in gpu")));
  EXPECT_THAT(check("engine/gpu/x.cpp", "#include <dlfcn.h>\n"),
              ElementsAre(HasSubstr("dlopen may not be used in gpu")));
  EXPECT_THAT(check("engine/params/include/params/x.hpp", "#include <nlohmann/json.hpp>\n"),
              ElementsAre(HasSubstr("may not be in a header")));
}

TEST(BadExamples, TinygltfInTwoFiles) {
  const auto broken = brokenArrows(
      {{"engine/scene/gltf.cpp", "#include <tiny_gltf.h>\n"}, {"engine/scene/second.cpp", "#include <tiny_gltf.h>\n"}});
  EXPECT_THAT(broken,
              ElementsAre("tinygltf may appear in 1 file, it does in engine/scene/gltf.cpp engine/scene/second.cpp"));
}

TEST(GoodExamples, AreNotReported) {
  EXPECT_THAT(check("engine/render/x.cpp",
                    "#include \"gpu/device.hpp\"\n#include \"scene/scene.hpp\"\n#include \"shared/types.h\"\n#include "
                    "<volk.h>\n"),
              IsEmpty());
  EXPECT_THAT(
      check("engine/host/x.cpp", "#include \"gpu/device.hpp\"\n#include <tyndall/plugin.h>\n#include <dlfcn.h>\n"),
      IsEmpty());
  EXPECT_THAT(check("plugins/volumetrics/plugin.cpp",
                    "#include <tyndall/plugin.h>\n#include <cmath>\n#include <stdint.h>\n#include "
                    "<glm/glm.hpp>\n#include \"geometry/epipolar.hpp\"\n#include \"lib/medium.glsl\"\n"),
              IsEmpty());
  EXPECT_THAT(check("editor/main.cpp", "#include <GLFW/glfw3.h>\n#include <imgui.h>\n#include \"app/session.hpp\"\n"),
              IsEmpty());
}

TEST(Includes, CommentsDoNotCount) {
  const auto includes = includesOf(
      "// #include \"a.hpp\"\n/* \n#include \"b.hpp\"\n*/\n  #  include <c> // why\nconst char* t = \"/*\";\n#include "
      "\"d.hpp\"\n");
  ASSERT_EQ(includes.size(), 2u);
  EXPECT_EQ(includes[0].target, "c");
  EXPECT_EQ(includes[0].line, 5);
  EXPECT_FALSE(includes[0].quoted);
  EXPECT_EQ(includes[1].target, "d.hpp");
  EXPECT_EQ(includes[1].line, 7);
}

}  // namespace
}  // namespace tyndall::arrows
