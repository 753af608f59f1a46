#include "prepare.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "resources.hpp"
#include "scene/limits.hpp"
#include "schema.hpp"

namespace tyndall::scene {
namespace {

constexpr std::string_view kSupported[] = {"KHR_lights_punctual",        "KHR_materials_emissive_strength",
                                           "KHR_materials_transmission", "KHR_materials_pbrSpecularGlossiness",
                                           "KHR_materials_unlit",        "KHR_mesh_quantization",
                                           "KHR_node_visibility",        "KHR_texture_transform"};

/// Extensions without which a level is still itself (looks of surfaces, variants, pointers of animations, metadata): a
/// file that requires one is shown without it.
constexpr std::string_view kHarmless[] = {"KHR_materials_anisotropy",
                                          "KHR_materials_clearcoat",
                                          "KHR_materials_diffuse_transmission",
                                          "KHR_materials_dispersion",
                                          "KHR_materials_ior",
                                          "KHR_materials_iridescence",
                                          "KHR_materials_sheen",
                                          "KHR_materials_specular",
                                          "KHR_materials_variants",
                                          "KHR_materials_volume",
                                          "KHR_node_selectability",
                                          "KHR_node_hoverability",
                                          "KHR_xmp_json_ld",
                                          "EXT_lights_image_based",
                                          "KHR_animation_pointer",
                                          "KHR_materials_volume_scatter"};

bool harmless(const std::string& extension) {
  return std::find(std::begin(kHarmless), std::end(kHarmless), extension) != std::end(kHarmless);
}

bool supported(const std::string& extension) {
  return std::find(std::begin(kSupported), std::end(kSupported), extension) != std::end(kSupported);
}

Json parse(std::string_view text) {
  checkJsonShape(text);
  try {
    return Json::parse(text);
  } catch (const Json::exception& error) {
    std::string_view what = error.what();
    if (const std::size_t end = what.find("] "); what.starts_with("[json") && end != std::string_view::npos)
      what.remove_prefix(end + 2);
    refuse("its JSON is broken: " + oneLine(what));
  }
}

/// "major.minor" of a version property.
std::pair<int, int> version(const std::string& text, const char* what) {
  std::pair<int, int> v{0, 0};
  const char* end = text.data() + text.size();
  const auto major = std::from_chars(text.data(), end, v.first);
  const bool dotted = major.ec == std::errc{} && major.ptr != end && *major.ptr == '.';
  const auto minor = dotted ? std::from_chars(major.ptr + 1, end, v.second) : major;
  if (!dotted || minor.ec != std::errc{} || minor.ptr != end)
    refuse(std::string(what) + " is " + inQuotes(text) + "; glTF 2.0 is read");
  return v;
}

void checkVersion(const Json& document) {
  const Json& asset = document["asset"];
  if (asset.contains("minVersion") &&
      version(asset["minVersion"].get<std::string>(), "asset.minVersion") > std::pair{2, 0})
    refuse("asset.minVersion is " + inQuotes(asset["minVersion"].get<std::string>()) + "; glTF 2.0 is read");
  if (version(asset["version"].get<std::string>(), "asset.version").first != 2)
    refuse("asset.version is " + inQuotes(asset["version"].get<std::string>()) + "; glTF 2.0 is read");
}

void checkExtensions(const Json& document, Warnings& warnings) {
  for (const Json& name : document.value("extensionsRequired", Json::array()))
    if (!supported(name.get<std::string>()) && !harmless(name.get<std::string>()))
      refuse("requires the extension " + inQuotes(name.get<std::string>()) + ", which is not supported");
  std::string ignored;
  for (const Json& name : document.value("extensionsUsed", Json::array()))
    if (!supported(name.get<std::string>()))
      ignored += (ignored.empty() ? "" : ", ") + oneLine(name.get<std::string>());
  if (!ignored.empty()) warnings.add("extensions without effect here: " + oneLine(ignored));
}

/// A view that does not fit its buffer becomes empty: whatever uses it is then told to need more than it has.
void checkViews(Json& document, Warnings& warnings) {
  if (!document.contains("bufferViews")) return;
  Json& views = document["bufferViews"];
  if (!views.empty() && document.value("buffers", Json::array()).empty())
    document["buffers"] = Json::array({{{"byteLength", 0}}});  // stand-ins of views point to the first
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::uint64_t end =
        views[i].value("byteOffset", std::uint64_t{0}) + views[i]["byteLength"].get<std::uint64_t>();
    const std::size_t buffer = views[i]["buffer"].get<std::size_t>();
    const std::uint64_t size = document["buffers"][buffer]["byteLength"].get<std::uint64_t>();
    std::string wrong;
    if (const int stride = views[i].value("byteStride", 0); stride % 4)
      wrong = ".byteStride is " + std::to_string(stride) + "; it must be a multiple of 4";
    else if (end > size)
      wrong =
          " ends at byte " + std::to_string(end) + "; " + element("buffers", buffer) + " has " + std::to_string(size);
    if (wrong.empty()) continue;
    warnings.count("broken bufferViews", element("bufferViews", i) + wrong, kEachLeftOut);
    views[i] = {{"buffer", buffer}, {"byteLength", 0}};
  }
}

/// Stand-ins of broken lights: no node shines with them any more.
void dropBrokenLights(Json& document) {
  const Json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
  if (!document.contains(lights)) return;
  std::set<std::size_t> broken;
  for (std::size_t i = 0; i < document[lights].size(); ++i) {
    Json& light = document[lights][i];
    if (light["type"] != "broken") continue;
    broken.insert(i);
    light["type"] = "point";
  }
  for (std::size_t i = 0; !broken.empty() && document.contains("nodes") && i < document["nodes"].size(); ++i) {
    const Json::json_pointer own("/extensions/KHR_lights_punctual/light");
    Json& node = document["nodes"][i];
    if (node.contains(own) && broken.contains(node[own].get<std::size_t>()))
      node["extensions"].erase("KHR_lights_punctual");
  }
}

/// Perspective cameras that lack what they need: nodes no longer show them.
void dropBrokenCameras(Json& document, Warnings& warnings) {
  if (!document.contains("cameras")) return;
  std::set<std::size_t> broken;
  for (std::size_t i = 0; i < document["cameras"].size(); ++i) {
    Json& camera = document["cameras"][i];
    if (camera["type"] == "perspective" && !camera.contains("perspective"))
      warnings.count("broken cameras", element("cameras", i) + ".perspective is missing", kEachLeftOut);
    if (camera["type"] == "broken" || (camera["type"] == "perspective" && !camera.contains("perspective"))) {
      broken.insert(i);
      camera["type"] = "orthographic";
    }
    if (camera["type"] == "orthographic")
      camera["orthographic"] = {{"xmag", 1.0}, {"ymag", 1.0}, {"znear", 0.1}, {"zfar", 1.0}};
  }
  for (std::size_t i = 0; !broken.empty() && document.contains("nodes") && i < document["nodes"].size(); ++i) {
    Json& node = document["nodes"][i];
    if (node.contains("camera") && broken.contains(node["camera"].get<std::size_t>())) node.erase("camera");
  }
}

/// Accessors without elements: legal where nobody reads them. Attributes and parts of meshes that do are left out.
void dropEmptyAccessors(Json& document, Warnings& warnings) {
  if (!document.contains("accessors")) return;
  Json& accessors = document["accessors"];
  std::set<std::size_t> empty;
  for (std::size_t i = 0; i < accessors.size(); ++i) {
    if (accessors[i]["count"] != 0) continue;
    empty.insert(i);
    accessors[i] = {{"componentType", 5126}, {"count", 1}, {"type", "SCALAR"}};  // tinygltf wants an element
  }
  if (empty.empty() || !document.contains("meshes")) return;
  for (std::size_t m = 0; m < document["meshes"].size(); ++m) {
    Json& mesh = document["meshes"][m];
    if (!mesh.contains("primitives")) continue;
    Json kept = Json::array();
    for (Json& primitive : mesh["primitives"]) {
      Json attributes = Json::object();
      for (const auto& [semantic, index] : primitive["attributes"].items())
        if (!empty.contains(index.get<std::size_t>())) attributes[semantic] = index;
      const bool usable = attributes.contains("POSITION") == primitive["attributes"].contains("POSITION") &&
                          !(primitive.contains("indices") && empty.contains(primitive["indices"].get<std::size_t>()));
      if (usable && attributes.size() != primitive["attributes"].size())
        warnings.count("attributes without elements", element("meshes", m) + " has an attribute without elements",
                       kEachLeftOut);
      primitive["attributes"] = std::move(attributes);
      if (usable)
        kept.push_back(std::move(primitive));
      else
        warnings.count("parts of meshes without elements", element("meshes", m) + " has a part without elements",
                       kEachLeftOut);
    }
    mesh["primitives"] = std::move(kept);
  }
}

/// What tinygltf insists on or looks at without care.
void adapt(Json& document, Warnings& warnings) {
  dropBrokenLights(document);
  dropBrokenCameras(document, warnings);
  dropEmptyAccessors(document, warnings);
  const Json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
  if (document.contains(lights)) {
    for (Json& light : document[lights]) {
      if (light["type"] != "spot" || light.contains("spot")) continue;
      warnings.add("a spot light has no \"spot\" object; it gets the default cone");
      light["spot"] = Json::object();
    }
  }
  for (std::size_t a = 0; document.contains("animations") && a < document["animations"].size(); ++a) {
    Json& animation = document["animations"][a];
    if (!animation.contains("channels") || !animation.contains("samplers")) {
      warnings.add(element("animations", a) + " has no channels or no samplers and was left out");
      animation = Json::object();
      continue;
    }
    Json kept = Json::array();
    for (Json& channel : animation["channels"]) {
      if (channel["sampler"].get<std::size_t>() >= animation["samplers"].size())
        warnings.count("broken channels",
                       element("animations", a) + " has a channel with sampler " + channel["sampler"].dump() +
                           "; there are " + std::to_string(animation["samplers"].size()),
                       kEachLeftOut);
      else if (channel["target"].contains("node"))
        kept.push_back(std::move(channel));
      else
        warnings.add(element("animations", a) + " has channels without a node; they were left out");
    }
    animation["channels"] = std::move(kept);
  }
  for (std::size_t m = 0; document.contains("meshes") && m < document["meshes"].size(); ++m) {
    if (!document["meshes"][m].contains("primitives")) document["meshes"][m]["primitives"] = Json::array();
    Json kept = Json::array();
    for (Json& primitive : document["meshes"][m]["primitives"]) {
      const bool unusable = primitive.contains("indices") &&
                            !document["accessors"][primitive["indices"].get<std::size_t>()].contains("bufferView");
      if (unusable)
        warnings.add(element("meshes", m) + " has indices without a buffer view; that part was left out");
      else
        kept.push_back(std::move(primitive));
    }
    document["meshes"][m]["primitives"] = std::move(kept);
  }
}

/// Images that some material shows or some light shines through.
std::set<std::size_t> shownImages(const Json& document) {
  static constexpr const char* kTextures[] = {"/pbrMetallicRoughness/baseColorTexture",
                                              "/pbrMetallicRoughness/metallicRoughnessTexture",
                                              "/normalTexture",
                                              "/occlusionTexture",
                                              "/emissiveTexture",
                                              "/extensions/KHR_materials_pbrSpecularGlossiness/diffuseTexture"};
  std::set<std::size_t> shown;
  const auto show = [&](const Json& textureIndex) {
    const Json& texture = document["textures"][textureIndex.get<std::size_t>()];
    if (texture.contains("source")) shown.insert(texture["source"].get<std::size_t>());
  };
  const Json::json_pointer lights("/extensions/KHR_lights_punctual/lights"), cookie("/extras/cookie/index");
  if (document.contains(lights))
    for (const Json& light : document[lights])
      if (light.contains(cookie)) show(light[cookie]);
  if (!document.contains("materials")) return shown;
  for (const Json& material : document["materials"]) {
    for (const char* pointer : kTextures) {
      const Json::json_pointer at(std::string(pointer) + "/index");
      if (material.contains(at)) show(material[at]);
    }
  }
  return shown;
}

struct Fetcher {
  const Container& container;
  Resources resources;
  Warnings& warnings;

  void buffers(Json& document, Prepared& out) {
    if (!document.contains("buffers")) return;
    Json& list = document["buffers"];
    for (std::size_t i = 0; i < list.size(); ++i) {
      Json& buffer = list[i];
      const std::string name = element("buffers", i);
      const auto announced = buffer["byteLength"].get<std::uint64_t>();
      std::vector<std::byte> bytes;
      if (announced == 0) {
        // Nothing can be read of it.
      } else if (buffer.contains("uri")) {
        try {
          bytes = resources.load(buffer["uri"].get_ref<const std::string&>(), name);
        } catch (const Refusal& refusal) {
          warnings.count("buffers that cannot be read", refusal.reason, "what lies in them is left out");
        }
      } else if (i == 0 && container.binary) {
        bytes.assign(container.binary->begin(), container.binary->end());
      } else {
        warnings.add(name + " has neither a URI nor a binary chunk");
      }
      if (!bytes.empty() && bytes.size() < announced)
        warnings.count(
            "buffers that are too short",
            name + " announces " + std::to_string(announced) + " bytes; " + std::to_string(bytes.size()) + " are there",
            "what lies beyond is left out");
      bytes.resize(std::min<std::size_t>(bytes.size(), announced));
      // tinygltf wants a byte.
      buffer = {{"byteLength", std::max<std::size_t>(bytes.size(), 1)}, {"uri", "buffer/" + std::to_string(i)}};
      out.buffers.push_back(std::move(bytes));
    }
  }

  /// After the buffers: an image may lie in one.
  void images(Json& document, Prepared& out) {
    if (!document.contains("images")) return;
    const std::set<std::size_t> shown = shownImages(document);
    Json& list = document["images"];
    for (std::size_t i = 0; i < list.size(); ++i) {
      Json& image = list[i];
      std::string name = element("images", i);
      if (image.contains("name")) name += " " + inQuotes(image["name"].get<std::string>());
      std::vector<std::byte> bytes;
      if (shown.contains(i)) {
        try {
          bytes = imageBytes(image, document, out, name);
        } catch (const Refusal& refusal) {
          warnings.count(kImageKind, refusal.reason, kImageConsequence);
        }
      }
      Json reduced = {{"uri", "image/" + std::to_string(i)}};
      if (image.contains("name")) reduced["name"] = std::move(image["name"]);
      image = std::move(reduced);
      out.images.push_back(std::move(bytes));
      out.imageNames.push_back(std::move(name));
    }
  }

  std::vector<std::byte> imageBytes(Json& image, const Json& document, const Prepared& out, const std::string& name) {
    std::vector<std::byte> bytes;
    if (image.contains("uri") == image.contains("bufferView")) refuse(name + " needs either a URI or a buffer view");
    if (image.contains("uri")) {
      bytes = resources.load(image["uri"].get_ref<const std::string&>(), name);
      const auto& uri = image["uri"].get_ref<const std::string&>();
      if (!image.contains("name") && uri.size() < 200 && uri.find(':') == std::string::npos) image["name"] = uri;
    } else {
      bytes = slice(document["bufferViews"][image["bufferView"].get<std::size_t>()], out, name);
    }
    if (bytes.size() < 2) refuse(name + " is empty");
    return bytes;
  }

  static std::vector<std::byte> slice(const Json& view, const Prepared& out, const std::string& name) {
    const auto& buffer = out.buffers[view["buffer"].get<std::size_t>()];
    const std::size_t offset = view.value("byteOffset", std::size_t{0}), length = view["byteLength"].get<std::size_t>();
    if (offset + length > buffer.size()) refuse(name + " lies in a buffer whose bytes are absent");
    return {buffer.begin() + static_cast<std::ptrdiff_t>(offset),
            buffer.begin() + static_cast<std::ptrdiff_t>(offset + length)};
  }
};

}  // namespace

Prepared prepare(const Container& container, const std::filesystem::path& path, std::uint64_t fileSize,
                 Warnings& warnings) {
  const Json raw = parse(container.json);
  if (!raw.is_object()) refuse("its JSON is not an object");
  Json document = checked(raw, gltfSchema(), raw, "", warnings);
  checkVersion(document);
  checkExtensions(document, warnings);
  if (document.contains("nodes") && document["nodes"].size() > kMaxNodes)
    refuse("nodes has " + std::to_string(document["nodes"].size()) + " elements; at most " + std::to_string(kMaxNodes) +
           " are expected");
  checkViews(document, warnings);
  adapt(document, warnings);
  Prepared out;
  Fetcher fetcher{container, Resources(path, fileSize), warnings};
  fetcher.buffers(document, out);
  fetcher.images(document, out);
  out.contentHash = fetcher.resources.contentHash();
  out.json = document.dump();
  out.hasMeshes = raw.contains("meshes") && !raw["meshes"].empty();
  return out;
}

}  // namespace tyndall::scene
