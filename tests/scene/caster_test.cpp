// Who casts shadows, what is hidden, glass; and that a level's hash knows all of its files.
#include "gltf_file.hpp"
#include "scene/write_glb.hpp"

namespace tyndall::scene {
namespace {

using Json = nlohmann::json;

Json extras(const Json& casts) { return {{"tyndall", {{"casts_shadow", casts}}}}; }

TEST(Casters, MaterialsAndNodesSay) {
  GltfFile f;
  f.triangle();
  f.json["materials"] = {Json::object(),
                         {{"extensions", {{"KHR_materials_unlit", Json::object()}}}},
                         {{"extensions", {{"KHR_materials_unlit", Json::object()}}}, {"extras", extras(true)}},
                         {{"extras", extras(false)}},
                         {{"extras", extras("no")}}};
  f.json["nodes"] = {{{"mesh", 0}, {"children", {1, 2}}, {"extras", extras(false)}},
                     {{"mesh", 0}},
                     {{"mesh", 0}, {"extras", extras(true)}},
                     {{"mesh", 0}}};
  f.json["scenes"] = {{{"nodes", {0, 3}}}};
  const auto loaded = f.load();
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  const auto check = [](const Scene& s) {
    const bool materials[] = {true, false, true, false, true};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(s.materials[i].castsShadow, materials[i]) << i;
    for (const Node& node : s.nodes) EXPECT_EQ(node.castsShadow, node.order >= 2) << node.order;
  };
  check(loaded->scene);
  ASSERT_EQ(loaded->warnings.size(), 1u);
  EXPECT_NE(loaded->warnings[0].find("casts_shadow"), std::string::npos);
  ASSERT_TRUE(writeGlb(loaded->scene, f.folder / "again.glb").ok());
  const auto again = loadGltf(f.folder / "again.glb");
  ASSERT_TRUE(again.ok());
  const bool order[] = {false, false, true, true};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(again->scene.nodes[i].castsShadow, order[i]) << i;
}

TEST(Casters, HiddenSubtreesAreNotThere) {
  GltfFile f;
  f.triangle();
  f.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  f.json["nodes"] = {{{"children", {1}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}},
                     {{"mesh", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
                     {{"mesh", 0}, {"extensions", {{"KHR_node_visibility", {{"visible", true}}}}}}};
  f.json["scenes"] = {{{"nodes", {0, 2}}}};
  f.json["extensionsRequired"] = {"KHR_node_visibility"};
  const Scene s = f.scene();
  std::size_t meshes = 0;
  for (const Node& node : s.nodes) meshes += node.mesh != kNone;
  EXPECT_EQ(meshes, 1u);
  EXPECT_TRUE(placedLights(s, 0).empty());
}

TEST(Casters, GlassIsBlended) {
  GltfFile f;
  f.triangle();
  f.json["materials"] = {
      {{"extensions",
        {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}, {"KHR_materials_ior", {{"ior", 1.4}}}}}},
      {{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0}}}}}}};
  f.json["extensionsRequired"] = {"KHR_materials_transmission", "KHR_materials_ior", "KHR_materials_volume"};
  const Scene s = f.scene();
  EXPECT_EQ(s.materials[0].alphaMode, AlphaMode::kBlend);
  EXPECT_LT(s.materials[0].baseColor.a, 0.2f);
  EXPECT_EQ(s.materials[1].alphaMode, AlphaMode::kOpaque);
}

TEST(ContentHash, KnowsEveryFileThatIsRead) {
  GltfFile f;
  f.triangle();
  const auto path = f.save();
  const auto hash = [&] {
    const auto loaded = loadGltf(path);
    EXPECT_TRUE(loaded.ok());
    return loaded.ok() ? loaded->contentHash : 0;
  };
  const std::uint64_t before = hash();
  EXPECT_EQ(hash(), before);
  std::string other = f.bytes;
  other[3] = '\x3e';
  f.folder.write("data.bin", other);
  EXPECT_NE(hash(), before) << "the level's own file is the same";
}

}  // namespace
}  // namespace tyndall::scene
