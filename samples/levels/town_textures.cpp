#include "town_textures.hpp"

#include <glm/gtc/constants.hpp>

#include "noise.hpp"

namespace tyndall::levels::town {
namespace {

using glm::ivec2;
using glm::vec2;
using glm::vec3;

}  // namespace

Surface cobbles() {
  constexpr int kRows = 16, kStones = 12;
  return {
      512, 512, [](vec2 uv) {
        const vec2 bent = uv + 0.008f * vec2(fbm(uv * 14.0f, ivec2(14), 2, 501), fbm(uv * 14.0f, ivec2(14), 2, 502));
        const float course = glm::fract(bent.y + 1.0f) * kRows;
        const int row = static_cast<int>(course) % kRows;
        const float along = glm::fract(bent.x + 1.0f) * kStones + 0.5f * static_cast<float>(row % 2);
        const int column = static_cast<int>(glm::floor(along)) % kStones;
        const vec2 in = vec2(along - glm::floor(along), course - glm::floor(course)) * 2.0f - 1.0f;
        const float id = cellHash(column, row, 503), tilt = cellHash(column, row, 504) - 0.5f;
        // A stone's top is a pillow: superellipse, worn round.
        const float r = glm::pow(glm::abs(in.x), 3.5f) + glm::pow(glm::abs(in.y), 3.5f);
        const float dome = glm::sqrt(glm::max(0.0f, 1.0f - 0.95f * r));
        const float face = glm::smoothstep(0.12f, 0.45f, dome);
        const float coarse = fbm(uv * 5.0f, ivec2(5), 4, 505), fine = fbm(uv * 80.0f, ivec2(80), 3, 506);
        const float wet = glm::smoothstep(0.40f, 0.62f, fbm(uv * 3.0f, ivec2(3), 4, 507));
        Texel t;
        const vec3 stone = glm::mix(vec3(0.27f, 0.265f, 0.27f), vec3(0.40f, 0.375f, 0.345f), id);
        t.color = glm::mix(vec3(0.12f, 0.11f, 0.10f), stone * (0.75f + 0.3f * coarse + 0.25f * (fine - 0.4f)), face);
        t.color *= 1.0f - 0.3f * wet;
        t.height = 7.0f * dome + 3.0f * tilt * in.x * face + (0.9f * fine) * (1.0f - 0.7f * wet);
        t.roughness = glm::mix(0.95f, glm::mix(0.62f, 0.24f, wet), face);
        return t;
      }};
}

Surface plaster() {
  return {512, 512, [](vec2 uv) {
            const float coarse = fbm(uv * 4.0f, ivec2(4), 5, 511), fine = fbm(uv * 60.0f, ivec2(60), 3, 512);
            const float streak = fbm(uv * vec2(24.0f, 3.0f), ivec2(24, 3), 3, 513);  // rain runs down
            const float bare = glm::smoothstep(0.60f, 0.64f, fbm(uv * 6.0f, ivec2(6), 5, 514));
            Texel t;
            t.color = vec3(0.70f) * (0.70f + 0.34f * coarse + 0.14f * (fine - 0.4f)) * (1.0f - 0.30f * streak * coarse);
            t.color = glm::mix(t.color, vec3(0.40f, 0.35f, 0.30f) * (0.7f + 0.5f * fine), bare);
            t.height = 1.6f * (1.0f - bare) + 0.9f * fine + 0.9f * coarse;
            t.roughness = 0.9f;
            return t;
          }};
}

Surface tiles() {
  constexpr int kRows = 10, kTiles = 9;
  return {512, 512, [](vec2 uv) {
            const float course = uv.y * kRows;
            const int row = static_cast<int>(course);
            const float along = uv.x * kTiles + 0.5f * static_cast<float>(row % 2);
            const int column = static_cast<int>(glm::floor(along)) % kTiles;
            const vec2 in(along - glm::floor(along), course - static_cast<float>(row));
            const float id = cellHash(column, row, 521), fine = fbm(uv * 48.0f, ivec2(48), 3, 522);
            const float moss = glm::smoothstep(0.55f, 0.72f, fbm(uv * 5.0f, ivec2(5), 4, 523));
            const float gap =
                glm::smoothstep(0.02f, 0.06f, glm::min(in.x, 1.0f - in.x)) * glm::smoothstep(0.0f, 0.08f, 1.0f - in.y);
            Texel t;
            t.color = glm::mix(vec3(0.30f, 0.20f, 0.17f), vec3(0.44f, 0.28f, 0.22f), id) * (0.7f + 0.5f * fine);
            t.color = glm::mix(t.color, vec3(0.20f, 0.21f, 0.14f), 0.6f * moss) * (0.35f + 0.65f * gap);
            t.height = gap * (3.0f * in.y + 1.5f * id) + fine;  // each row lies upon the next one down
            t.roughness = 0.82f;
            return t;
          }};
}

Surface stripes() {
  return {256, 256, [](vec2 uv) {
            const float weave =
                0.5f + 0.5f * glm::sin(uv.x * 128.0f * glm::pi<float>()) * glm::sin(uv.y * 128.0f * glm::pi<float>());
            const float stain = fbm(uv * 4.0f, ivec2(4), 4, 531);
            const float stripe = glm::smoothstep(-0.04f, 0.04f, glm::sin(uv.x * 8.0f * glm::pi<float>()));
            Texel t;
            t.color = glm::mix(vec3(0.52f, 0.13f, 0.11f), vec3(0.78f, 0.73f, 0.62f), stripe);
            t.color *= 0.65f + 0.1f * weave + 0.4f * stain;
            t.height = 0.5f * weave;
            t.roughness = 0.95f;
            return t;
          }};
}

scene::Image leadedWindow() {
  constexpr float kAcross = 14.0f, kLead = 0.055f;  // diamonds over the image; half the lead's width, of a diamond
  Cutout canvas(512, 512);
  canvas.paint({0, 0}, {1, 1}, [](vec2 uv) {
    const vec2 p = uv * kAcross, d(p.x + 0.62f * p.y, p.x - 0.62f * p.y);
    const vec2 cell = glm::floor(d), in = glm::abs(d - cell - 0.5f);
    const vec2 frame = glm::abs(glm::fract(uv * 4.0f + 0.5f) - 0.5f);  // the casement's bars, every quarter
    if (glm::max(in.x, in.y) > 0.5f - kLead || glm::min(frame.x, frame.y) < 0.035f) return glm::vec4(0, 0, 0, 1);
    const int x = static_cast<int>(cell.x), y = static_cast<int>(cell.y);
    const float tone = 0.45f + 0.55f * cellHash(x, y, 541), kind = cellHash(x, y, 542);
    vec3 color = glm::mix(vec3(1.0f, 0.80f, 0.48f), vec3(1.0f, 0.90f, 0.70f), cellHash(x, y, 543));
    if (kind > 0.86f) color = vec3(0.95f, 0.42f, 0.22f);
    if (kind < 0.09f) color = vec3(0.45f, 0.72f, 0.62f);
    return glm::vec4(color * tone, 0.8f);
  });
  return canvas.image("leaded window", vec3(0));
}

scene::Image panedWindow() {
  Cutout canvas(512, 512);
  canvas.paint({0, 0}, {1, 1}, [](vec2 uv) {
    const vec2 cell = uv * vec2(8.0f, 7.0f), in = glm::abs(glm::fract(cell) - 0.5f);
    if (in.x > 0.41f || in.y > 0.43f) return glm::vec4(0, 0, 0, 1);
    const float fold = 0.5f + 0.5f * glm::sin(uv.x * 150.0f);
    const float off = glm::abs(uv.x - 0.5f) + 0.05f * glm::sin(uv.y * 9.0f);
    const float curtain = glm::smoothstep(0.155f, 0.175f, off);
    const vec3 glass = vec3(1.0f, 0.86f, 0.62f) * (0.9f + 0.1f * valueNoise(uv * 30.0f, ivec2(30), 551));
    return glm::vec4(glm::mix(glass, vec3(0.42f, 0.11f, 0.06f) * (0.4f + 0.6f * fold), curtain), 0.8f);
  });
  return canvas.image("paned window", vec3(0));
}

}  // namespace tyndall::levels::town
