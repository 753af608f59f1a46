// A level as plain data: no Vulkan, no glTF. Metres, radians, seconds; right-handed, +Y up; cameras and lights look
// down -Z of their node (docs/conventions.md). Everything an importer hands out is valid: every index is in range,
// every number finite, every triangle list a multiple of three (checkScene says so, and the importer calls it).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace tyndall::scene {

inline constexpr std::int32_t kNone = -1;

struct Vertex {
  glm::vec3 position{0};
  glm::vec3 normal{0, 0, 1};      ///< unit length
  glm::vec4 tangent{1, 0, 0, 1};  ///< xyz unit length, w = handedness (+1 or -1)
  glm::vec2 uv{0};
  glm::vec4 color{1};  ///< linear, multiplies the base colour
};

/// Axis-aligned box; empty when min > max.
struct Bounds {
  glm::vec3 min{1e30f};
  glm::vec3 max{-1e30f};
  bool empty() const { return min.x > max.x; }
  void add(const glm::vec3& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  void add(const Bounds& b) {
    if (!b.empty()) {
      add(b.min);
      add(b.max);
    }
  }
};

/// A triangle list with one material.
struct Primitive {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three per triangle
  std::int32_t material = kNone;       ///< index into Scene::materials; kNone: the glTF default material
  Bounds bounds;                       ///< of the vertices, in the mesh's space
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
};

enum class Filter { kNearest, kLinear };
enum class Wrap { kRepeat, kClampToEdge, kMirroredRepeat };

struct Sampler {
  Filter magnify = Filter::kLinear;
  Filter minify = Filter::kLinear;
  Filter mipmap = Filter::kLinear;
  bool useMipmaps = true;
  Wrap wrapU = Wrap::kRepeat;
  Wrap wrapV = Wrap::kRepeat;
};

/// 8-bit RGBA, row 0 on top, width*height*4 bytes.
struct Image {
  std::string name;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgba;
};

struct Texture {
  std::int32_t image = kNone;
  Sampler sampler;
};

/// uv' = offset + rotation(scale * uv), KHR_texture_transform; identity by default.
struct TextureUse {
  std::int32_t texture = kNone;
  glm::vec2 offset{0};
  glm::vec2 scale{1};
  float rotation = 0;
  bool used() const { return texture != kNone; }
};

enum class AlphaMode { kOpaque, kMask, kBlend };

/// glTF metallic-roughness. Colours are linear factors; base colour and emissive images are sRGB-coded.
struct Material {
  std::string name;
  glm::vec4 baseColor{1};
  float metallic = 1;
  float roughness = 1;
  glm::vec3 emissive{0};  ///< radiance-like factor, KHR_materials_emissive_strength already applied
  float normalScale = 1;
  float occlusionStrength = 1;
  float alphaCutoff = 0.5f;
  AlphaMode alphaMode = AlphaMode::kOpaque;
  bool doubleSided = false;
  bool unlit = false;
  bool castsShadow = true;  ///< by default not where unlit: sky domes and backdrops
  TextureUse baseColorTexture, metallicRoughnessTexture, normalTexture, occlusionTexture, emissiveTexture;
};

struct Node {
  std::string name;
  std::int32_t parent = kNone;  ///< always smaller than the node's own index (parents come first)
  glm::vec3 translation{0};
  glm::quat rotation{1, 0, 0, 0};
  glm::vec3 scale{1};
  std::optional<glm::mat4> matrix;  ///< set when the file gave a matrix; then TRS is not used
  std::int32_t mesh = kNone;
  std::int32_t camera = kNone;
  std::int32_t light = kNone;
  bool castsShadow = true;  ///< its mesh; false wherever its material says so
  std::uint32_t order = 0;  ///< place in the file's own list of nodes, which may have children before parents
};

/// A perspective camera.
struct Camera {
  std::string name;
  float yfov = 0.9f;          ///< vertical field of view, radians, (0, pi)
  float znear = 0.1f;         ///< metres, > 0
  std::optional<float> zfar;  ///< metres, > znear; absent: infinite, see farPlane()
};

enum class LightKind { kDirectional, kSpot, kPoint };

/// An image that a light shines through (a gobo): its colour, sRGB-coded, multiplies the light's. How it is projected:
/// docs/conventions.md, "Cookies". Always filtered linearly; alpha is not read.
struct Cookie {
  std::int32_t texture = kNone;  ///< index into Scene::textures
  glm::vec2 size{10};            ///< directional: width and height of one tile, metres, > 0; not read for others
};
/// A spot light's cookie spans its cone up to this half angle, radians (89 degrees), as the plane of a right angle is
/// infinitely large; the image's border goes on beyond.
inline constexpr float kMaxCookieAngle = 1.5533430f;

/// How a point light's image is laid out, by its sides; nothing: neither 2:1 nor 6:1.
enum class CookieShape { kEquirectangular, kCubeStrip };
std::optional<CookieShape> pointCookieShape(const Image& image);

/// KHR_lights_punctual. Directional: intensity in lux; spot and point: candela.
struct Light {
  std::string name;
  LightKind kind = LightKind::kDirectional;
  glm::vec3 color{1};
  float intensity = 1;
  std::optional<float> range;  ///< metres; absent: infinite
  float innerConeAngle = 0;    ///< radians, half angle
  float outerConeAngle = 0.7853982f;
  std::optional<Cookie> cookie{};
};

enum class AnimationTarget { kTranslation, kRotation, kScale };
enum class Interpolation { kStep, kLinear, kCubicSpline };

struct AnimationChannel {
  std::int32_t node = kNone;
  AnimationTarget target = AnimationTarget::kTranslation;
  Interpolation interpolation = Interpolation::kLinear;
  std::vector<float> times;       ///< seconds, strictly increasing
  std::vector<glm::vec4> values;  ///< one per time; three (in-tangent, value, out-tangent) per time for cubic splines;
                                  ///< quaternions are x,y,z,w
};

struct Animation {
  std::string name;
  float duration = 0;
  std::vector<AnimationChannel> channels;
};

struct Scene {
  std::string name;
  /// The level's hint: linear factor on radiance before the tone map (extras, docs/conventions.md, "Exposure").
  std::optional<float> exposure;
  std::vector<Node> nodes;  ///< parents before children; only nodes of the default scene
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::vector<Camera> cameras;
  std::uint32_t orthographicCameras = 0;  ///< nodes of the file that have one: not read so far, left out
  std::vector<Light> lights;
  std::vector<Animation> animations;
};

/// World matrix of every node, at `seconds` of all animations (looped by their duration). Size: nodes.size().
std::vector<glm::mat4> worldMatrices(const Scene& scene, double seconds);

/// How every node is turned, without its size: columns are its right, up and backward in the world, of length one and
/// perpendicular. The rotations and mirrorings of the node and those above it; a scale of 0 counts as a small positive
/// one, and sizes not at all. Nothing where a node's matrix says too little (it has no two directions left, nor a
/// backward one).
std::vector<std::optional<glm::mat3>> worldTurns(const Scene& scene, double seconds);

/// Bounds of all mesh instances in world space.
Bounds worldBounds(const Scene& scene, const std::vector<glm::mat4>& worldFromNode);

/// A camera placed in the world.
struct CameraView {
  glm::mat4 worldFromView{1};  ///< rigid (scale of the node removed), the view looks down -Z
  Camera camera;
  std::string name;
};
/// All perspective cameras at `seconds`, in the order that the file lists their nodes (Node::order). Of worldTurns()
/// they take where to look and what is up.
std::vector<CameraView> placedCameras(const Scene& scene, double seconds);

/// Where view rays end that meet nothing, metres along the optical axis: the camera's own far plane. One that has none
/// sees infinitely far; its air has to end somewhere, and does so behind the farthest point of `level`, the box of
/// everything in it, but no nearer than 1000 m. It does not depend on where the camera looks, so that air does not
/// change as it turns. Always finite and beyond znear.
float farPlane(const CameraView& view, const Bounds& level);

/// A line about a camera so far from the origin that the rounding of float positions around it is seen in shadows and
/// surfaces; empty for all others.
std::string roundingNote(const CameraView& view);

/// A camera that frames `bounds` from a raised three-quarter view; used when a file has none.
CameraView framingCamera(const Bounds& bounds);

/// A light placed in the world. Shining direction is -Z of the node.
struct LightView {
  Light light;
  glm::vec3 position{0};
  glm::vec3 direction{0, -1, 0};  ///< unit; direction in which the light travels
  std::int32_t node = kNone;      ///< kNone for the default sun
  /// Rotation of the light's cookie: columns are the node's right, up and backward (-direction), scale and mirroring
  /// removed.
  glm::mat3 worldFromLight{1};
};
/// All lights at `seconds`; turned as cameras are.
std::vector<LightView> placedLights(const Scene& scene, double seconds);

/// The sun that a file without lights gets.
LightView defaultSun();

}  // namespace tyndall::scene
