#include "scene/write_glb.hpp"

#include <algorithm>
#include <set>

#include "base/file.hpp"
#include "glb_builder.hpp"
#include "png.hpp"
#include "scene/check.hpp"

namespace tyndall::scene {
namespace {

using Json = nlohmann::ordered_json;

template <int N>
Json list(const glm::vec<N, float>& v) {
  Json out = Json::array();
  for (int i = 0; i < N; ++i) out.push_back(v[i]);
  return out;
}
void name(Json& object, const std::string& text) {
  if (!text.empty()) object["name"] = text;
}
void addIfAny(Json& document, const char* key, Json array) {
  if (!array.empty()) document[key] = std::move(array);  // glTF forbids empty arrays
}

/// One .glb under construction.
struct Writer {
  const Scene& scene;
  GlbBuilder binary;
  std::set<std::string> extensions;
  std::vector<int>
      meshOfScene;  ///< index in the file of each mesh; kNone for one without triangles, which glTF forbids

  template <int N, class Member>
  int attribute(const Primitive& p, Member member, bool withBounds = false) {
    std::vector<glm::vec<N, float>> values;
    values.reserve(p.vertices.size());
    for (const Vertex& v : p.vertices) values.push_back(v.*member);
    return binary.vectors<N>(values, ViewTarget::kVertices, withBounds);
  }

  Json primitive(const Primitive& p) {
    Json attributes = {{"POSITION", attribute<3>(p, &Vertex::position, true)},
                       {"NORMAL", attribute<3>(p, &Vertex::normal)}};
    const bool normalMapped = p.material != kNone && scene.materials[p.material].normalTexture.used();
    bool hasUv = false, hasColor = false;
    for (const Vertex& v : p.vertices) {
      hasUv = hasUv || v.uv != glm::vec2(0);
      hasColor = hasColor || v.color != glm::vec4(1);
    }
    if (normalMapped) attributes["TANGENT"] = attribute<4>(p, &Vertex::tangent);  // elsewhere nobody reads them
    if (hasUv || normalMapped) attributes["TEXCOORD_0"] = attribute<2>(p, &Vertex::uv);
    if (hasColor) attributes["COLOR_0"] = attribute<4>(p, &Vertex::color);
    Json out = {{"attributes", std::move(attributes)}, {"indices", binary.indices(p.indices, p.vertices.size())}};
    if (p.material != kNone) out["material"] = p.material;
    return out;
  }

  Json meshes() {
    Json out = Json::array();
    for (const Mesh& mesh : scene.meshes) {
      Json primitives = Json::array();
      for (const Primitive& p : mesh.primitives)
        if (!p.indices.empty()) primitives.push_back(primitive(p));
      meshOfScene.push_back(primitives.empty() ? kNone : static_cast<int>(out.size()));
      if (primitives.empty()) continue;
      Json object = {{"primitives", std::move(primitives)}};
      name(object, mesh.name);
      out.push_back(std::move(object));
    }
    return out;
  }

  void texture(Json& parent, const char* key, const TextureUse& use, const char* factorKey = nullptr,
               float factor = 1) {
    if (!use.used()) return;
    Json object = {{"index", use.texture}};
    if (factorKey && factor != 1) object[factorKey] = factor;
    Json transform = Json::object();
    if (use.offset != glm::vec2(0)) transform["offset"] = list<2>(use.offset);
    if (use.rotation != 0) transform["rotation"] = use.rotation;
    if (use.scale != glm::vec2(1)) transform["scale"] = list<2>(use.scale);
    if (!transform.empty()) {
      object["extensions"]["KHR_texture_transform"] = std::move(transform);
      extensions.insert("KHR_texture_transform");
    }
    parent[key] = std::move(object);
  }

  Json material(const Material& m) {
    Json out = Json::object(), pbr = Json::object();
    name(out, m.name);
    if (m.baseColor != glm::vec4(1)) pbr["baseColorFactor"] = list<4>(m.baseColor);
    if (m.metallic != 1) pbr["metallicFactor"] = m.metallic;
    if (m.roughness != 1) pbr["roughnessFactor"] = m.roughness;
    texture(pbr, "baseColorTexture", m.baseColorTexture);
    texture(pbr, "metallicRoughnessTexture", m.metallicRoughnessTexture);
    if (!pbr.empty()) out["pbrMetallicRoughness"] = std::move(pbr);
    texture(out, "normalTexture", m.normalTexture, "scale", m.normalScale);
    texture(out, "occlusionTexture", m.occlusionTexture, "strength", m.occlusionStrength);
    texture(out, "emissiveTexture", m.emissiveTexture);
    // The factor itself stops at 1; what is above goes into the strength.
    const float brightest = std::max({m.emissive.x, m.emissive.y, m.emissive.z});
    if (brightest > 1) {
      out["emissiveFactor"] = list<3>(m.emissive / brightest);
      out["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", brightest}};
      extensions.insert("KHR_materials_emissive_strength");
    } else if (brightest > 0) {
      out["emissiveFactor"] = list<3>(m.emissive);
    }
    if (m.alphaMode == AlphaMode::kMask) {
      out["alphaMode"] = "MASK";
      if (m.alphaCutoff != 0.5f) out["alphaCutoff"] = m.alphaCutoff;
    }
    if (m.alphaMode == AlphaMode::kBlend) out["alphaMode"] = "BLEND";
    if (m.doubleSided) out["doubleSided"] = true;
    if (m.castsShadow == m.unlit) out["extras"]["tyndall"]["casts_shadow"] = m.castsShadow;
    if (m.unlit) {
      out["extensions"]["KHR_materials_unlit"] = Json::object();
      extensions.insert("KHR_materials_unlit");
    }
    return out;
  }

  static Json sampler(const Sampler& s) {
    // glTF 2.0 section 5.26: GL enumerants. Minification counts up: nearest, linear (no mipmaps),
    // then texel filter + 2 x mipmap filter.
    const auto wrap = [](Wrap w) { return w == Wrap::kRepeat ? 10497 : w == Wrap::kClampToEdge ? 33071 : 33648; };
    const int texel = s.minify == Filter::kLinear ? 1 : 0, mip = s.mipmap == Filter::kLinear ? 2 : 0;
    return {{"magFilter", s.magnify == Filter::kLinear ? 9729 : 9728},
            {"minFilter", s.useMipmaps ? 9984 + texel + mip : 9728 + texel},
            {"wrapS", wrap(s.wrapU)},
            {"wrapT", wrap(s.wrapV)}};
  }

  Json lights() {
    Json out = Json::array();
    for (const Light& light : scene.lights) {
      static constexpr const char* kTypes[] = {"directional", "spot", "point"};
      Json object = {{"type", kTypes[static_cast<int>(light.kind)]},
                     {"color", list<3>(light.color)},
                     {"intensity", light.intensity}};
      name(object, light.name);
      if (light.range && light.kind != LightKind::kDirectional) object["range"] = *light.range;
      if (light.kind == LightKind::kSpot)
        object["spot"] = {{"innerConeAngle", light.innerConeAngle}, {"outerConeAngle", light.outerConeAngle}};
      // The extension stops at 1 for colours, as for emission above.
      const float brightest = std::max({light.color.x, light.color.y, light.color.z});
      if (brightest > 1) {
        object["color"] = list<3>(light.color / brightest);
        object["intensity"] = light.intensity * brightest;
      }
      if (light.cookie) {
        Json cookie = {{"index", light.cookie->texture}};
        if (light.kind == LightKind::kDirectional) cookie["size"] = list<2>(light.cookie->size);
        object["extras"]["cookie"] = std::move(cookie);
      }
      out.push_back(std::move(object));
    }
    return out;
  }

  Json node(const Node& n) {
    Json out = Json::object();
    name(out, n.name);
    if (n.matrix) {
      Json matrix = Json::array();
      for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) matrix.push_back((*n.matrix)[column][row]);
      out["matrix"] = std::move(matrix);
    } else {
      const glm::quat& q = n.rotation;
      if (n.translation != glm::vec3(0)) out["translation"] = list<3>(n.translation);
      if (q != glm::quat(1, 0, 0, 0)) out["rotation"] = {q.x, q.y, q.z, q.w};
      if (n.scale != glm::vec3(1)) out["scale"] = list<3>(n.scale);
    }
    const bool parentCasts = n.parent == kNone || scene.nodes[n.parent].castsShadow;
    if (n.castsShadow != parentCasts) out["extras"]["tyndall"]["casts_shadow"] = n.castsShadow;
    if (n.mesh != kNone && meshOfScene[n.mesh] != kNone) out["mesh"] = meshOfScene[n.mesh];
    if (n.camera != kNone) out["camera"] = n.camera;
    if (n.light != kNone) out["extensions"]["KHR_lights_punctual"] = {{"light", n.light}};
    return out;
  }

  Json animation(const Animation& a) {
    static constexpr const char* kPaths[] = {"translation", "rotation", "scale"};
    static constexpr const char* kInterpolations[] = {"STEP", "LINEAR", "CUBICSPLINE"};
    Json samplers = Json::array(), channels = Json::array();
    for (const AnimationChannel& channel : a.channels) {
      int output = 0;
      if (channel.target == AnimationTarget::kRotation) {
        output = binary.vectors<4>(std::span<const glm::vec4>(channel.values), ViewTarget::kUnspecified, false);
      } else {
        const std::vector<glm::vec3> values(channel.values.begin(), channel.values.end());
        output = binary.vectors<3>(std::span<const glm::vec3>(values), ViewTarget::kUnspecified, false);
      }
      channels.push_back({{"sampler", samplers.size()},
                          {"target", {{"node", channel.node}, {"path", kPaths[static_cast<int>(channel.target)]}}}});
      samplers.push_back({{"input", binary.scalars(channel.times, ViewTarget::kUnspecified, true)},
                          {"output", output},
                          {"interpolation", kInterpolations[static_cast<int>(channel.interpolation)]}});
    }
    Json out = {{"samplers", std::move(samplers)}, {"channels", std::move(channels)}};
    name(out, a.name);
    return out;
  }

  Result<std::vector<std::byte>> write();
};

Result<std::vector<std::byte>> Writer::write() {
  Json document = {{"asset", {{"version", "2.0"}, {"generator", "Tyndall"}}}};
  Json nodes = Json::array(), roots = Json::array(), materials = Json::array(), textures = Json::array(),
       samplers = Json::array(), images = Json::array(), cameras = Json::array(), animations = Json::array();
  addIfAny(document, "meshes", meshes());
  for (const Material& m : scene.materials) materials.push_back(material(m));
  for (const Texture& t : scene.textures) {
    textures.push_back({{"sampler", samplers.size()}, {"source", t.image}});
    samplers.push_back(sampler(t.sampler));
  }
  for (const Image& image : scene.images) {
    auto png = encodePng(image);
    if (!png) return png.error();
    Json object = {{"bufferView", binary.view(*png, ViewTarget::kUnspecified)}, {"mimeType", "image/png"}};
    name(object, image.name);
    images.push_back(std::move(object));
  }
  for (const Camera& c : scene.cameras) {
    Json perspective = {{"yfov", c.yfov}, {"znear", c.znear}};
    if (c.zfar) perspective["zfar"] = *c.zfar;
    Json object = {{"type", "perspective"}, {"perspective", std::move(perspective)}};
    name(object, c.name);
    cameras.push_back(std::move(object));
  }
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    nodes.push_back(node(scene.nodes[i]));
    const std::int32_t parent = scene.nodes[i].parent;
    (parent == kNone ? roots : nodes[parent]["children"]).push_back(i);
  }
  for (const Animation& a : scene.animations)
    if (!a.channels.empty()) animations.push_back(animation(a));
  Json root = Json::object();
  name(root, scene.name);
  addIfAny(root, "nodes", std::move(roots));
  if (scene.exposure) root["extras"]["tyndall"]["exposure"] = *scene.exposure;
  document["scene"] = 0;
  document["scenes"] = Json::array({std::move(root)});
  addIfAny(document, "nodes", std::move(nodes));
  addIfAny(document, "materials", std::move(materials));
  addIfAny(document, "textures", std::move(textures));
  addIfAny(document, "samplers", std::move(samplers));
  addIfAny(document, "images", std::move(images));
  addIfAny(document, "cameras", std::move(cameras));
  addIfAny(document, "animations", std::move(animations));
  if (!scene.lights.empty()) {
    document["extensions"]["KHR_lights_punctual"]["lights"] = lights();
    extensions.insert("KHR_lights_punctual");
  }
  if (!extensions.empty()) document["extensionsUsed"] = extensions;
  auto file = binary.finish(std::move(document));
  if (file.empty()) return failed("the level exceeds the 4 GiB that a .glb file can hold");
  return file;
}

}  // namespace

Result<void> writeGlb(const Scene& scene, const std::filesystem::path& path) {
  const auto prefixed = [&](const Error& error) {
    return failed(path.string() + ": cannot be written: " + error.message);
  };
  if (auto sound = checkScene(scene, false); !sound) return prefixed(sound.error());
  Writer writer{scene, {}, {}, {}};
  auto file = writer.write();
  if (!file) return prefixed(file.error());
  return writeFileAtomically(path, *file);
}

}  // namespace tyndall::scene
