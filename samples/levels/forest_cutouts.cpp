// Leaves, needles, grass and fern, drawn leaf by leaf.
#include <glm/gtc/constants.hpp>

#include "forest_textures.hpp"
#include "mesh_builder.hpp"
#include "noise.hpp"
#include "random.hpp"

namespace tyndall::levels::forest {
namespace {

using glm::vec2;
using glm::vec3;
using glm::vec4;

vec2 turned(float angle) { return {glm::sin(angle), -glm::cos(angle)}; }  // 0: up in the image

/// One leaf: stem at `base`, tip `length` away; `slim` is half its greatest width over its length.
void leaf(Cutout& canvas, vec2 base, float angle, float length, float slim, const vec3& color, float teeth = 0) {
  const vec2 along = turned(angle), across{-along.y, along.x}, tip = base + along * length;
  const vec2 room(slim * length * 1.1f);
  canvas.paint(glm::min(base, tip) - room, glm::max(base, tip) + room, [&](vec2 uv) {
    const vec2 p = uv - base;
    const float s = glm::dot(p, along) / length, t = glm::dot(p, across) / length, side = glm::abs(t);
    if (s <= 0 || s >= 1) return vec4(0);
    float width = slim * glm::sin(glm::pi<float>() * glm::pow(s, 0.8f)) * (1.0f + 0.15f * (0.5f - s));
    width *= 1.0f - teeth * glm::fract(s * 14.0f);
    if (side > width) return vec4(0);
    const float rib = 1.0f - glm::smoothstep(0.008f, 0.028f, side);
    const float veins = glm::smoothstep(0.6f, 1.0f, glm::sin((s - 0.9f * side) * 52.0f));
    const float half = t < 0 ? 0.94f : 1.05f;  // both halves catch the light differently
    return vec4(color * half * (1.0f + 0.28f * rib + 0.12f * veins - 0.22f * side / slim), 1.0f);
  });
}

/// A tapering stroke from `from` to `to`.
void stroke(Cutout& canvas, vec2 from, vec2 to, float width, const vec3& color) {
  const vec2 along = to - from;
  canvas.paint(glm::min(from, to) - width, glm::max(from, to) + width, [&](vec2 uv) {
    const float s = glm::dot(uv - from, along) / glm::dot(along, along);
    const float off = glm::length(uv - from - along * glm::clamp(s, 0.0f, 1.0f));
    return s < 0 || s > 1 || off > width * (1.0f - 0.6f * s) ? vec4(0) : vec4(color, 1);
  });
}

}  // namespace

scene::Image leafyTwig() {
  Cutout canvas(512, 512);
  Random random(2024);
  const vec3 wood(0.22f, 0.16f, 0.10f);
  const auto spray = [&](vec2 from, float angle, float length, int leaves) {
    const vec2 along = turned(angle);
    stroke(canvas, from, from + along * length, 0.006f, wood);
    for (int i = 0; i < leaves; ++i) {
      const float s = 0.2f + 0.8f * real(i) / real(leaves - 1);
      const float side = i % 2 == 0 ? -1.0f : 1.0f;
      const float spread = (i == leaves - 1 ? 0.0f : side * random.range(0.7f, 1.15f));
      const float tone = random.unit();
      const vec3 color = glm::mix(vec3(0.22f, 0.34f, 0.10f), vec3(0.43f, 0.53f, 0.17f), tone);
      leaf(canvas, from + along * (length * s), angle + spread, random.range(0.085f, 0.118f) * (1.0f - 0.15f * s),
           random.range(0.24f, 0.31f), color);
    }
  };
  stroke(canvas, {0.5f, 1.0f}, {0.5f, 0.12f}, 0.012f, wood);
  for (int i = 0; i < 9; ++i) {
    const float s = real(i) / 8.0f, side = i % 2 == 0 ? -1.0f : 1.0f;
    spray({0.5f, 0.90f - 0.66f * s}, side * random.range(0.8f, 1.1f) * (1.0f - 0.3f * s), 0.37f * (1.0f - 0.45f * s),
          9);
  }
  spray({0.5f, 0.30f}, 0.05f, 0.18f, 7);
  return canvas.image("leafy twig", {0.30f, 0.41f, 0.13f});
}

scene::Image spruceFrond() {
  Cutout canvas(256, 512);
  Random random(77);
  const vec3 wood(0.24f, 0.17f, 0.11f);
  // A twig with its needles: a feather, cut into needles that lean forwards.
  const auto feather = [&](vec2 base, float angle, float length, float reach) {
    const vec2 scale(1.0f, 0.5f);  // the image is twice as high as wide: draw in square units
    const vec2 along = turned(angle), across{-along.y, along.x}, room(reach);
    const float shift = random.unit(), tone = random.unit();
    const vec2 tip = base + along * length;
    canvas.paint((glm::min(base, tip) - room) * scale, (glm::max(base, tip) + room) * scale, [&](vec2 uv) {
      const vec2 p = uv / scale - base;
      const float s = glm::dot(p, along), t = glm::abs(glm::dot(p, across));
      if (s < 0 || s > length + reach) return vec4(0);
      if (t < 0.007f && s < length) return vec4(wood, 1);
      const float root = s - 0.7f * t;  // where the needle leaves the twig
      const float longest = reach * (1.0f - 0.35f * root / length);
      if (root < 0 || root > length || t > longest) return vec4(0);
      const float needle = glm::fract(root * 46.0f + shift + (glm::dot(p, across) < 0 ? 0.5f : 0.0f));
      if (needle > 0.80f - 0.25f * t / longest) return vec4(0);
      const vec3 color =
          glm::mix(vec3(0.13f, 0.215f, 0.105f), vec3(0.25f, 0.36f, 0.15f), 0.6f * tone + 0.4f * t / longest);
      return vec4(color * (0.85f + 0.3f * needle), 1);
    });
  };
  for (int i = 0; i < 11; ++i) {
    const float s = real(i) / 10.0f;
    for (const float side : {-1.0f, 1.0f}) {
      const float length = 0.62f * (1.0f - 0.72f * s) * random.range(0.8f, 1.0f);
      feather({0.5f, 1.86f - 1.5f * s}, side * random.range(0.8f, 1.0f) * (1.0f - 0.25f * s), length, 0.085f);
    }
  }
  feather({0.5f, 2.0f}, 0, 1.88f, 0.09f);
  return canvas.image("spruce frond", {0.18f, 0.28f, 0.13f});
}

scene::Image undergrowth() {
  Cutout canvas(512, 256);  // two squares
  Random random(5);
  for (int i = 0; i < 46; ++i) {  // grass, back to front
    const float x0 = random.range(0.14f, 0.36f), lean = random.range(-0.14f, 0.14f), high = random.range(0.4f, 0.97f),
                width = random.range(0.006f, 0.011f);
    const vec3 color = glm::mix(vec3(0.21f, 0.30f, 0.085f), vec3(0.50f, 0.53f, 0.22f), random.unit());
    canvas.paint({glm::max(0.0f, x0 - 0.2f), 1.0f - high}, {glm::min(0.5f, x0 + 0.2f), 1.0f}, [&](vec2 uv) {
      const float up = (1.0f - uv.y) / high;
      const float off = glm::abs(uv.x - (x0 + lean * up * up));
      const float w = width * (1.0f - up * up);
      return up > 1.0f || off > w ? vec4(0) : vec4(color * (0.5f + 0.6f * up) * (off < 0.2f * w ? 1.15f : 1.0f), 1);
    });
  }
  const vec2 scale(0.5f, 1.0f);
  stroke(canvas, vec2(1.5f, 1.0f) * scale, vec2(1.5f, 0.08f) * scale, 0.006f, vec3(0.28f, 0.26f, 0.10f));
  for (int i = 0; i < 30; ++i) {  // the frond's pinnae, longest low down
    const float s = real(i) / 29.0f,
                length = 0.46f * glm::pow(1.0f - s, 0.75f) * glm::smoothstep(-0.12f, 0.12f, s) + 0.02f;
    for (const float side : {-1.0f, 1.0f}) {
      const vec3 color = glm::mix(vec3(0.20f, 0.33f, 0.09f), vec3(0.36f, 0.48f, 0.15f), random.unit());
      const float angle = side * (1.30f - 0.45f * s);
      const vec2 base(1.5f, 0.93f - 0.84f * s);
      const vec2 along = turned(angle), across{-along.y, along.x};
      const vec2 tip = base + along * length, room(0.05f);
      canvas.paint((glm::min(base, tip) - room) * scale, (glm::max(base, tip) + room) * scale, [&](vec2 uv) {
        const vec2 p = uv / scale - base;
        const float u = glm::dot(p, along) / length, t = glm::abs(glm::dot(p, across));
        if (u < 0 || u > 1) return vec4(0);
        const float width = 0.027f * (1.0f - 0.8f * u) * (0.55f + 0.45f * glm::abs(glm::sin(u * length * 46.0f)));
        return t > width ? vec4(0) : vec4(color * (t < 0.004f ? 1.2f : 1.0f), 1);
      });
    }
  }
  return canvas.image("undergrowth", {0.30f, 0.40f, 0.13f});
}

}  // namespace tyndall::levels::forest
