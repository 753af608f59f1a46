#include "level_builder.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include "levels/levels.hpp"
#include "shapes.hpp"

namespace tyndall::levels {
namespace {

template <class T>
std::int32_t append(std::vector<T>& list, T item) {
  list.push_back(std::move(item));
  return static_cast<std::int32_t>(list.size() - 1);
}

glm::vec4 asValue(const glm::quat& q) { return {q.x, q.y, q.z, q.w}; }

/// Catmull-Rom through points of a closed loop; `at` counts points.
glm::vec3 onLoop(const std::vector<glm::vec3>& points, float at) {
  const auto count = static_cast<int>(points.size());
  const int i = static_cast<int>(glm::floor(at));
  const float t = at - real(i);
  const auto p = [&](int k) { return points[((i + k) % count + count) % count]; };
  return 0.5f * (2.0f * p(0) + (p(1) - p(-1)) * t + (2.0f * p(-1) - 5.0f * p(0) + 4.0f * p(1) - p(2)) * t * t +
                 (3.0f * p(0) - p(-1) - 3.0f * p(1) + p(2)) * t * t * t);
}

}  // namespace

std::int32_t LevelBuilder::texture(scene::Image image, scene::Wrap wrap, bool mips) {
  scene::Texture t;
  t.image = append(scene_.images, std::move(image));
  t.sampler.useMipmaps = mips;
  t.sampler.wrapU = t.sampler.wrapV = wrap;
  return append(scene_.textures, t);
}

std::int32_t LevelBuilder::material(scene::Material material) { return append(scene_.materials, std::move(material)); }

std::int32_t LevelBuilder::material(const std::string& name, const Surface& surface, const glm::vec4& factor,
                                    const glm::vec3& bounced) {
  scene::Material m;
  m.name = name;
  m.baseColor = factor;
  m.metallic = 0;
  m.baseColorTexture.texture = texture(surface.colorImage(name + " colour"));
  if (bounced != glm::vec3(0)) {
    m.emissive = glm::vec3(factor) * bounced;
    m.emissiveTexture = m.baseColorTexture;
  }
  m.normalTexture.texture = texture(surface.normalImage(name + " normal"));
  m.metallicRoughnessTexture.texture = texture(surface.roughnessImage(name + " roughness"));
  return material(m);
}

std::int32_t LevelBuilder::plain(const std::string& name, const glm::vec3& color, float roughness, float metallic) {
  scene::Material m;
  m.name = name;
  m.baseColor = glm::vec4(color, 1);
  m.roughness = roughness;
  m.metallic = metallic;
  return material(m);
}

std::int32_t LevelBuilder::glowing(const std::string& name, const glm::vec4& color, const glm::vec3& light,
                                   float roughness, scene::AlphaMode mode) {
  scene::Material m;
  m.name = name;
  m.baseColor = color;
  m.metallic = 0;
  m.roughness = roughness;
  m.emissive = light;
  m.alphaMode = mode;
  return material(m);
}

std::int32_t LevelBuilder::pane(const std::string& name, std::int32_t picture, const glm::vec3& light) {
  scene::Material m;
  m.name = name;
  m.metallic = 0;
  m.roughness = 0.2f;
  m.baseColor = {0.05f, 0.05f, 0.05f, 1};
  m.alphaMode = scene::AlphaMode::kBlend;
  m.doubleSided = true;
  m.emissive = light;
  m.baseColorTexture.texture = m.emissiveTexture.texture = picture;
  return material(m);
}

std::int32_t LevelBuilder::cutout(const std::string& name, std::int32_t picture, const glm::vec3& tint, float roughness,
                                  float metallic) {
  scene::Material m;
  m.name = name;
  m.baseColor = glm::vec4(tint, 1);
  m.metallic = metallic;
  m.roughness = roughness;
  m.alphaMode = scene::AlphaMode::kMask;
  m.alphaCutoff = 0.5f;
  m.doubleSided = true;
  m.baseColorTexture.texture = picture;
  return material(m);
}

std::int32_t LevelBuilder::mesh(const std::string& name, std::vector<scene::Primitive> primitives) {
  std::erase_if(primitives, [](const scene::Primitive& p) { return p.indices.empty(); });
  return append(scene_.meshes, scene::Mesh{name, std::move(primitives)});
}

std::int32_t LevelBuilder::node(scene::Node node) { return append(scene_.nodes, std::move(node)); }

std::int32_t LevelBuilder::node(const std::string& name, std::int32_t mesh, const glm::vec3& at, float yaw, float scale,
                                std::int32_t parent) {
  scene::Node n;
  n.name = name;
  n.mesh = mesh;
  n.parent = parent;
  n.translation = at;
  n.rotation = glm::angleAxis(yaw, glm::vec3(0, 1, 0));
  n.scale = glm::vec3(scale);
  return node(n);
}

void LevelBuilder::single(const std::string& name, std::vector<scene::Primitive> primitives) {
  node(name, mesh(name, std::move(primitives)));
}

void LevelBuilder::sun(const glm::vec3& toSun, const glm::vec3& color, float lux, const std::string& name) {
  scene::Light light;
  light.name = name;
  light.color = color;
  light.intensity = lux;
  scene::Node n;
  n.name = name;
  n.light = append(scene_.lights, light);
  n.rotation = lookRotation(-toSun);
  node(n);
}

std::int32_t LevelBuilder::point(const std::string& name, const glm::vec3& at, const glm::vec3& color, float candela,
                                 float range, std::int32_t parent) {
  scene::Light light;
  light.name = name;
  light.kind = scene::LightKind::kPoint;
  light.color = color;
  light.intensity = candela;
  light.range = range;
  scene::Node n;
  n.name = name;
  n.parent = parent;
  n.light = append(scene_.lights, light);
  n.translation = at;
  return node(n);
}

std::int32_t LevelBuilder::spot(const std::string& name, const glm::vec3& at, const glm::vec3& target,
                                const glm::vec3& color, float candela, float innerCone, float outerCone, float range,
                                std::int32_t cookie) {
  scene::Light light;
  light.name = name;
  light.kind = scene::LightKind::kSpot;
  light.color = color;
  light.intensity = candela;
  light.range = range;
  light.innerConeAngle = glm::radians(innerCone);
  light.outerConeAngle = glm::radians(outerCone);
  if (cookie != scene::kNone) light.cookie = scene::Cookie{cookie};
  scene::Node n;
  n.name = name;
  n.light = append(scene_.lights, light);
  n.translation = at;
  n.rotation = lookRotation(target - at);
  return node(n);
}

std::int32_t LevelBuilder::camera(const std::string& name, const glm::vec3& eye, const glm::vec3& target,
                                  float verticalFov, float zfar) {
  scene::Camera camera;
  camera.name = name;
  camera.yfov = glm::radians(verticalFov);
  camera.znear = 0.1f;
  camera.zfar = zfar;
  scene::Node n;
  n.name = name;
  n.camera = append(scene_.cameras, camera);
  n.translation = eye;
  n.rotation = lookRotation(target - eye);
  return node(n);
}

void LevelBuilder::animate(scene::AnimationChannel channel) {
  if (scene_.animations.empty()) scene_.animations.push_back({"life", 0, {}});
  scene::Animation& animation = scene_.animations.front();
  animation.duration = glm::max(animation.duration, channel.times.back());
  animation.channels.push_back(std::move(channel));
}

void LevelBuilder::animateSwing(std::int32_t node, const glm::vec3& axis, float middle, float amplitude, float period,
                                int periods) {
  constexpr int kKeys = 16;  // per period: linear interpolation is within 2% of the amplitude
  scene::AnimationChannel channel;
  channel.node = node;
  channel.target = scene::AnimationTarget::kRotation;
  for (int i = 0; i <= kKeys * periods; ++i) {
    const float phase = 2.0f * glm::pi<float>() * real(i % kKeys) / real(kKeys);
    channel.times.push_back(period * real(i) / real(kKeys));
    channel.values.push_back(asValue(glm::angleAxis(middle + amplitude * glm::sin(phase), axis)));
  }
  animate(std::move(channel));
}

void LevelBuilder::animateSpin(std::int32_t node, const glm::vec3& axis, int turns, float seconds) {
  constexpr int kKeys =
      8;  // per turn: between keys 45 degrees apart even linear interpolation keeps its pace within 3%
  scene::AnimationChannel channel;
  channel.node = node;
  channel.target = scene::AnimationTarget::kRotation;
  for (int i = 0; i <= kKeys * turns; ++i) {
    // Half angles of two turns, so that neighbours never change their sign.
    const float angle = 2.0f * glm::pi<float>() * real(i % (2 * kKeys)) / real(kKeys);
    channel.times.push_back(seconds * real(i) / real(kKeys * turns));
    const glm::quat q(glm::cos(0.5f * angle), glm::sin(0.5f * angle) * axis);
    channel.values.push_back(asValue(q));
  }
  animate(std::move(channel));
}

void LevelBuilder::animateTour(std::int32_t camera, const std::vector<std::pair<glm::vec3, glm::vec3>>& stops,
                               float seconds) {
  constexpr int kKeys = 12;  // per stop
  std::vector<glm::vec3> eyes, targets;
  for (const auto& [eye, target] : stops) eyes.push_back(eye), targets.push_back(target);
  scene::AnimationChannel move, turn;
  move.node = turn.node = camera;
  turn.target = scene::AnimationTarget::kRotation;
  const int keys = kKeys * static_cast<int>(stops.size());
  for (int i = 0; i <= keys; ++i) {
    const float at = real(i % keys) / real(kKeys);
    const glm::vec3 eye = onLoop(eyes, at);
    glm::vec4 rotation = asValue(lookRotation(onLoop(targets, at) - eye));
    if (i > 0 && glm::dot(rotation, turn.values.back()) < 0) rotation = -rotation;  // the short way round
    move.times.push_back(seconds * real(i) / real(keys));
    move.values.emplace_back(eye, 0.0f);
    turn.values.push_back(rotation);
  }
  turn.times = move.times;
  scene_.nodes[camera].translation = eyes.front();
  scene_.nodes[camera].rotation =
      glm::quat(turn.values.front().w, turn.values.front().x, turn.values.front().y, turn.values.front().z);
  animate(std::move(move));
  animate(std::move(turn));
}

std::size_t instancedTriangles(const scene::Scene& scene) {
  std::size_t count = 0;
  for (const scene::Node& node : scene.nodes) {
    if (node.mesh == scene::kNone) continue;
    for (const scene::Primitive& p : scene.meshes[node.mesh].primitives) count += p.indices.size() / 3;
  }
  return count;
}

}  // namespace tyndall::levels
