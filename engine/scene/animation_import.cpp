#include <algorithm>
#include <cmath>

#include "accessor.hpp"
#include "import_parts.hpp"
#include "scene/limits.hpp"

namespace tyndall::scene {
namespace {

using document::Document;

std::optional<AnimationTarget> target(const std::string& path) {
  if (path == "translation") return AnimationTarget::kTranslation;
  if (path == "rotation") return AnimationTarget::kRotation;
  if (path == "scale") return AnimationTarget::kScale;
  return {};
}

glm::vec4 unitQuaternion(const glm::vec4& q, const std::string& what, Warnings& warnings) {
  const glm::dvec4 d(q);
  const double length = std::sqrt(glm::dot(d, d));
  if (length > 1e-20) return glm::vec4(d / length);
  warnings.add(what + " has a zero quaternion; it does not rotate");
  return {0, 0, 0, 1};
}

/// Whether a spline's tangents, which count by the time between two keys, may lead beyond what any node can stand at.
bool leadsAstray(const AnimationChannel& channel) {
  if (channel.interpolation != Interpolation::kCubicSpline) return false;
  for (std::size_t k = 0; k + 1 < channel.times.size(); ++k) {
    const double duration = double{channel.times[k + 1]} - double{channel.times[k]};
    for (const glm::vec4& tangent : {channel.values[3 * k + 2], channel.values[3 * (k + 1)]})
      if (glm::length(glm::dvec4(tangent)) * duration > double{kMaxExtent}) return true;
  }
  return false;
}

/// Keys and values; keys that do not advance in time are left out.
void readKeys(const Document& document, const document::AnimationSampler& sampler, const std::string& what,
              AnimationChannel& out, Warnings& warnings) {
  const AccessorReader times(document, sampler.input, what + ".input");
  const AccessorReader values(document, sampler.output, what + ".output");
  const int width = out.target == AnimationTarget::kRotation ? 4 : 3;
  const std::size_t perKey = sampler.interpolation == Interpolation::kCubicSpline ? 3 : 1;
  if (times.width() != 1 || times.componentType() != 5126) refuse(what + ".input is not a list of floats");
  if (values.width() != width)
    refuse(what + ".output has " + std::to_string(values.width()) + " components; " + std::to_string(width) +
           " are expected");
  if (values.count() != times.count() * perKey)
    refuse(what + ".output has " + std::to_string(values.count()) + " elements; " +
           std::to_string(times.count() * perKey) + " are expected");
  out.interpolation = sampler.interpolation;
  for (std::size_t i = 0; i < times.count(); ++i) {
    const float time = times.vector(i).x;
    if (time < 0 || (!out.times.empty() && time <= out.times.back())) {
      warnings.add(what + " has keys before 0 or not after the one before; they were left out");
      continue;
    }
    out.times.push_back(time);
    for (std::size_t k = 0; k < perKey; ++k) {
      glm::vec4 value = values.vector(i * perKey + k);
      if (glm::any(glm::greaterThan(glm::abs(value), glm::vec4(kMaxExtent))))
        refuse(what + ".output: element " + std::to_string(i * perKey + k) + " is beyond " +
               std::to_string(static_cast<long>(kMaxExtent)));
      const bool tangent = perKey == 3 && k != 1;
      if (width == 4 && !tangent) value = unitQuaternion(value, what, warnings);
      out.values.push_back(value);
    }
  }
}

}  // namespace

void importAnimations(const Document& document, std::span<const std::int32_t> sceneNode, Scene& scene,
                      Warnings& warnings) {
  // Many channels may name the same accessors: count before allocating.
  std::size_t values = 0;
  for (const document::Animation& in : document.animations)
    for (const document::AnimationChannel& channel : in.channels)
      values += document.accessors[in.samplers[channel.sampler].output].count;
  if (values > kMaxAnimationValues)
    refuse("its animations have more than " + std::to_string(kMaxAnimationValues) + " values");
  for (std::size_t a = 0; a < document.animations.size(); ++a) {
    const document::Animation& in = document.animations[a];
    Animation out{in.name, 0, {}};
    for (const document::AnimationChannel& channel : in.channels) {
      const std::string what = element("animations", a) + "." + element("samplers", channel.sampler);
      const auto path = target(channel.path);
      if (!path) {
        warnings.add("animation of " + inQuotes(channel.path) + " is not supported and was left out");
        continue;
      }
      const std::int32_t node = sceneNode[channel.node];
      if (node == kNone) continue;  // of another scene
      if (scene.nodes[node].matrix) {
        warnings.add(element("animations", a) + " moves " + element("nodes", channel.node) +
                     ", which has a matrix; that was left out");
        continue;
      }
      AnimationChannel imported;
      imported.node = node;
      imported.target = *path;
      try {
        readKeys(document, in.samplers[channel.sampler], what, imported, warnings);
      } catch (const Refusal& refusal) {
        warnings.count("broken channels", refusal.reason, kEachLeftOut);
        continue;
      }
      if (imported.times.empty()) continue;
      if (leadsAstray(imported))
        warnings.count("splines that lead too far", what, "where one does, its node stays at rest");
      out.duration = std::max(out.duration, imported.times.back());
      out.channels.push_back(std::move(imported));
    }
    if (!out.channels.empty()) scene.animations.push_back(std::move(out));
  }
}

}  // namespace tyndall::scene
