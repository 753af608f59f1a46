// The only file that sees tinygltf: its model becomes a document::Document. tinygltf reads buffers and images through
// our callbacks and has never a path to open.
#include <tiny_gltf.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "image_decode.hpp"
#include "parse_gltf.hpp"
#include "scene/limits.hpp"

namespace tyndall::scene {
namespace {

using tinygltf::Value;

/// What the callbacks work on. They are called from within a library and throw nothing.
struct Supply {
  Prepared prepared;
  std::vector<Image> images;
  std::uint64_t pixelsLeft = kMaxTotalPixels;
  Warnings& warnings;
};

/// The bytes behind "./buffer/N" or "./image/N" (the base folder is "."), or null.
std::vector<std::byte>* find(Supply& supply, const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string_view number = std::string_view(path).substr(slash + 1);
  std::size_t index = 0;
  if (slash == std::string::npos || std::from_chars(number.begin(), number.end(), index).ptr != number.end())
    return nullptr;
  auto& list = path.find("image/") != std::string::npos ? supply.prepared.images : supply.prepared.buffers;
  return index < list.size() ? &list[index] : nullptr;
}

bool fileExists(const std::string& path, void* user) { return find(*static_cast<Supply*>(user), path) != nullptr; }
std::string samePath(const std::string& path, void*) { return path; }
bool readFile(std::vector<unsigned char>* out, std::string*, const std::string& path, void* user) {
  std::vector<std::byte>* bytes = find(*static_cast<Supply*>(user), path);
  if (!bytes) return false;
  const auto* begin = reinterpret_cast<const unsigned char*>(bytes->data());
  out->assign(begin, begin + bytes->size());
  if (out->empty()) out->push_back(0);  // absent buffers and images that nobody shows: tinygltf wants a byte
  *bytes = {};
  return true;
}
bool writeFile(std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }

bool decode(tinygltf::Image* image, const int index, std::string*, std::string*, int, int, const unsigned char* bytes,
            int size, void* user) {
  auto& supply = *static_cast<Supply*>(user);
  supply.images.resize(std::max<std::size_t>(supply.images.size(), index + 1));
  if (size <= 1) return true;  // not shown
  auto decoded = decodeImage(std::as_bytes(std::span(bytes, static_cast<std::size_t>(size))),
                             std::min(kMaxImagePixels, supply.pixelsLeft));
  if (!decoded) {
    supply.warnings.count(kImageKind, supply.prepared.imageNames[index] + " " + decoded.error().message,
                          kImageConsequence);
    return true;
  }
  supply.pixelsLeft -= std::uint64_t{decoded->width} * decoded->height;
  decoded->name = image->name;
  supply.images[index] = decoded.take();
  return true;
}

template <int N>
glm::vec<N, float> vec(const std::vector<double>& values, glm::vec<N, float> fallback) {
  if (values.size() == N)
    for (int i = 0; i < N; ++i) fallback[i] = static_cast<float>(values[i]);
  return fallback;
}

// The three below read the extensions that tinygltf keeps as untyped values; the schema has checked their types.
const Value* extension(const tinygltf::ExtensionMap& map, const char* name) {
  const auto found = map.find(name);
  return found == map.end() ? nullptr : &found->second;
}
double number(const Value& object, const char* key, double fallback) {
  return object.Has(key) ? object.Get(key).GetNumberAsDouble() : fallback;
}
std::vector<double> numbers(const Value& object, const char* key) {
  std::vector<double> out;
  if (object.Has(key))
    for (std::size_t i = 0; i < object.Get(key).ArrayLen(); ++i)
      out.push_back(object.Get(key).Get(static_cast<int>(i)).GetNumberAsDouble());
  return out;
}

void transform(const Value* t, TextureUse& use, int& uvSet) {
  if (!t || !t->IsObject()) return;
  use.offset = vec<2>(numbers(*t, "offset"), use.offset);
  use.scale = vec<2>(numbers(*t, "scale"), use.scale);
  use.rotation = static_cast<float>(number(*t, "rotation", 0));
  uvSet = static_cast<int>(number(*t, "texCoord", uvSet));
}

template <class Info>
void texture(const Info& info, TextureUse& use, int& uvSet) {
  use.texture = info.index;
  uvSet = info.texCoord;
  transform(extension(info.extensions, "KHR_texture_transform"), use, uvSet);
}

/// KHR_materials_pbrSpecularGlossiness, an archived extension: its diffuse part is kept, reflections become those of a
/// dielectric of the same smoothness.
void specularGlossiness(const Value& s, document::Material& out) {
  Material& m = out.material;
  out.specularGlossiness = true;
  m.baseColor = vec<4>(numbers(s, "diffuseFactor"), glm::vec4(1));
  m.metallic = 0;
  m.roughness = 1 - static_cast<float>(number(s, "glossinessFactor", 1));
  m.metallicRoughnessTexture = {};
  m.baseColorTexture = {};
  if (!s.Has("diffuseTexture")) return;
  const Value& info = s.Get("diffuseTexture");
  int& uvSet = out.uvSets[document::kBaseColorSlot];
  m.baseColorTexture.texture = static_cast<int>(number(info, "index", kNone));
  uvSet = static_cast<int>(number(info, "texCoord", 0));
  if (info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform"))
    transform(&info.Get("extensions").Get("KHR_texture_transform"), m.baseColorTexture, uvSet);
}

/// "casts_shadow" of our extras of a node or a material; nothing where it is absent or no boolean, which is told.
std::optional<bool> castsShadow(const Value& extras, Warnings& warnings) {
  if (!extras.IsObject() || !extras.Has("tyndall") || !extras.Get("tyndall").IsObject()) return {};
  const Value& ours = extras.Get("tyndall");
  if (!ours.Has("casts_shadow")) return {};
  if (ours.Get("casts_shadow").IsBool()) return ours.Get("casts_shadow").Get<bool>();
  warnings.add("extras: tyndall.casts_shadow that is neither true nor false is passed over");
  return {};
}

/// KHR_materials_transmission: drawn as a blended surface, of which a tenth stays where all light is let through; so it
/// shadows nothing.
void transmission(const Value& t, Material& m, Warnings& warnings) {
  constexpr float kLeast = 0.1f;
  const auto factor = static_cast<float>(number(t, "transmissionFactor", 0));
  if (factor <= 0) return;
  if (t.Has("transmissionTexture")) warnings.add("transmission textures are not read; the factor holds everywhere");
  m.alphaMode = AlphaMode::kBlend;
  m.baseColor.a *= 1 - (1 - kLeast) * factor;
}

document::Material material(const tinygltf::Material& in, Warnings& warnings) {
  document::Material out;
  Material& m = out.material;
  const auto& pbr = in.pbrMetallicRoughness;
  m.name = in.name;
  m.baseColor = vec<4>(pbr.baseColorFactor, glm::vec4(1));
  m.metallic = static_cast<float>(pbr.metallicFactor);
  m.roughness = static_cast<float>(pbr.roughnessFactor);
  m.emissive = vec<3>(in.emissiveFactor, glm::vec3(0));
  m.normalScale = static_cast<float>(in.normalTexture.scale);
  m.occlusionStrength = static_cast<float>(in.occlusionTexture.strength);
  m.alphaCutoff = static_cast<float>(in.alphaCutoff);
  m.alphaMode = in.alphaMode == "MASK"    ? AlphaMode::kMask
                : in.alphaMode == "BLEND" ? AlphaMode::kBlend
                                          : AlphaMode::kOpaque;
  m.doubleSided = in.doubleSided;
  texture(pbr.baseColorTexture, m.baseColorTexture, out.uvSets[document::kBaseColorSlot]);
  texture(pbr.metallicRoughnessTexture, m.metallicRoughnessTexture, out.uvSets[document::kMetallicRoughnessSlot]);
  texture(in.normalTexture, m.normalTexture, out.uvSets[document::kNormalSlot]);
  texture(in.occlusionTexture, m.occlusionTexture, out.uvSets[document::kOcclusionSlot]);
  texture(in.emissiveTexture, m.emissiveTexture, out.uvSets[document::kEmissiveSlot]);
  m.unlit = extension(in.extensions, "KHR_materials_unlit") != nullptr;
  m.castsShadow = castsShadow(in.extras, warnings).value_or(!m.unlit);
  if (const Value* t = extension(in.extensions, "KHR_materials_transmission")) transmission(*t, m, warnings);
  if (const Value* e = extension(in.extensions, "KHR_materials_emissive_strength"))
    m.emissive *= static_cast<float>(number(*e, "emissiveStrength", 1));
  if (const Value* s = extension(in.extensions, "KHR_materials_pbrSpecularGlossiness")) specularGlossiness(*s, out);
  return out;
}

Sampler sampler(const tinygltf::Sampler& in) {
  const auto wrap = [](int gl) {
    return gl == 33071 ? Wrap::kClampToEdge : gl == 33648 ? Wrap::kMirroredRepeat : Wrap::kRepeat;
  };
  Sampler out;
  out.wrapU = wrap(in.wrapS);
  out.wrapV = wrap(in.wrapT);
  out.magnify = in.magFilter == 9728 ? Filter::kNearest : Filter::kLinear;
  // Nearest, linear without mipmaps; then nearest/linear texels of the nearest level, and of two levels.
  out.useMipmaps = in.minFilter != 9728 && in.minFilter != 9729;
  out.minify =
      in.minFilter == 9728 || in.minFilter == 9984 || in.minFilter == 9986 ? Filter::kNearest : Filter::kLinear;
  out.mipmap = in.minFilter == 9984 || in.minFilter == 9985 ? Filter::kNearest : Filter::kLinear;
  return out;
}

document::Accessor accessor(const tinygltf::Accessor& in) {
  document::Accessor out;
  out.view = in.bufferView;
  out.byteOffset = in.byteOffset;
  out.componentType = in.componentType;
  out.width = in.type == TINYGLTF_TYPE_SCALAR                                  ? 1
              : in.type >= TINYGLTF_TYPE_VEC2 && in.type <= TINYGLTF_TYPE_VEC4 ? in.type
                                                                               : 0;
  out.count = in.count;
  out.normalized = in.normalized;
  if (in.sparse.isSparse) {
    const auto& s = in.sparse;
    out.sparse = {static_cast<std::size_t>(s.count),
                  s.indices.bufferView,
                  s.values.bufferView,
                  static_cast<std::size_t>(s.indices.byteOffset),
                  static_cast<std::size_t>(s.values.byteOffset),
                  s.indices.componentType};
  }
  return out;
}

document::Mesh mesh(const tinygltf::Mesh& in) {
  document::Mesh out{in.name, {}};
  for (const auto& p : in.primitives)
    out.primitives.push_back({p.attributes, p.indices, p.material, p.mode, !p.targets.empty()});
  return out;
}

document::Node node(const tinygltf::Node& in, Warnings& warnings) {
  document::Node out;
  Node& n = out.node;
  n.name = in.name;
  n.mesh = in.mesh;
  n.camera = in.camera;
  if (const Value* light = extension(in.extensions, "KHR_lights_punctual"))
    n.light = static_cast<int>(number(*light, "light", kNone));
  if (const Value* v = extension(in.extensions, "KHR_node_visibility"))
    out.visible = !v->Has("visible") || v->Get("visible").Get<bool>();
  out.castsShadow = castsShadow(in.extras, warnings);
  n.translation = vec<3>(in.translation, glm::vec3(0));
  n.scale = vec<3>(in.scale, glm::vec3(1));
  const glm::vec4 q = vec<4>(in.rotation, glm::vec4(0, 0, 0, 1));
  n.rotation = glm::quat(q.w, q.x, q.y, q.z);
  if (in.matrix.size() == 16) {
    n.matrix.emplace();
    for (int i = 0; i < 16; ++i) (*n.matrix)[i / 4][i % 4] = static_cast<float>(in.matrix[i]);
  }
  out.children = in.children;
  out.skinned = in.skin >= 0;
  return out;
}

std::optional<Camera> camera(const tinygltf::Camera& in) {
  if (in.type != "perspective") return {};
  Camera out{in.name, static_cast<float>(in.perspective.yfov), static_cast<float>(in.perspective.znear), {}};
  if (in.perspective.zfar > 0) out.zfar = static_cast<float>(in.perspective.zfar);
  // Two planes that only a double tells apart stay two.
  if (in.perspective.zfar > in.perspective.znear && *out.zfar <= out.znear)
    out.zfar = std::nextafter(out.znear, std::numeric_limits<float>::max());
  return out;
}

Light light(const tinygltf::Light& in) {
  Light out;
  out.name = in.name;
  out.kind = in.type == "spot" ? LightKind::kSpot : in.type == "point" ? LightKind::kPoint : LightKind::kDirectional;
  out.color = vec<3>(in.color, glm::vec3(1));
  out.intensity = static_cast<float>(in.intensity);
  if (in.range > 0) out.range = static_cast<float>(in.range);
  out.innerConeAngle = static_cast<float>(in.spot.innerConeAngle);
  out.outerConeAngle = static_cast<float>(in.spot.outerConeAngle);
  if (in.extras.IsObject() && in.extras.Has("cookie")) {
    const Value& cookie = in.extras.Get("cookie");
    out.cookie.emplace();
    out.cookie->texture = static_cast<std::int32_t>(number(cookie, "index", kNone));
    out.cookie->size = vec<2>(numbers(cookie, "size"), out.cookie->size);
  }
  return out;
}

document::Animation animation(const tinygltf::Animation& in) {
  document::Animation out{in.name, {}, {}};
  for (const auto& s : in.samplers)
    out.samplers.push_back({s.input, s.output,
                            s.interpolation == "STEP"          ? Interpolation::kStep
                            : s.interpolation == "CUBICSPLINE" ? Interpolation::kCubicSpline
                                                               : Interpolation::kLinear});
  for (const auto& c : in.channels) out.channels.push_back({c.sampler, c.target_node, c.target_path});
  return out;
}

/// The level's exposure in the extras of its scene, of the document or of its asset, the first that has one.
std::optional<float> exposureHint(const tinygltf::Model& model, Warnings& warnings) {
  std::vector<const Value*> places = {&model.extras, &model.asset.extras};
  const int shown = std::max(model.defaultScene, 0);
  if (static_cast<std::size_t>(shown) < model.scenes.size()) places.insert(places.begin(), &model.scenes[shown].extras);
  for (const Value* extras : places) {
    if (!extras->IsObject() || !extras->Has("tyndall") || !extras->Get("tyndall").IsObject()) continue;
    const Value& ours = extras->Get("tyndall");
    if (!ours.Has("exposure")) continue;
    const Value& hint = ours.Get("exposure");
    const double factor = hint.IsNumber() ? hint.GetNumberAsDouble() : 0;
    if (factor >= kMinExposure && factor <= kMaxExposure) return static_cast<float>(factor);
    warnings.add("extras: tyndall.exposure is passed over; a number from 1e-12 to 1e12 is right");
  }
  return {};
}

template <class Out, class In, class Convert>
void convert(std::vector<Out>& out, const std::vector<In>& in, Convert&& one) {
  out.reserve(in.size());
  for (const In& element : in) out.push_back(one(element));
}

}  // namespace

document::Document parseGltf(Prepared prepared, Warnings& warnings) {
  Supply supply{std::move(prepared), {}, kMaxTotalPixels, warnings};
  tinygltf::TinyGLTF parser;
  parser.SetFsCallbacks({fileExists, samePath, readFile, writeFile, &supply});
  parser.SetImageLoader(decode, &supply);
  tinygltf::Model model;
  std::string error, warning;
  const std::string& json = supply.prepared.json;
  const bool parsed =
      parser.LoadASCIIFromString(&model, &error, &warning, json.data(), static_cast<unsigned>(json.size()), ".");
  if (!parsed) refuse("tinygltf: " + oneLine(error.empty() ? "refused without a reason" : error));
  if (!warning.empty()) warnings.add("tinygltf: " + oneLine(warning));

  document::Document out;
  out.exposure = exposureHint(model, warnings);
  for (tinygltf::Buffer& buffer : model.buffers) out.buffers.push_back(std::move(buffer.data));
  convert(out.views, model.bufferViews, [](const auto& v) {
    return document::BufferView{v.buffer, v.byteOffset, v.byteLength, v.byteStride};
  });
  convert(out.accessors, model.accessors, accessor);
  convert(out.meshes, model.meshes, mesh);
  convert(out.materials, model.materials, [&](const auto& m) { return material(m, warnings); });
  convert(out.textures, model.textures, [&](const auto& t) {
    return document::Texture{t.source, t.sampler >= 0 ? sampler(model.samplers[t.sampler]) : Sampler{}};
  });
  out.images = std::move(supply.images);
  out.images.resize(model.images.size());
  convert(out.nodes, model.nodes, [&](const auto& n) { return node(n, warnings); });
  convert(out.scenes, model.scenes, [](const auto& s) { return document::SceneRoots{s.name, s.nodes}; });
  out.defaultScene = model.defaultScene;
  convert(out.cameras, model.cameras, camera);
  convert(out.lights, model.lights, light);
  convert(out.animations, model.animations, animation);
  return out;
}

}  // namespace tyndall::scene
