// Cookies of lights: their form in the file, what is refused, and the light's frame that turns them.
#include <functional>

#include <glm/gtc/matrix_transform.hpp>

#include "gltf_file.hpp"
#include "scene/write_glb.hpp"

namespace tyndall::scene {
namespace {

using Json = nlohmann::json;

std::string png(std::uint32_t width, std::uint32_t height) {
  Scene s;
  s.images = {{"", width, height, std::vector<std::uint8_t>(4ull * width * height, 200)}};
  TemporaryFolder folder;
  EXPECT_TRUE(writeGlb(s, folder / "a.glb").ok());
  std::ifstream in(folder / "a.glb", std::ios::binary);
  const std::string glb{std::istreambuf_iterator<char>(in), {}};
  const std::size_t begin = glb.find("\x89PNG");
  return glb.substr(begin, glb.find(std::string("IEND\xae\x42\x60\x82")) + 8 - begin);
}

/// One light of `type` with these extras, one image of this size, which nothing else shows.
struct Level : GltfFile {
  Level(const std::string& type, const Json& extras, std::uint32_t width = 4, std::uint32_t height = 2) {
    folder.write("a.png", png(width, height));
    json["images"] = {{{"uri", "a.png"}}, {{"uri", "not there.png"}}};
    json["textures"] = {{{"source", 1}}, {{"source", 0}}, Json::object()};
    json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", type}, {"name", "lamp"}, {"extras", extras}}};
    json["nodes"] = {{{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
  }
  /// What is said of a level that has to load without the cookie.
  std::string toldWithout() {
    const auto path = save();
    const auto loaded = loadGltf(path);
    EXPECT_TRUE(loaded.ok());
    if (loaded.ok()) {
      EXPECT_FALSE(loaded->scene.lights[0].cookie);
    }
    return told(loaded, path);
  }
};

Json cookie(const Json& value) { return {{"cookie", value}}; }

TEST(Cookies, AreReadFromTheLightsExtras) {
  Level level("directional", {{"other", "kept out"}, {"cookie", {{"index", 1}, {"size", {3, 0.5}}}}});
  const Scene s = level.scene();
  ASSERT_TRUE(s.lights[0].cookie);
  EXPECT_EQ(s.lights[0].cookie->texture, 0) << "counted anew: the first texture is shown by nothing";
  EXPECT_EQ(s.lights[0].cookie->size, glm::vec2(3, 0.5f));
  ASSERT_EQ(s.images.size(), 1u);
  EXPECT_EQ(s.images[0].width, 4u);
  EXPECT_EQ(s.images[0].rgba[0], 200);

  EXPECT_EQ(Level("directional", cookie({{"index", 1}})).scene().lights[0].cookie->size, glm::vec2(10));
  EXPECT_TRUE(Level("spot", cookie({{"index", 1}})).scene().lights[0].cookie);
  EXPECT_TRUE(Level("point", cookie({{"index", 1}}), 4, 2).scene().lights[0].cookie);
  EXPECT_TRUE(Level("point", cookie({{"index", 1}}), 12, 2).scene().lights[0].cookie);
}

TEST(Cookies, OtherExtrasAreOthersBusiness) {
  for (const Json& extras : {Json(7), Json("text"), Json(nullptr), Json::array({1, 2}), Json::object()})
    EXPECT_FALSE(Level("spot", extras).scene().lights[0].cookie) << extras;
}

TEST(Cookies, WithoutAnImageIsLeftOut) {
  Level level("spot", cookie({{"index", 2}}));
  const auto loaded = level.load();
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_FALSE(loaded->scene.lights[0].cookie);
  bool told = false;
  for (const std::string& warning : loaded->warnings)
    told |= warning.starts_with("textures[2] has no PNG or JPEG image");
  EXPECT_TRUE(told);
}

TEST(Cookies, BrokenOnesAreLeftOutInALine) {
  const std::string at = "extensions.KHR_lights_punctual.lights[0].extras.cookie";
  const auto expect = [](Level level, const std::string& reason) {
    const std::string text = level.toldWithout();
    EXPECT_NE(text.find(reason), std::string::npos) << text << "\n  does not say: " << reason;
  };
  const auto broken = [&](const Json& value, const std::string& reason) {
    expect(Level("directional", cookie(value)), at + reason);
  };
  broken("stars", " is not an object");
  broken(nullptr, " is not an object");
  broken(Json::object(), ".index is missing");
  broken({{"index", 3}}, ".index is 3; there are 3 textures");
  broken({{"index", -1}}, ".index is -1");
  broken({{"index", "1"}}, ".index is not an index");
  // A size is optional: a broken one is as if it were not there.
  const auto brokenSize = [&](const Json& size, const std::string& reason) {
    Level level("directional", cookie({{"index", 1}, {"size", size}}));
    const auto loaded = level.load();
    ASSERT_TRUE(loaded.ok());
    ASSERT_TRUE(loaded->scene.lights[0].cookie);
    EXPECT_EQ(loaded->scene.lights[0].cookie->size, glm::vec2(10));
    const std::string lines = told(loaded, level.folder / "level.gltf");
    EXPECT_NE(lines.find(at + reason), std::string::npos) << lines;
  };
  brokenSize(4, ".size is not an array");
  brokenSize({4}, ".size has 1 elements; 2 are expected");
  brokenSize({4, 0}, ".size[1] is 0; it must be from");
  brokenSize({-4, 1}, ".size[0] is -4; it must be from");
  brokenSize({1, 1e300}, ".size[1] is 1e+300; it must be from");
  brokenSize({1, nullptr}, ".size[1] is not a number");
  expect(Level("spot", cookie({{"index", 0}})), "not there.png");
  for (const glm::uvec2 size : {glm::uvec2(3, 2), {1, 1}, {2, 12}, {13, 2}})
    expect(Level("point", cookie({{"index", 1}}), size.x, size.y),
           "lights[0] \"lamp\" is a point light whose cookie is " + std::to_string(size.x) + "x" +
               std::to_string(size.y) + "; it must be 2:1 (equirectangular) or 6:1");
}

TEST(Cookies, TurnWithTheirNodeWithoutItsScale) {
  Scene s;
  s.lights = {{}};
  s.nodes.resize(2);
  s.nodes[0].scale = {3, 5, 7};
  s.nodes[1].parent = 0;
  s.nodes[1].light = 0;
  s.nodes[1].rotation =
      glm::angleAxis(0.5f * 3.14159265f, glm::vec3(0, 1, 0)) * glm::angleAxis(0.5f * 3.14159265f, glm::vec3(0, 0, 1));
  const auto lights = placedLights(s, 0);
  ASSERT_EQ(lights.size(), 1u);
  const glm::mat3& frame = lights[0].worldFromLight;
  // Rolled first (right becomes up, up left), then turned from -z to -x about y: left is then +z.
  EXPECT_LT(glm::distance(frame[0], glm::vec3(0, 1, 0)), 1e-5f);
  EXPECT_LT(glm::distance(frame[1], glm::vec3(0, 0, 1)), 1e-5f);
  EXPECT_LT(glm::distance(frame[2], -lights[0].direction), 1e-6f);
  EXPECT_LT(glm::distance(frame[2], glm::vec3(1, 0, 0)), 1e-5f);
  EXPECT_LT(glm::distance(defaultSun().worldFromLight[2], -defaultSun().direction), 1e-6f);
}

}  // namespace
}  // namespace tyndall::scene
