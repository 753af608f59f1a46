// The tables of glTF 2.0 (Khronos specification, section 5) and of the extensions that the importer knows.
#include "scene/limits.hpp"
#include "schema.hpp"

namespace tyndall::scene {
namespace {

// tinygltf keeps most integers as int.
constexpr double kMaxInt = 2147483647.0;
constexpr double kHalfPi = 1.5707963267948966;
// Far above anything meant (the sun: 1e5 lux), far below where products of a few such numbers leave a float.
constexpr double kMaxIntensity = 1e12, kMaxColor = 1e6, kMaxStrength = 1e9, kMaxTransform = 1e6, kMaxNormalScale = 1e3;
constexpr const char* kComponentTypes = "5120|5121|5122|5123|5125|5126";

Property text(const char* key, const char* choices = nullptr, bool required = false) {
  return {.key = key, .kind = Kind::kString, .required = required, .choices = choices};
}
Property flag(const char* key) { return {.key = key, .kind = Kind::kBoolean}; }
Property integer(const char* key, double low, double high, bool required = false, const char* choices = nullptr) {
  return {.key = key, .kind = Kind::kInteger, .required = required, .low = low, .high = high, .choices = choices};
}
Property index(const char* key, const char* array, bool required = false) {
  return {.key = key, .kind = Kind::kIndex, .required = required, .array = array};
}
Property indices(const char* key, const char* array) { return {.key = key, .kind = Kind::kIndices, .array = array}; }
/// Repaired when outside: exporters write 1.0000001 and the like.
Property factor(const char* key, double low, double high) {
  return {.key = key, .kind = Kind::kNumber, .low = low, .high = high, .clamp = true};
}
Property smallVector(const char* key, std::size_t size, double low, double high) {
  return {
      .key = key, .kind = Kind::kNumbers, .low = low, .high = high, .clamp = true, .minItems = size, .maxItems = size};
}
Property vector(const char* key, std::size_t size) {
  return {.key = key, .kind = Kind::kNumbers, .minItems = size, .maxItems = size};
}
Property factors(const char* key, std::size_t size, double high) { return smallVector(key, size, 0, high); }
Property object(const char* key, const Schema& schema, bool required = false) {
  return {.key = key, .kind = Kind::kObject, .required = required, .object = &schema};
}
Property objects(const char* key, const Schema& schema, const char* standIn) {
  return {.key = key, .kind = Kind::kObjects, .object = &schema, .standIn = standIn};
}

Property freeObject(const char* key, const Schema& schema) {
  return {.key = key, .kind = Kind::kObject, .free = true, .object = &schema};
}

const Schema kEmpty{};
// Ours, in the extras of scene, document and asset: docs/conventions.md, "Exposure".
const Schema kLevelHints{{{.key = "exposure", .kind = Kind::kAny}}};
const Schema kLevelExtras{{freeObject("tyndall", kLevelHints)}};
// Ours, in the extras of nodes and materials: docs/conventions.md, "Shadows".
const Schema kCasterHints{{{.key = "casts_shadow", .kind = Kind::kAny}}};
const Schema kCasterExtras{{freeObject("tyndall", kCasterHints)}};
const Schema kAsset{{text("version", nullptr, true), text("minVersion"), freeObject("extras", kLevelExtras)}};
const Schema kBuffer{{text("uri"), integer("byteLength", 0, kMaxInt, true)}};
const Schema kBufferView{{index("buffer", "buffers", true), integer("byteOffset", 0, kMaxInt),
                          integer("byteLength", 0, kMaxInt, true), integer("byteStride", 4, 252)}};

const Schema kSparseIndices{{index("bufferView", "bufferViews", true), integer("byteOffset", 0, kMaxInt),
                             integer("componentType", 0, kMaxInt, true, "5121|5123|5125")}};
const Schema kSparseValues{{index("bufferView", "bufferViews", true), integer("byteOffset", 0, kMaxInt)}};
const Schema kSparse{{integer("count", 1, kMaxInt, true), object("indices", kSparseIndices, true),
                      object("values", kSparseValues, true)}};
const Schema kAccessor{{index("bufferView", "bufferViews"), integer("byteOffset", 0, kMaxInt),
                        integer("componentType", 0, kMaxInt, true, kComponentTypes), flag("normalized"),
                        integer("count", 0, kMaxInt, true), text("type", "SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4", true),
                        object("sparse", kSparse)}};

const Schema kPrimitive{{{.key = "attributes", .kind = Kind::kAttributes, .required = true, .array = "accessors"},
                         index("indices", "accessors"),
                         index("material", "materials"),
                         integer("mode", 0, 6),
                         objects("targets", kEmpty, "")}};
const Schema kMesh{{text("name"), objects("primitives", kPrimitive, "")}};

const Schema kTransform{{smallVector("offset", 2, -kMaxTransform, kMaxTransform),
                         factor("rotation", -kMaxTransform, kMaxTransform),
                         smallVector("scale", 2, -kMaxTransform, kMaxTransform), integer("texCoord", 0, 255)}};
const Schema kTextureExtensions{{object("KHR_texture_transform", kTransform)}};
const Schema kTextureInfo{
    {index("index", "textures", true), integer("texCoord", 0, 255), object("extensions", kTextureExtensions)}};
const Schema kNormalTexture{{index("index", "textures", true), integer("texCoord", 0, 255),
                             factor("scale", -kMaxNormalScale, kMaxNormalScale),
                             object("extensions", kTextureExtensions)}};
const Schema kOcclusionTexture{{index("index", "textures", true), integer("texCoord", 0, 255), factor("strength", 0, 1),
                                object("extensions", kTextureExtensions)}};
const Schema kMetallicRoughness{{factors("baseColorFactor", 4, 1), object("baseColorTexture", kTextureInfo),
                                 factor("metallicFactor", 0, 1), factor("roughnessFactor", 0, 1),
                                 object("metallicRoughnessTexture", kTextureInfo)}};
const Schema kSpecularGlossiness{{factors("diffuseFactor", 4, 1), object("diffuseTexture", kTextureInfo),
                                  factors("specularFactor", 3, 1), factor("glossinessFactor", 0, 1)}};
const Schema kEmissiveStrength{{factor("emissiveStrength", 0, kMaxStrength)}};
const Schema kTransmission{{factor("transmissionFactor", 0, 1), object("transmissionTexture", kTextureInfo)}};
const Schema kMaterialExtensions{{object("KHR_materials_unlit", kEmpty),
                                  object("KHR_materials_transmission", kTransmission),
                                  object("KHR_materials_emissive_strength", kEmissiveStrength),
                                  object("KHR_materials_pbrSpecularGlossiness", kSpecularGlossiness)}};
const Schema kMaterial{
    {text("name"), object("pbrMetallicRoughness", kMetallicRoughness), object("normalTexture", kNormalTexture),
     object("occlusionTexture", kOcclusionTexture), object("emissiveTexture", kTextureInfo),
     factors("emissiveFactor", 3, 1), text("alphaMode", "OPAQUE|MASK|BLEND"), factor("alphaCutoff", 0, kMaxColor),
     flag("doubleSided"), object("extensions", kMaterialExtensions), freeObject("extras", kCasterExtras)}};

const Schema kImage{{text("name"), text("uri"), index("bufferView", "bufferViews"), text("mimeType")}};
const Schema kSampler{{integer("magFilter", 0, kMaxInt, false, "9728|9729"),
                       integer("minFilter", 0, kMaxInt, false, "9728|9729|9984|9985|9986|9987"),
                       integer("wrapS", 0, kMaxInt, false, "10497|33071|33648"),
                       integer("wrapT", 0, kMaxInt, false, "10497|33071|33648")}};
const Schema kTexture{{index("sampler", "samplers"), index("source", "images")}};

const Schema kNodeLight{{index("light", "KHR_lights_punctual.lights", true)}};
const Schema kVisibility{{flag("visible")}};
const Schema kNodeExtensions{{object("KHR_lights_punctual", kNodeLight), object("KHR_node_visibility", kVisibility)}};
const Schema kNode{{text("name"), indices("children", "nodes"), index("camera", "cameras"), index("mesh", "meshes"),
                    index("skin", "skins"), vector("matrix", 16), vector("translation", 3), vector("rotation", 4),
                    vector("scale", 3), object("extensions", kNodeExtensions), freeObject("extras", kCasterExtras)}};
const Schema kScene{{text("name"), indices("nodes", "nodes"), freeObject("extras", kLevelExtras)}};

const Schema kPerspective{
    {{.key = "yfov", .kind = Kind::kNumber, .required = true, .low = 1e-4, .high = 3.1415},
     {.key = "znear", .kind = Kind::kNumber, .required = true, .low = 1e-5, .high = kMaxExtent, .clamp = true},
     factor("zfar", 0, kMaxExtent)}};
const Schema kCamera{
    {text("name"), text("type", "perspective|orthographic", true), object("perspective", kPerspective)}};

const Schema kSpot{{factor("innerConeAngle", 0, kHalfPi), factor("outerConeAngle", 0, kHalfPi)}};
// Ours, in the light's extras: docs/conventions.md, "Cookies".
const Schema kCookie{
    {index("index", "textures", true),
     {.key = "size", .kind = Kind::kNumbers, .low = 1e-4, .high = kMaxExtent, .minItems = 2, .maxItems = 2}}};
const Schema kLightExtras{{object("cookie", kCookie)}};
const Schema kLight{{text("name"), text("type", "directional|point|spot", true), factors("color", 3, kMaxColor),
                     factor("intensity", 0, kMaxIntensity), factor("range", 0, kMaxExtent), object("spot", kSpot),
                     freeObject("extras", kLightExtras)}};
const Schema kLights{{objects("lights", kLight, R"({"type": "broken"})")}};
const Schema kDocumentExtensions{{object("KHR_lights_punctual", kLights)}};

const Schema kTarget{{index("node", "nodes"), text("path", nullptr, true)}};
const Schema kChannel{{integer("sampler", 0, kMaxInt, true), object("target", kTarget, true)}};
const Schema kAnimationSampler{{index("input", "accessors", true), index("output", "accessors", true),
                                text("interpolation", "STEP|LINEAR|CUBICSPLINE")}};
const Schema kAnimation{
    {text("name"), objects("channels", kChannel, ""), objects("samplers", kAnimationSampler, nullptr)}};

const Schema kDocument{{object("asset", kAsset, true),
                        {.key = "extensionsUsed", .kind = Kind::kStrings},
                        {.key = "extensionsRequired", .kind = Kind::kStrings},
                        objects("buffers", kBuffer, R"({"byteLength": 0})"),
                        objects("bufferViews", kBufferView, R"({"buffer": 0, "byteLength": 0})"),
                        objects("accessors", kAccessor, R"({"componentType": 5126, "count": 0, "type": "SCALAR"})"),
                        objects("meshes", kMesh, R"({"primitives": []})"),
                        objects("materials", kMaterial, "{}"),
                        objects("textures", kTexture, "{}"),
                        objects("images", kImage, "{}"),
                        objects("samplers", kSampler, "{}"),
                        objects("nodes", kNode, "{}"),
                        objects("scenes", kScene, "{}"),
                        index("scene", "scenes"),
                        objects("cameras", kCamera, R"({"type": "broken"})"),
                        objects("animations", kAnimation, "{}"),
                        object("extensions", kDocumentExtensions),
                        freeObject("extras", kLevelExtras)}};

}  // namespace

const Schema& gltfSchema() { return kDocument; }

}  // namespace tyndall::scene
