#include "hall_textures.hpp"

#include <glm/gtc/constants.hpp>

#include "noise.hpp"

namespace tyndall::levels::hall {
namespace {

using glm::ivec2;
using glm::vec2;
using glm::vec3;

/// Wood without joints: long grain with drifting rings. `p` in metres, tiling over `tile` metres.
Texel grain(vec2 p, float tile, std::uint32_t seed) {
  const int cells = static_cast<int>(tile);
  const float drift = fbm(p * vec2(1.0f, 6.0f), ivec2(cells, cells * 6), 3, seed);
  const float rings = glm::sin((p.y * 14.0f + drift * 3.5f) * 2.0f * glm::pi<float>());
  const float fibre = fbm(p * vec2(5.0f, 64.0f), ivec2(cells * 5, cells * 64), 3, seed + 9);
  const float tone = 0.5f + 0.16f * rings + 0.75f * (fibre - 0.5f) + 0.5f * (drift - 0.5f);
  Texel t;
  t.color = glm::mix(vec3(0.21f, 0.135f, 0.085f), vec3(0.47f, 0.335f, 0.22f), glm::clamp(tone, 0.0f, 1.0f));
  t.height = 1.1f * fibre + 0.25f * rings;
  t.roughness = 0.62f + 0.2f * (1.0f - tone);
  return t;
}

}  // namespace

Surface ashlar() {
  constexpr int kCourses = 8, kBlocks = 4;  // of half a metre by about a metre
  return {512, 512, [](vec2 uv) {
            const vec2 p = uv * kAshlarTile;
            const float course = uv.y * kCourses;
            const int row = static_cast<int>(course);
            const float inRow = (course - static_cast<float>(row)) * 0.5f;  // metres from the upper joint
            // Joints of one course: evenly spaced, shifted by half a block in every second course, then moved a bit.
            const auto joint = [&](int i) {
              const float moved = 0.34f * (cellHash((i % kBlocks + kBlocks) % kBlocks, row, 11) - 0.5f);
              return static_cast<float>(i) + 0.5f * static_cast<float>(row % 2) + moved;
            };
            int block = static_cast<int>(glm::floor(p.x)) - 1;
            while (joint(block + 1) <= p.x) ++block;
            const float toSide = glm::min(p.x - joint(block), joint(block + 1) - p.x);
            const float wobble = 0.012f * (fbm(uv * 32.0f, ivec2(32), 2, 5) - 0.5f);
            const float edge =
                glm::min(toSide, glm::min(inRow, 0.5f - inRow)) + wobble;  // metres to the joint's middle
            const float face = glm::smoothstep(0.006f, 0.03f, edge);
            const float id = cellHash((block % kBlocks + kBlocks) % kBlocks, row, 3), hue = cellHash(block & 3, row, 4);
            const float coarse = fbm(uv * 8.0f, ivec2(8), 5, 21), fine = fbm(uv * 64.0f, ivec2(64), 3, 22);
            const float pits = glm::smoothstep(0.62f, 0.8f, fbm(uv * 24.0f, ivec2(24), 3, 23));
            Texel t;
            const vec3 stone = glm::mix(vec3(0.60f, 0.55f, 0.475f), vec3(0.67f, 0.635f, 0.57f), id) *
                               glm::mix(vec3(1.02f, 1, 0.96f), vec3(0.97f, 1, 1.04f), hue);
            t.color = stone * (0.80f + 0.24f * coarse + 0.16f * fine - 0.12f * pits);
            t.color = glm::mix(vec3(0.47f, 0.445f, 0.40f) * (0.85f + 0.3f * fine), t.color, face);
            t.height = 1.9f * face + 1.5f * coarse + 0.9f * fine - 0.8f * pits + 0.5f * id;
            t.roughness = 0.86f + 0.1f * (1.0f - face);
            return t;
          }};
}

Surface flags() {
  constexpr int kTiles = 4;
  return {512, 512, [](vec2 uv) {
            const vec2 at = uv * static_cast<float>(kTiles), cell = glm::floor(at), in = at - cell;
            const ivec2 id(cell);
            const float edge = 0.5f - glm::max(glm::abs(in.x - 0.5f), glm::abs(in.y - 0.5f));
            const float chip = 0.02f * fbm(uv * 24.0f, ivec2(24), 3, 31);
            const float face = glm::smoothstep(0.012f, 0.035f, edge - chip + 0.008f);
            const float tone = cellHash(id.x, id.y, 32),
                        veins = fbm(uv * 6.0f, ivec2(6), 5, 33 + static_cast<std::uint32_t>(id.x + id.y) % 2);
            const float wear = fbm(uv * 5.0f, ivec2(5), 3, 39), fine = fbm(uv * 64.0f, ivec2(64), 2, 34);
            Texel t;
            const bool dark = (id.x + id.y) % 2 == 0;
            const vec3 stone = dark ? vec3(0.33f, 0.265f, 0.235f) : vec3(0.63f, 0.575f, 0.49f);
            t.color = stone * (0.82f + 0.22f * tone + 0.30f * (veins - 0.5f) + 0.10f * (fine - 0.5f));
            t.color = glm::mix(vec3(0.23f, 0.21f, 0.19f), t.color, face);
            t.height = 2.2f * face + 0.5f * veins + 0.35f * fine + 0.7f * tone * (in.x - 0.5f) * 4.0f * face;
            t.roughness = glm::mix(0.92f, 0.34f + 0.34f * wear + 0.1f * fine, face);
            return t;
          }};
}

Surface dressed() {
  return {256, 256, [](vec2 uv) {
            const float coarse = fbm(uv * 5.0f, ivec2(5), 5, 41), fine = fbm(uv * 48.0f, ivec2(48), 2, 42);
            const float chisel = glm::sin((uv.x * 40.0f + uv.y * 6.0f + coarse * 2.0f) * 2.0f * glm::pi<float>());
            Texel t;
            t.color = glm::mix(vec3(0.64f, 0.60f, 0.53f), vec3(0.76f, 0.725f, 0.65f), coarse) *
                      (0.93f + 0.14f * (fine - 0.5f));
            t.height = 0.9f * coarse + 0.5f * fine + 0.07f * chisel;
            t.roughness = 0.72f + 0.15f * fine;
            return t;
          }};
}

Surface planks() {
  constexpr int kRows = 8;  // boards of 25 cm
  return {512, 512, [](vec2 uv) {
            const float at = uv.y * kRows;
            const int row = static_cast<int>(at);
            const float in = at - static_cast<float>(row), edge = glm::min(in, 1.0f - in) * 0.25f;  // metres
            const float end = uv.x + cellHash(row, 0, 51), toEnd = glm::abs(end - glm::floor(end) - 0.5f) * kWoodTile;
            const float face = glm::smoothstep(0.002f, 0.010f, edge) * glm::smoothstep(0.002f, 0.008f, toEnd);
            Texel t = grain(uv * kWoodTile, kWoodTile, 60 + static_cast<std::uint32_t>(row));
            t.color *= (0.78f + 0.44f * cellHash(row, static_cast<int>(glm::floor(end + 0.5f)) & 1, 52)) *
                       (0.25f + 0.75f * face);
            t.height += 2.4f * face;
            return t;
          }};
}

Surface timber() {
  return {512, 256, [](vec2 uv) {
            Texel t = grain(uv * vec2(kWoodTile), kWoodTile, 80);
            const float crack = glm::smoothstep(0.70f, 0.78f, fbm(uv * vec2(3.0f, 24.0f), ivec2(3, 24), 3, 85));
            t.color *= 0.9f - 0.5f * crack;
            t.height -= 1.5f * crack;
            return t;
          }};
}

Surface runner() {
  return {256, 256, [](vec2 uv) {
            const float side = glm::abs(uv.x - 0.5f) * 2.0f;  // 0 middle, 1 hem
            const vec2 d = glm::abs(glm::fract(uv * vec2(2.0f, 2.0f)) - 0.5f);
            const float diamond = d.x + d.y;
            vec3 c(0.46f, 0.075f, 0.075f);
            if (side < 0.72f && diamond < 0.42f)
              c = diamond < 0.30f ? (diamond < 0.12f ? vec3(0.74f, 0.57f, 0.24f) : vec3(0.30f, 0.05f, 0.07f))
                                  : vec3(0.70f, 0.53f, 0.22f);
            if (side > 0.78f) c = side < 0.84f || side > 0.95f ? vec3(0.70f, 0.53f, 0.22f) : vec3(0.10f, 0.11f, 0.24f);
            const float weave = 0.5f + 0.25f * glm::sin(uv.x * 128.0f * glm::pi<float>()) +
                                0.25f * glm::sin(uv.y * 128.0f * glm::pi<float>());
            Texel t;
            t.color = c * (0.78f + 0.2f * weave + 0.25f * (fbm(uv * 16.0f, ivec2(16), 3, 91) - 0.3f));
            t.height = 0.7f * weave;
            t.roughness = 0.95f;
            return t;
          }};
}

Surface banner(const vec3& field, const vec3& emblem, int motif) {
  return {256, 512, [&](vec2 uv) {
            const vec2 p((uv.x - 0.5f) * 1.2f, (uv.y - 0.40f) * 2.4f);  // about the emblem, half metres
            const float r = glm::length(p), angle = glm::atan(p.y, p.x);
            bool mark = false;
            if (motif == 0) {  // a sun with sixteen rays
              mark = r < 0.15f || (r > 0.19f && r < 0.36f + 0.05f * glm::sin(angle * 8.0f) &&
                                   glm::sin(angle * 16.0f) > 0.25f * (r * 8.0f - 1.2f));
            } else {  // a ring about a cross
              mark = (r > 0.31f && r < 0.37f) || (r < 0.27f && (glm::abs(p.x) < 0.055f || glm::abs(p.y) < 0.055f));
            }
            const float hem = glm::min(glm::min(uv.x, 1.0f - uv.x), 0.5f * glm::min(uv.y, 1.0f));
            const bool border =
                (hem > 0.045f && hem < 0.075f) || glm::abs(uv.y - 0.09f) < 0.008f || glm::abs(uv.y - 0.71f) < 0.012f;
            const bool chevron = uv.y > 0.74f && glm::fract((uv.y - 0.5f * glm::abs(uv.x - 0.5f)) * 14.0f) < 0.35f;
            const float weave = 0.5f + 0.25f * glm::sin(uv.x * 128.0f * glm::pi<float>()) +
                                0.25f * glm::sin(uv.y * 256.0f * glm::pi<float>());
            Texel t;
            t.color = (mark || border || chevron ? emblem : field) *
                      (0.84f + 0.16f * weave + 0.2f * (fbm(uv * vec2(8, 16), ivec2(8, 16), 4, 95) - 0.5f));
            t.height = 0.45f * weave;
            t.roughness = 0.9f;
            return t;
          }};
}

scene::Image stainedGlass() {
  const vec3 palette[] = {{0.75f, 0.16f, 0.12f},
                          {0.13f, 0.27f, 0.72f},
                          {0.87f, 0.66f, 0.17f},
                          {0.18f, 0.52f, 0.27f},
                          {0.52f, 0.22f, 0.58f}};
  Cutout canvas(128, 512);
  canvas.paint({0, 0}, {1, 1}, [&](vec2 uv) {
    const Cellular cell = cellular(uv * vec2(4.0f, 16.0f), ivec2(4, 16), 101);
    const float lead = cell.second - cell.nearest;
    const float border = glm::min(uv.x, 1.0f - uv.x);
    if (lead < 0.09f || border < 0.03f || glm::abs(border - 0.14f) < 0.012f)
      return glm::vec4(0.10f, 0.10f, 0.11f, 1.0f);
    const vec3 c =
        border < 0.14f ? palette[static_cast<int>(uv.y * 24.0f) % 2] : palette[static_cast<int>(cell.id * 4.999f)];
    return glm::vec4(c * (0.8f + 0.4f * cellHash(static_cast<int>(cell.id * 999.0f), 7, 3)), 0.62f);
  });
  return canvas.image("stained glass", vec3(0.1f));
}

}  // namespace tyndall::levels::hall
