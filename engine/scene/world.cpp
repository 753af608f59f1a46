// Node transforms over time.
#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/limits.hpp"
#include "scene/scene.hpp"
#include "turn.hpp"

namespace tyndall::scene {
namespace {

glm::quat quaternion(const glm::vec4& xyzw) { return glm::quat(xyzw.w, xyzw.x, xyzw.y, xyzw.z); }
glm::vec4 xyzw(const glm::quat& q) { return {q.x, q.y, q.z, q.w}; }

/// glTF 2.0 appendix C. Before the first and after the last key the value stays.
glm::vec4 sample(const AnimationChannel& channel, float time) {
  const auto& times = channel.times;
  const bool cubic = channel.interpolation == Interpolation::kCubicSpline;
  const auto value = [&](std::size_t key) { return cubic ? channel.values[3 * key + 1] : channel.values[key]; };
  if (!(time > times.front())) return value(0);  // of a time that is none, too
  if (time >= times.back()) return value(times.size() - 1);
  const std::size_t next = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
  const std::size_t previous = next - 1;
  if (channel.interpolation == Interpolation::kStep) return value(previous);
  const float duration = times[next] - times[previous];
  const float t = (time - times[previous]) / duration;
  if (cubic) {
    const glm::vec4 outTangent = channel.values[3 * previous + 2] * duration,
                    inTangent = channel.values[3 * next] * duration;
    const float t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * value(previous) + (t3 - 2 * t2 + t) * outTangent + (3 * t2 - 2 * t3) * value(next) +
           (t3 - t2) * inTangent;
  }
  if (channel.target != AnimationTarget::kRotation) return glm::mix(value(previous), value(next), t);
  return xyzw(glm::slerp(quaternion(value(previous)), quaternion(value(next)), t));  // glm takes the shorter way
}

struct Pose {
  glm::vec3 translation, scale;
  glm::quat rotation;
};

void apply(const Animation& animation, double seconds, std::vector<Pose>& poses) {
  double time = 0;
  if (animation.duration > 0) {
    time = std::fmod(seconds, static_cast<double>(animation.duration));
    if (time < 0) time += animation.duration;
  }
  for (const AnimationChannel& channel : animation.channels) {
    const glm::vec4 value = sample(channel, static_cast<float>(time));
    // A spline between sound keys may lead anywhere, and past what a float holds: the node then stays at rest.
    if (!glm::all(glm::lessThanEqual(glm::abs(value), glm::vec4(kMaxExtent)))) continue;
    Pose& pose = poses[channel.node];
    if (channel.target == AnimationTarget::kTranslation)
      pose.translation = value;
    else if (channel.target == AnimationTarget::kScale)
      pose.scale = value;
    else if (glm::dot(value, value) > 0)
      pose.rotation = glm::normalize(quaternion(value));  // a spline leaves the unit sphere
  }
}

glm::mat4 matrix(const Pose& pose) {
  glm::mat4 m = glm::mat4_cast(pose.rotation);
  for (int axis = 0; axis < 3; ++axis) m[axis] *= pose.scale[axis];
  m[3] = glm::vec4(pose.translation, 1);
  return m;
}

std::vector<Pose> posesAt(const Scene& scene, double seconds) {
  std::vector<Pose> poses;
  poses.reserve(scene.nodes.size());
  for (const Node& node : scene.nodes) poses.push_back({node.translation, node.scale, node.rotation});
  for (const Animation& animation : scene.animations) apply(animation, seconds, poses);
  return poses;
}

}  // namespace

std::vector<glm::mat4> worldMatrices(const Scene& scene, double seconds) {
  const std::vector<Pose> poses = posesAt(scene, seconds);
  std::vector<glm::mat4> worldFromNode(scene.nodes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    const glm::mat4 parentFromNode = node.matrix ? *node.matrix : matrix(poses[i]);
    const glm::mat4 world = node.parent == kNone ? parentFromNode : worldFromNode[node.parent] * parentFromNode;
    // Scales of several nodes can multiply past what a float holds, at some time: such a node stays with its parent.
    bool finite = true;
    for (int column = 0; column < 4; ++column)
      finite = finite && !glm::any(glm::isnan(world[column])) && !glm::any(glm::isinf(world[column]));
    worldFromNode[i] = finite ? world : node.parent == kNone ? glm::mat4(1) : worldFromNode[node.parent];
  }
  return worldFromNode;
}

std::vector<std::optional<glm::mat3>> worldTurns(const Scene& scene, double seconds) {
  const std::vector<Pose> poses = posesAt(scene, seconds);
  std::vector<std::optional<glm::mat3>> turns(scene.nodes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    const auto own = node.matrix ? turnOf(glm::mat3(*node.matrix)) : turnOf(poses[i].rotation, poses[i].scale);
    if (node.parent == kNone)
      turns[i] = own;
    else if (own && turns[node.parent])
      turns[i] = *turns[node.parent] * *own;
  }
  return turns;
}

Bounds worldBounds(const Scene& scene, const std::vector<glm::mat4>& worldFromNode) {
  Bounds out;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].mesh == kNone) continue;
    // Every corner of each primitive's box: encloses the vertices, exactly so when the node does not rotate.
    for (const Primitive& p : scene.meshes[scene.nodes[i].mesh].primitives) {
      for (int corner = 0; corner < 8 && !p.bounds.empty(); ++corner) {
        const glm::vec3 c(corner & 1 ? p.bounds.max.x : p.bounds.min.x, corner & 2 ? p.bounds.max.y : p.bounds.min.y,
                          corner & 4 ? p.bounds.max.z : p.bounds.min.z);
        // Where an animation leads farther than a level may reach, it is not in sight.
        const glm::vec3 world(worldFromNode[i] * glm::vec4(c, 1));
        if (glm::all(glm::lessThanEqual(glm::abs(world), glm::vec3(kMaxExtent)))) out.add(world);
      }
    }
  }
  return out;
}

}  // namespace tyndall::scene
