#include "scene/check.hpp"

#include <cmath>

namespace tyndall::scene {
namespace {

/// Squared length may differ from 1 by this much: float rounding after one normalisation stays far below it.
constexpr float kUnitTolerance = 1e-3f;

bool finite(float v) { return std::isfinite(v); }
template <int N>
bool finite(const glm::vec<N, float>& v) {
  for (int i = 0; i < N; ++i)
    if (!std::isfinite(v[i])) return false;
  return true;
}
bool finite(const glm::quat& q) { return finite(glm::vec4(q.x, q.y, q.z, q.w)); }
bool unit(const glm::vec3& v) { return finite(v) && std::abs(glm::dot(v, v) - 1.0f) < kUnitTolerance; }
bool inUnitRange(float v) { return v >= 0 && v <= 1; }  // false for NaN

/// Collects the first complaint; later checks are skipped.
struct Checker {
  std::string complaint;
  bool good() const { return complaint.empty(); }
  void require(bool condition, const std::string& what) {
    if (good() && !condition) complaint = what;
  }
  void index(std::int32_t i, std::size_t count, const std::string& what, const char* items, bool optional) {
    const bool inRange = (optional && i == kNone) || (i >= 0 && static_cast<std::size_t>(i) < count);
    if (good() && !inRange)
      complaint = what + " is " + std::to_string(i) + "; there are " + std::to_string(count) + " " + items;
  }
};

std::string at(const char* array, std::size_t i) { return std::string(array) + "[" + std::to_string(i) + "]"; }

void checkPrimitive(Checker& c, const Scene& scene, const Primitive& p, const std::string& name, bool withBounds) {
  c.index(p.material, scene.materials.size(), name + ".material", "materials", true);
  c.require(p.indices.size() % 3 == 0, name + ".indices is not a whole number of triangles");
  for (std::size_t i = 0; i < p.indices.size() && c.good(); ++i)
    if (p.indices[i] >= p.vertices.size())
      c.require(false, name + "." + at("indices", i) + " is " + std::to_string(p.indices[i]) + "; there are " +
                           std::to_string(p.vertices.size()) + " vertices");
  Bounds bounds;
  for (std::size_t i = 0; i < p.vertices.size() && c.good(); ++i) {
    const Vertex& v = p.vertices[i];
    bounds.add(v.position);
    const bool sound = finite(v.position) && unit(v.normal) && unit(glm::vec3(v.tangent)) &&
                       std::abs(v.tangent.w) == 1.0f && finite(v.uv) && finite(v.color);
    if (!sound)
      c.require(false,
                name + "." + at("vertices", i) + " has a number that is not finite or a vector that is not unit");
  }
  c.require(!withBounds || (p.bounds.min == bounds.min && p.bounds.max == bounds.max),
            name + ".bounds are not those of its vertices");
}

void checkMaterial(Checker& c, const Scene& scene, const Material& m, const std::string& name) {
  const TextureUse* uses[] = {&m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.occlusionTexture,
                              &m.emissiveTexture};
  for (const TextureUse* use : uses) {
    c.index(use->texture, scene.textures.size(), name + "'s texture", "textures", true);
    c.require(finite(use->offset) && finite(use->scale) && finite(use->rotation),
              name + "'s texture transform is not finite");
  }
  for (int i = 0; i < 4; ++i) c.require(inUnitRange(m.baseColor[i]), name + ".baseColor is outside 0..1");
  c.require(inUnitRange(m.metallic), name + ".metallic is outside 0..1");
  c.require(inUnitRange(m.roughness), name + ".roughness is outside 0..1");
  c.require(inUnitRange(m.occlusionStrength), name + ".occlusionStrength is outside 0..1");
  c.require(finite(m.emissive) && glm::all(glm::greaterThanEqual(m.emissive, glm::vec3(0))),
            name + ".emissive is negative or not finite");
  c.require(finite(m.normalScale), name + ".normalScale is not finite");
  c.require(finite(m.alphaCutoff) && m.alphaCutoff >= 0, name + ".alphaCutoff is negative or not finite");
}

void checkNode(Checker& c, const Scene& scene, std::size_t i) {
  const Node& n = scene.nodes[i];
  const std::string name = at("nodes", i);
  c.index(n.parent, i, name + ".parent", "nodes before it", true);
  c.index(n.mesh, scene.meshes.size(), name + ".mesh", "meshes", true);
  c.index(n.camera, scene.cameras.size(), name + ".camera", "cameras", true);
  c.index(n.light, scene.lights.size(), name + ".light", "lights", true);
  bool sound = finite(n.translation) && finite(n.rotation) && finite(n.scale);
  if (n.matrix)
    for (int column = 0; column < 4; ++column) sound = sound && finite((*n.matrix)[column]);
  c.require(sound, name + "'s transform is not finite");
  c.require(std::abs(glm::dot(n.rotation, n.rotation) - 1.0f) < kUnitTolerance,
            name + ".rotation is not a unit quaternion");
}

void checkCamera(Checker& c, const Camera& camera, const std::string& name) {
  c.require(camera.yfov > 0 && camera.yfov < 3.1415926f, name + ".yfov is outside 0..pi");
  c.require(camera.znear > 0 && finite(camera.znear), name + ".znear is not above 0");
  c.require(!camera.zfar || (*camera.zfar > camera.znear && finite(*camera.zfar)), name + ".zfar is not beyond znear");
}

void checkLight(Checker& c, const Scene& scene, const Light& light, const std::string& name) {
  c.require(finite(light.color) && glm::all(glm::greaterThanEqual(light.color, glm::vec3(0))),
            name + ".color is negative or not finite");
  c.require(light.intensity >= 0 && finite(light.intensity), name + ".intensity is negative or not finite");
  c.require(!light.range || (*light.range > 0 && finite(*light.range)), name + ".range is not above 0");
  if (light.kind == LightKind::kSpot)
    c.require(light.innerConeAngle >= 0 && light.innerConeAngle <= light.outerConeAngle && light.outerConeAngle > 0 &&
                  light.outerConeAngle <= 1.5707964f,
              name + "'s cone angles are not 0 <= inner <= outer <= pi/2 with outer above 0");
  if (!light.cookie) return;
  c.index(light.cookie->texture, scene.textures.size(), name + ".cookie.texture", "textures", false);
  c.require(finite(light.cookie->size) && light.cookie->size.x > 0 && light.cookie->size.y > 0,
            name + ".cookie.size is not above 0");
  if (light.kind == LightKind::kPoint && c.good())
    c.require(pointCookieShape(scene.images[scene.textures[light.cookie->texture].image]).has_value(),
              name + ".cookie's image is neither 2:1 nor 6:1");
}

void checkChannel(Checker& c, const Scene& scene, const AnimationChannel& channel, const std::string& name) {
  c.index(channel.node, scene.nodes.size(), name + ".node", "nodes", false);
  const std::size_t perKey = channel.interpolation == Interpolation::kCubicSpline ? 3 : 1;
  c.require(!channel.times.empty(), name + " has no key");
  c.require(channel.values.size() == channel.times.size() * perKey, name + " has not as many values as keys");
  for (std::size_t i = 0; i < channel.times.size() && c.good(); ++i)
    c.require(finite(channel.times[i]) && channel.times[i] >= 0 && (i == 0 || channel.times[i] > channel.times[i - 1]),
              name + ".times are not strictly increasing from 0 on");
  for (const glm::vec4& value : channel.values)
    if (!finite(value)) c.require(false, name + " has a value that is not finite");
}

}  // namespace

Result<void> checkScene(const Scene& scene, bool withBounds) {
  Checker c;
  for (std::size_t m = 0; m < scene.meshes.size() && c.good(); ++m)
    for (std::size_t p = 0; p < scene.meshes[m].primitives.size() && c.good(); ++p)
      checkPrimitive(c, scene, scene.meshes[m].primitives[p], at("meshes", m) + "." + at("primitives", p), withBounds);
  for (std::size_t i = 0; i < scene.materials.size() && c.good(); ++i)
    checkMaterial(c, scene, scene.materials[i], at("materials", i));
  for (std::size_t i = 0; i < scene.textures.size() && c.good(); ++i)
    c.index(scene.textures[i].image, scene.images.size(), at("textures", i) + ".image", "images", false);
  for (std::size_t i = 0; i < scene.images.size() && c.good(); ++i) {
    const Image& image = scene.images[i];
    c.require(image.width > 0 && image.height > 0 && image.rgba.size() == 4ull * image.width * image.height,
              at("images", i) + " has not width x height x 4 bytes");
  }
  for (std::size_t i = 0; i < scene.nodes.size() && c.good(); ++i) checkNode(c, scene, i);
  for (std::size_t i = 0; i < scene.cameras.size() && c.good(); ++i) checkCamera(c, scene.cameras[i], at("cameras", i));
  for (std::size_t i = 0; i < scene.lights.size() && c.good(); ++i)
    checkLight(c, scene, scene.lights[i], at("lights", i));
  for (std::size_t a = 0; a < scene.animations.size() && c.good(); ++a)
    for (std::size_t k = 0; k < scene.animations[a].channels.size() && c.good(); ++k)
      checkChannel(c, scene, scene.animations[a].channels[k], at("animations", a) + "." + at("channels", k));
  if (!c.good()) return failed(c.complaint);
  return {};
}

}  // namespace tyndall::scene
