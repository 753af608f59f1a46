#include "light_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "culling.hpp"

namespace tyndall::render {

namespace {

std::string label(const std::vector<scene::LightView>& lights, std::uint32_t index) {
  const std::string& name = lights[index].light.name;
  return "light " + std::to_string(index) + (name.empty() ? "" : " '" + name + "'");
}

/// Lux or candela of the strongest channel.
double strength(const scene::LightView& light) {
  return std::max({light.light.color.r, light.light.color.g, light.light.color.b}) * light.light.intensity;
}

// Irradiance at the eye without shadow and cone: a spot light that points elsewhere may still light what is seen.
double importance(const View& view, const scene::LightView& light) {
  if (light.light.kind == scene::LightKind::kDirectional) return strength(light);
  const glm::dvec3 to = glm::dvec3(light.position) - glm::dvec3(view.eye);
  return strength(light) / std::max(glm::dot(to, to), 0.01);
}

/// Indices of the lights: suns first, then those of the greatest `weight`.
template <class Weight>
std::vector<std::uint32_t> sunsFirst(const std::vector<scene::LightView>& lights, Weight&& weight) {
  std::vector<std::uint32_t> order(lights.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const bool sunA = lights[a].light.kind == scene::LightKind::kDirectional;
    const bool sunB = lights[b].light.kind == scene::LightKind::kDirectional;
    return sunA != sunB ? sunA : weight(lights[a]) > weight(lights[b]);
  });
  return order;
}

/// Sides of all lights' maps that fit into the budget together; 0 for those that have no room at all.
std::vector<std::uint32_t> sizesWithin(const std::vector<scene::LightView>& lights, std::uint32_t side, double budget,
                                       double texelBytes) {
  // By strength, not by importance: that changes with the camera, and sizes of maps are a part of an effect's layout.
  const std::vector<std::uint32_t> order = sunsFirst(lights, strength);
  std::vector<std::uint32_t> sides(lights.size(), side);
  const auto bytes = [&](std::uint32_t i) {
    return texelBytes * sides[i] * sides[i] * (lights[i].light.kind == scene::LightKind::kPoint ? 6 : 1);
  };
  double used = 0;
  for (std::uint32_t i = 0; i < lights.size(); ++i) used += bytes(i);
  for (std::uint32_t now = side; used > budget && now > kLeastShadowSide; now = std::max(now / 2, kLeastShadowSide))
    for (auto i = order.rbegin(); i != order.rend() && used > budget; ++i) {
      used -= bytes(*i);
      sides[*i] = std::max(now / 2, kLeastShadowSide);
      used += bytes(*i);
    }
  for (auto i = order.rbegin(); i != order.rend() && used > budget; ++i) {
    used -= bytes(*i);
    sides[*i] = 0;
  }
  return sides;
}

/// One line for all lights of which the same is to be said.
void tellTogether(const std::vector<scene::LightView>& lights,
                  const std::vector<std::pair<std::uint32_t, std::string>>& told, std::vector<std::string>& notes) {
  std::vector<std::string> kinds;
  for (const auto& [index, text] : told)
    if (std::find(kinds.begin(), kinds.end(), text) == kinds.end()) kinds.push_back(text);
  for (const std::string& text : kinds) {
    std::size_t count = 0;
    std::uint32_t first = 0;
    for (const auto& [index, other] : told)
      if (other == text && count++ == 0) first = index;
    notes.push_back(label(lights, first) + (count > 1 ? " and " + std::to_string(count - 1) + " more" : "") + ": " +
                    text);
  }
}

shared::LightBlock makeBlock(const scene::LightView& view, const ShadowFit& fit, std::uint32_t shadowSize) {
  const scene::Light& light = view.light;
  shared::LightBlock block{};
  block.core.position = view.position;
  block.core.kind = light.kind == scene::LightKind::kDirectional ? shared::kLightDirectional
                    : light.kind == scene::LightKind::kSpot      ? shared::kLightSpot
                                                                 : shared::kLightPoint;
  block.core.direction = glm::normalize(view.direction);
  block.core.range = light.range.value_or(0.0f);
  block.core.intensity = light.color * light.intensity;
  shared::ConeFalloff cone;
  if (light.kind == scene::LightKind::kSpot) cone = shared::coneFalloff(light.innerConeAngle, light.outerConeAngle);
  block.core.coneOuter = cone.outer;
  block.core.coneScale = cone.scale;
  block.texelSize = static_cast<float>(fit.texelSize);
  block.shadowSize = static_cast<float>(shadowSize);
  block.depthCurve = fit.depthCurve;
  std::copy(fit.clipFromWorld.begin(), fit.clipFromWorld.end(), block.clipFromWorld);
  return block;
}

}  // namespace

LightPlan planLights(const View& view, const std::vector<scene::LightView>& lights, const scene::Bounds& casters,
                     std::uint32_t shadowSize, std::uint64_t budgetBytes, double texelBytes) {
  LightPlan plan;
  const std::vector<std::uint32_t> order =
      sunsFirst(lights, [&](const scene::LightView& light) { return importance(view, light); });

  const std::vector<std::uint32_t> sides =
      sizesWithin(lights, shadowSize, static_cast<double>(budgetBytes), texelBytes);
  std::vector<std::pair<std::uint32_t, std::string>> told;
  std::uint32_t smaller = 0, least = shadowSize;
  for (const std::uint32_t index : order) {
    if (sides[index] == 0) {
      plan.unshadowed.push_back(index);
      continue;
    }
    smaller += sides[index] < shadowSize;
    least = std::min(least, sides[index]);
    plan.shadowed.push_back({index, sides[index], fitShadow(view, lights[index], casters, sides[index])});
    const std::string& note = plan.shadowed.back().fit.note;
    if (!note.empty()) told.emplace_back(index, note);
  }
  tellTogether(lights, told, plan.notes);
  const std::string budget = std::to_string(budgetBytes >> 20) + " MiB of shadow maps";
  if (smaller > 0)
    plan.notes.push_back(std::to_string(smaller) + " of " + std::to_string(lights.size()) +
                         " lights have smaller shadow maps than shadows.resolution says, down to " +
                         std::to_string(least) + " texels a side: " + budget +
                         " are shared, the strongest lights first");
  if (!plan.unshadowed.empty())
    plan.notes.push_back(std::to_string(plan.unshadowed.size()) + " of " + std::to_string(lights.size()) +
                         " lights are off: " + budget + " have no room for the smallest of theirs");
  for (const PlannedLight& light : plan.shadowed)
    plan.blocks.push_back(makeBlock(lights[light.source], light.fit, light.size));
  for (const std::uint32_t index : plan.unshadowed) {
    plan.blocks.push_back(makeBlock(lights[index], {}, shadowSize));
    plan.blocks.back().core.intensity = glm::vec3(0);  // it would light through walls
  }
  return plan;
}

void PixelRect::add(const PixelRect& other) {
  if (other.empty()) return;
  if (empty()) {
    *this = other;
    return;
  }
  *this = {std::min(x0, other.x0), std::min(y0, other.y0), std::max(x1, other.x1), std::max(y1, other.y1)};
}

PixelRect reach(const View& view, const scene::LightView& light) {
  const PixelRect whole{0, 0, static_cast<std::int32_t>(view.width), static_cast<std::int32_t>(view.height)};
  if (light.light.kind == scene::LightKind::kDirectional || !light.light.range) return whole;
  const scene::Bounds box{light.position - *light.light.range, light.position + *light.light.range};
  const glm::mat4 clipFromWorld = view.clipFromView * view.viewFromWorld;
  if (!mayBeSeen(box, clipFromWorld, DepthPlanes::kBoth)) return {};
  glm::vec2 low(1e30f), high(-1e30f);
  for (const glm::vec3& corner : boxCorners(box, light.position)) {
    const glm::vec4 clip = clipFromWorld * glm::vec4(corner, 1);
    if (clip.w <= view.znear) return whole;  // reaches the eye's plane: no rectangle from projected corners
    low = glm::min(low, glm::vec2(clip) / clip.w);
    high = glm::max(high, glm::vec2(clip) / clip.w);
  }
  const glm::vec2 size(view.width, view.height);
  // The rectangle is cut to the picture; nothing of the light is lost.
  low = glm::clamp(glm::floor((low * 0.5f + 0.5f) * size), glm::vec2(0), size);
  high = glm::clamp(glm::ceil((high * 0.5f + 0.5f) * size), glm::vec2(0), size);
  return {static_cast<std::int32_t>(low.x), static_cast<std::int32_t>(low.y), static_cast<std::int32_t>(high.x),
          static_cast<std::int32_t>(high.y)};
}

}  // namespace tyndall::render
