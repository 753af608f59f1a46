// What writeGlb writes, loadGltf reads back: every field, bit for bit where the format can hold it.
#include <cmath>
#include <functional>

#include "gltf_file.hpp"
#include "scene/write_glb.hpp"

namespace tyndall::scene {
namespace {

Primitive quad(std::int32_t material) {
  Primitive p;
  p.material = material;
  const glm::vec3 normal = glm::normalize(glm::vec3(0.1f, 0.2f, 1.0f));
  const glm::vec3 tangent = glm::normalize(glm::cross(glm::vec3(0, 1, 0), normal));
  for (int i = 0; i < 4; ++i) {
    const glm::vec2 c(i & 1, i >> 1);
    p.vertices.push_back(
        {glm::vec3(c.x * 1.7f, c.y * 0.3f, 0.123f), normal, glm::vec4(tangent, -1), c * 2.5f, glm::vec4(c, 0.25f, 1)});
    p.bounds.add(p.vertices.back().position);
  }
  p.indices = {0, 1, 2, 2, 1, 3};
  return p;
}

Scene everything() {
  Scene s;
  s.name = "all of it";
  s.images = {{"opaque", 2, 1, {255, 0, 0, 255, 0, 255, 0, 255}},
              {"clear", 1, 2, {1, 2, 3, 4, 250, 251, 252, 0}},
              {"strip", 6, 1, std::vector<std::uint8_t>(24, 77)}};
  s.textures = {
      {0, {Filter::kNearest, Filter::kNearest, Filter::kLinear, true, Wrap::kClampToEdge, Wrap::kMirroredRepeat}},
      {1, {Filter::kLinear, Filter::kLinear, Filter::kNearest, true, Wrap::kRepeat, Wrap::kRepeat}},
      {1, {Filter::kLinear, Filter::kNearest, Filter::kLinear, false, Wrap::kRepeat, Wrap::kRepeat}},
      {1, {Filter::kLinear, Filter::kLinear, Filter::kLinear, true, Wrap::kMirroredRepeat, Wrap::kClampToEdge}},
      {2, {}}};
  Material a;
  a.name = "bricks";
  a.baseColor = {0.1f, 0.2f, 0.3f, 0.4f};
  a.metallic = 0.25f;
  a.roughness = 0.75f;
  a.emissive = {8, 4, 2};
  a.normalScale = 0.5f;
  a.occlusionStrength = 0.6f;
  a.alphaCutoff = 0.3f;
  a.alphaMode = AlphaMode::kMask;
  a.doubleSided = true;
  a.baseColorTexture = {0, {0.1f, 0.2f}, {3, 4}, 0.5f};
  a.metallicRoughnessTexture = {1};
  a.normalTexture = {2};
  a.occlusionTexture = {1};
  a.emissiveTexture = {0};
  Material b;
  b.alphaMode = AlphaMode::kBlend;
  b.unlit = true;
  b.emissive = {0.5f, 0, 0};
  s.materials = {a, b};
  s.meshes = {{"quads", {quad(0), quad(1)}}};
  s.lights = {{"sun", LightKind::kDirectional, {1, 0.5f, 0.25f}, 3.5f, {}, 0, 0.7853982f},
              {"spot", LightKind::kSpot, {1, 1, 1}, 100, 12.5f, 0.2f, 0.4f},
              {"lamp", LightKind::kPoint, {0, 1, 0}, 60, {}, 0, 0.7853982f}};
  s.lights[0].cookie = Cookie{3, {4.5f, 2.25f}};
  s.lights[1].cookie = Cookie{1};
  s.lights[2].cookie = Cookie{4};
  s.cameras = {{"wide", 1.2f, 0.05f, 200.0f}, {"endless", 0.6f, 0.1f, {}}};
  const auto node = [&](const char* name, std::int32_t parent) -> Node& {
    Node n;
    n.name = name;
    n.parent = parent;
    n.order = static_cast<std::uint32_t>(s.nodes.size());
    s.nodes.push_back(n);
    return s.nodes.back();
  };
  node("root", kNone).translation = {1, 2, 3};
  node("mesh", 0).mesh = 0;
  s.nodes[1].rotation = glm::angleAxis(0.7f, glm::normalize(glm::vec3(1, 2, 3)));
  s.nodes[1].scale = {1, 2, 0.5f};
  node("again", 1).mesh = 0;
  s.nodes[2].matrix = glm::mat4(2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 5, 6, 7, 1);
  node("sun", 0).light = 0;
  node("spot", 0).light = 1;
  node("lamp", kNone).light = 2;
  node("wide", 0).camera = 0;
  node("endless", kNone).camera = 1;
  const std::vector<float> times = {0, 0.5f, 2};
  const glm::vec4 q1(0, 0, 0, 1), q2(0, std::sqrt(0.5f), 0, std::sqrt(0.5f));
  s.animations = {
      {"move",
       2,
       {{0, AnimationTarget::kTranslation, Interpolation::kLinear, times, {{0, 0, 0, 0}, {1, 0, 0, 0}, {1, 1, 0, 0}}},
        {1, AnimationTarget::kRotation, Interpolation::kStep, times, {q1, q2, q1}},
        {1,
         AnimationTarget::kScale,
         Interpolation::kCubicSpline,
         {0, 1},
         {{0, 0, 0, 0}, {1, 1, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {2, 2, 2, 0}, {0, 0, 0, 0}}}}}};
  return s;
}

void expectSame(const TextureUse& a, const TextureUse& b) {
  EXPECT_EQ(a.texture, b.texture);
  EXPECT_EQ(a.offset, b.offset);
  EXPECT_EQ(a.scale, b.scale);
  EXPECT_EQ(a.rotation, b.rotation);
}

void expectSame(const Material& a, const Material& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.baseColor, b.baseColor);
  EXPECT_EQ(a.metallic, b.metallic);
  EXPECT_EQ(a.roughness, b.roughness);
  EXPECT_EQ(a.emissive, b.emissive);
  EXPECT_EQ(a.normalScale, b.normalScale);
  EXPECT_EQ(a.occlusionStrength, b.occlusionStrength);
  EXPECT_EQ(a.alphaCutoff, b.alphaCutoff);
  EXPECT_EQ(a.alphaMode, b.alphaMode);
  EXPECT_EQ(a.doubleSided, b.doubleSided);
  EXPECT_EQ(a.unlit, b.unlit);
  expectSame(a.baseColorTexture, b.baseColorTexture);
  expectSame(a.metallicRoughnessTexture, b.metallicRoughnessTexture);
  expectSame(a.normalTexture, b.normalTexture);
  expectSame(a.occlusionTexture, b.occlusionTexture);
  expectSame(a.emissiveTexture, b.emissiveTexture);
}

void expectSame(const Primitive& a, const Primitive& b, bool withTangents) {
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  EXPECT_EQ(a.indices, b.indices);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.bounds.min, b.bounds.min);
  EXPECT_EQ(a.bounds.max, b.bounds.max);
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    EXPECT_EQ(a.vertices[i].position, b.vertices[i].position);
    EXPECT_LT(glm::distance(a.vertices[i].normal, b.vertices[i].normal), 1e-6f);
    if (withTangents) {
      EXPECT_LT(glm::distance(a.vertices[i].tangent, b.vertices[i].tangent), 1e-6f);
    }
    EXPECT_EQ(a.vertices[i].uv, b.vertices[i].uv);
    EXPECT_EQ(a.vertices[i].color, b.vertices[i].color);
  }
}

TEST(RoundTrip, KeepsEverything) {
  const Scene in = everything();
  TemporaryFolder folder;
  const auto path = folder / "all.glb";
  const auto written = writeGlb(in, path);
  ASSERT_TRUE(written.ok()) << written.error().message;
  auto loaded = loadGltf(path);
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_TRUE(loaded->warnings.empty()) << loaded->warnings[0];
  const Scene& out = loaded->scene;
  ASSERT_TRUE(checkScene(out).ok());

  EXPECT_EQ(out.name, in.name);
  ASSERT_EQ(out.nodes.size(), in.nodes.size());
  // The reader lists nodes depth first; find each by name.
  std::vector<std::size_t> at(in.nodes.size());
  for (std::size_t i = 0; i < in.nodes.size(); ++i)
    for (std::size_t j = 0; j < out.nodes.size(); ++j)
      if (out.nodes[j].order == i) at[i] = j;
  for (std::size_t i = 0; i < in.nodes.size(); ++i) {
    const Node &a = in.nodes[i], &b = out.nodes[at[i]];
    EXPECT_EQ(a.name, b.name);
    if (a.parent == kNone) {
      EXPECT_EQ(b.parent, kNone);
    } else {
      EXPECT_EQ(b.parent, static_cast<std::int32_t>(at[a.parent]));
    }
    EXPECT_EQ(a.matrix.has_value(), b.matrix.has_value());
    if (a.matrix) {
      EXPECT_EQ(*a.matrix, *b.matrix);
    }
    EXPECT_EQ(a.translation, b.translation);
    EXPECT_NEAR(std::abs(glm::dot(a.rotation, b.rotation)), 1, 1e-6);
    EXPECT_EQ(a.scale, b.scale);
    EXPECT_EQ(a.mesh, b.mesh);
    EXPECT_EQ(a.camera == kNone, b.camera == kNone);
    EXPECT_EQ(a.light == kNone, b.light == kNone);
    if (a.camera != kNone) {
      const Camera &x = in.cameras[a.camera], &y = out.cameras[b.camera];
      EXPECT_EQ(x.name, y.name);
      EXPECT_EQ(x.yfov, y.yfov);
      EXPECT_EQ(x.znear, y.znear);
      EXPECT_EQ(x.zfar, y.zfar);
    }
    if (a.light != kNone) {
      const Light &x = in.lights[a.light], &y = out.lights[b.light];
      EXPECT_EQ(x.name, y.name);
      EXPECT_EQ(x.kind, y.kind);
      EXPECT_EQ(x.color, y.color);
      EXPECT_EQ(x.intensity, y.intensity);
      EXPECT_EQ(x.range, y.range);
      EXPECT_EQ(x.innerConeAngle, y.innerConeAngle);
      EXPECT_EQ(x.outerConeAngle, y.outerConeAngle);
      ASSERT_EQ(x.cookie.has_value(), y.cookie.has_value());
      EXPECT_EQ(x.cookie->texture, y.cookie->texture);
      EXPECT_EQ(x.cookie->size, y.cookie->size);
    }
  }
  ASSERT_EQ(out.meshes.size(), 1u);
  ASSERT_EQ(out.meshes[0].primitives.size(), 2u);
  expectSame(in.meshes[0].primitives[0], out.meshes[0].primitives[0], true);
  expectSame(in.meshes[0].primitives[1], out.meshes[0].primitives[1], false);
  ASSERT_EQ(out.materials.size(), 2u);
  // The reader numbers textures by first use: base colour 0, metallic-roughness 1, normal 2, then lights, as here.
  for (int i = 0; i < 2; ++i) expectSame(in.materials[i], out.materials[i]);
  ASSERT_EQ(out.textures.size(), 5u);
  for (int i = 0; i < 5; ++i) {
    const Sampler &a = in.textures[i].sampler, &b = out.textures[i].sampler;
    EXPECT_EQ(in.textures[i].image, out.textures[i].image);
    EXPECT_EQ(a.magnify, b.magnify);
    EXPECT_EQ(a.minify, b.minify);
    EXPECT_EQ(a.useMipmaps, b.useMipmaps);
    if (a.useMipmaps) {
      EXPECT_EQ(a.mipmap, b.mipmap);
    }
    EXPECT_EQ(a.wrapU, b.wrapU);
    EXPECT_EQ(a.wrapV, b.wrapV);
  }
  ASSERT_EQ(out.images.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(in.images[i].name, out.images[i].name);
    EXPECT_EQ(in.images[i].width, out.images[i].width);
    EXPECT_EQ(in.images[i].height, out.images[i].height);
    EXPECT_EQ(in.images[i].rgba, out.images[i].rgba);
  }
  ASSERT_EQ(out.animations.size(), 1u);
  EXPECT_EQ(out.animations[0].duration, 2);
  ASSERT_EQ(out.animations[0].channels.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const AnimationChannel &a = in.animations[0].channels[i], &b = out.animations[0].channels[i];
    EXPECT_EQ(b.node, static_cast<std::int32_t>(at[a.node]));
    EXPECT_EQ(a.target, b.target);
    EXPECT_EQ(a.interpolation, b.interpolation);
    EXPECT_EQ(a.times, b.times);
    ASSERT_EQ(a.values.size(), b.values.size());
    for (std::size_t k = 0; k < a.values.size(); ++k) EXPECT_LT(glm::distance(a.values[k], b.values[k]), 1e-6f);
  }
}

TEST(RoundTrip, LargeMeshGets32BitIndices) {
  Scene s;
  Primitive p;
  constexpr int kSide = 300;  // 90,000 vertices, above what 16 bits number
  for (int i = 0; i < kSide * kSide; ++i) {
    p.vertices.push_back({glm::vec3(i % kSide, i / kSide, 0)});
    p.bounds.add(p.vertices.back().position);
  }
  for (std::uint32_t y = 0; y + 1 < kSide; ++y)
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      const std::uint32_t i = y * kSide + x;
      for (const std::uint32_t k : {i, i + 1, i + kSide, i + kSide, i + 1, i + kSide + 1}) p.indices.push_back(k);
    }
  s.meshes = {{"grid", {p}}};
  s.nodes.resize(1);
  s.nodes[0].mesh = 0;
  TemporaryFolder folder;
  ASSERT_TRUE(writeGlb(s, folder / "grid.glb").ok());
  const auto loaded = loadGltf(folder / "grid.glb");
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  ASSERT_EQ(loaded->scene.meshes[0].primitives.size(), 1u);
  EXPECT_EQ(loaded->scene.meshes[0].primitives[0].indices, p.indices);
}

TEST(RoundTrip, RefusesABrokenSceneAndLeavesNoFile) {
  Scene s;
  s.nodes.resize(1);
  s.nodes[0].mesh = 3;
  TemporaryFolder folder;
  const auto written = writeGlb(s, folder / "bad.glb");
  ASSERT_FALSE(written.ok());
  EXPECT_NE(written.error().message.find("nodes[0].mesh is 3"), std::string::npos) << written.error().message;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_FALSE(writeGlb(Scene{}, folder / "no such folder" / "a.glb").ok());
}

TEST(RoundTrip, RefusesBrokenCookies) {
  TemporaryFolder folder;
  const auto refused = [&](const char* reason, const std::function<void(Light&)>& change) {
    Scene s;
    s.images = {{"grid", 3, 2, std::vector<std::uint8_t>(24, 200)}};
    s.textures = {{0, {}}};
    s.lights.resize(1);
    s.lights[0].cookie = Cookie{0};
    s.nodes.resize(1);
    s.nodes[0].light = 0;
    ASSERT_TRUE(writeGlb(s, folder / "good.glb").ok());
    change(s.lights[0]);
    const auto written = writeGlb(s, folder / "bad.glb");
    ASSERT_FALSE(written.ok()) << reason;
    EXPECT_NE(written.error().message.find(reason), std::string::npos) << written.error().message;
  };
  refused("lights[0].cookie.texture is 1; there are 1 textures", [](Light& l) { l.cookie->texture = 1; });
  refused("lights[0].cookie.texture is -1", [](Light& l) { l.cookie->texture = kNone; });
  refused("lights[0].cookie.size", [](Light& l) { l.cookie->size = {0, 1}; });
  refused("lights[0].cookie.size", [](Light& l) { l.cookie->size = {1, NAN}; });
  refused("neither 2:1 nor 6:1", [](Light& l) { l.kind = LightKind::kPoint; });
}

}  // namespace
}  // namespace tyndall::scene
