#include "cellar_textures.hpp"

#include <glm/gtc/constants.hpp>

#include "noise.hpp"

namespace tyndall::levels::cellar {
namespace {

using glm::ivec2;
using glm::vec2;
using glm::vec3;

}  // namespace

Surface brick() {
  constexpr int kCourses = 24, kBricks = 8;  // of 83 mm by 250 mm
  return {512, 512, [](vec2 uv) {
            const float course = uv.y * kCourses;
            const int row = static_cast<int>(course);
            const float along = uv.x * kBricks + 0.5f * static_cast<float>(row % 2);
            const int column = static_cast<int>(glm::floor(along)) % kBricks;
            const vec2 in(along - glm::floor(along), course - static_cast<float>(row));
            const float wobble = 0.004f * (fbm(uv * 48.0f, ivec2(48), 2, 201) - 0.5f);
            const vec2 toEdge = (0.5f - glm::abs(in - 0.5f)) * vec2(kBrickTile / kBricks, kBrickTile / kCourses);
            const float face = glm::smoothstep(0.004f, 0.010f, glm::min(toEdge.x, toEdge.y) + wobble);
            const float id = cellHash(column, row, 202), burnt = cellHash(column, row, 203);
            const float coarse = fbm(uv * 6.0f, ivec2(6), 4, 204), fine = fbm(uv * 64.0f, ivec2(64), 3, 205);
            const float lime = glm::smoothstep(0.56f, 0.74f, fbm(uv * 5.0f, ivec2(5), 4, 206));
            Texel t;
            vec3 c = glm::mix(vec3(0.50f, 0.27f, 0.20f), vec3(0.63f, 0.38f, 0.27f), id);
            if (burnt > 0.86f) c = vec3(0.34f, 0.235f, 0.22f);
            c *= 0.72f + 0.3f * coarse + 0.3f * (fine - 0.3f);
            c = glm::mix(c, vec3(0.66f, 0.63f, 0.58f) * (0.8f + 0.3f * fine), 0.5f * lime);
            t.color = glm::mix(vec3(0.45f, 0.42f, 0.375f) * (0.8f + 0.35f * fine), c, face);
            t.height = 2.2f * face + 0.9f * fine + 0.8f * coarse + 0.9f * id * face;
            t.roughness = 0.84f + 0.1f * (1.0f - face);
            return t;
          }};
}

Surface rubble() {
  return {
      512, 512, [](vec2 uv) {
        const vec2 bent = uv + 0.012f * vec2(fbm(uv * 12.0f, ivec2(12), 3, 211), fbm(uv * 12.0f, ivec2(12), 3, 212));
        const Cellular cell = cellular(bent * vec2(7.0f, 11.0f), ivec2(7, 11), 213);
        const float face = glm::smoothstep(0.06f, 0.22f, cell.second - cell.nearest);
        const float coarse = fbm(uv * 6.0f, ivec2(6), 5, 214), fine = fbm(uv * 64.0f, ivec2(64), 3, 215);
        const float soot = glm::smoothstep(0.45f, 0.75f, fbm(uv * 3.0f, ivec2(3), 4, 216));
        Texel t;
        const vec3 stone = glm::mix(vec3(0.45f, 0.425f, 0.39f), vec3(0.66f, 0.615f, 0.54f), cell.id);
        t.color = stone * (0.72f + 0.34f * coarse + 0.22f * (fine - 0.4f));
        t.color = glm::mix(vec3(0.50f, 0.475f, 0.43f) * (0.75f + 0.4f * fine), t.color, face) * (1.0f - 0.28f * soot);
        t.height = 4.2f * face * (0.6f + 0.4f * cell.id) + 2.0f * coarse + 1.0f * fine;
        t.roughness = 0.9f;
        return t;
      }};
}

Surface paving() {
  return {512, 512, [](vec2 uv) {
            const vec2 bent =
                uv + 0.006f * vec2(fbm(uv * 20.0f, ivec2(20), 2, 221), fbm(uv * 20.0f, ivec2(20), 2, 222));
            // Slabs in rows of unequal length.
            constexpr int kRows = 5, kSlabs = 4;
            const float at = glm::fract(bent.y + 1.0f) * kRows;
            const int row = static_cast<int>(at) % kRows;
            const auto joint = [&](int i) {
              const int k = (i % kSlabs + kSlabs) % kSlabs;
              return static_cast<float>(i) + 0.6f * cellHash(k, row, 223) + 0.37f * static_cast<float>(row);
            };
            const float x = bent.x * kSlabs;
            int slab = static_cast<int>(glm::floor(x)) - 4;
            while (joint(slab + 1) <= x) ++slab;
            const float toSide = glm::min(x - joint(slab), joint(slab + 1) - x) * kPavingTile / kSlabs;
            const float inRow = (at - glm::floor(at)) * kPavingTile / kRows;
            const float edge = glm::min(toSide, glm::min(inRow, kPavingTile / kRows - inRow));
            const float face = glm::smoothstep(0.008f, 0.030f, edge);
            const float id = cellHash((slab % kSlabs + kSlabs) % kSlabs, row, 224);
            const float coarse = fbm(uv * 7.0f, ivec2(7), 5, 225), fine = fbm(uv * 64.0f, ivec2(64), 3, 226);
            const float damp = glm::smoothstep(0.48f, 0.62f, fbm(uv * 3.0f, ivec2(3), 4, 227));
            Texel t;
            const vec3 stone = glm::mix(vec3(0.40f, 0.385f, 0.36f), vec3(0.56f, 0.53f, 0.475f), id);
            t.color = stone * (0.74f + 0.36f * coarse + 0.18f * (fine - 0.4f)) * (1.0f - 0.38f * damp);
            t.color = glm::mix(vec3(0.20f, 0.185f, 0.165f), t.color, face);
            t.height = 2.2f * face + (1.3f * coarse + 0.9f * fine + 0.5f * id) * (1.0f - 0.75f * damp);
            t.roughness = glm::mix(0.92f, glm::mix(0.80f, 0.28f, damp), face);
            return t;
          }};
}

Surface rust() {
  return {256, 256, [](vec2 uv) {
            const float coarse = fbm(uv * 5.0f, ivec2(5), 5, 231), fine = fbm(uv * 40.0f, ivec2(40), 3, 232);
            const float red = glm::smoothstep(0.42f, 0.62f, coarse + 0.25f * (fine - 0.5f));
            Texel t;
            t.color = glm::mix(vec3(0.17f, 0.165f, 0.16f), vec3(0.40f, 0.22f, 0.13f) * (0.7f + 0.6f * fine), red);
            t.height = 0.5f * coarse + (0.4f + 1.1f * red) * fine;
            t.roughness = glm::mix(0.5f, 0.9f, red);
            return t;
          }};
}

Surface sackcloth() {
  return {256, 256, [](vec2 uv) {
            const float weave = 0.5f + 0.25f * glm::sin(uv.x * 96.0f * glm::pi<float>()) +
                                0.25f * glm::sin(uv.y * 96.0f * glm::pi<float>());
            const float stain = fbm(uv * 4.0f, ivec2(4), 4, 241);
            Texel t;
            t.color = vec3(0.58f, 0.50f, 0.37f) * (0.62f + 0.25f * weave + 0.3f * stain);
            t.height = 0.9f * weave;
            t.roughness = 0.95f;
            return t;
          }};
}

namespace {

constexpr vec3 kRuby{0.90f, 0.07f, 0.10f}, kCobalt{0.10f, 0.24f, 0.95f}, kGold{1.0f, 0.76f, 0.16f},
    kEmerald{0.10f, 0.74f, 0.32f}, kViolet{0.62f, 0.16f, 0.86f}, kPale{1.0f, 0.93f, 0.74f}, kSky{0.35f, 0.66f, 1.0f};

/// One place of the rose: the glass there, the distance to the nearest lead, and the pane's number.
struct Pane {
  vec3 color;
  float toLead;
  int number;
};

/// `p`: the window's radius is 1. Twelve petals about a rosette, within a ring of roundels.
Pane rosePane(const vec2& p) {
  constexpr int kPetals = 12;
  const float r = glm::length(p), turn = glm::atan(p.y, p.x) / (2.0f * glm::pi<float>()) + 0.5f;
  const float at = turn * kPetals + 0.5f;
  const int sector = static_cast<int>(at) % kPetals;
  const float in = at - glm::floor(at), width = r * 2.0f * glm::pi<float>() / kPetals;
  const float across = (in - 0.5f) * width, toSpoke = glm::min(in, 1.0f - in) * width;
  if (r < 0.10f) return {kRuby, 0.10f - r, 0};
  if (r < 0.27f) {
    const float ring = glm::min(r - 0.10f, 0.27f - r);
    return {sector % 2 == 0 ? kGold : kPale, glm::min(ring, toSpoke), 10 + sector};
  }
  if (r < 0.69f) {
    const float k = (r - 0.27f) / 0.42f, ring = glm::min(r - 0.27f, 0.69f - r);
    const float petal = 0.46f * width * glm::pow(glm::sin(glm::pi<float>() * glm::mix(0.06f, 0.94f, k)), 0.55f);
    const float toPetal = petal - glm::abs(across);
    if (toPetal < 0) {  // spandrels, one at each end of the spoke
      return {k > 0.5f ? kEmerald : kViolet, glm::min(ring, -toPetal), 30 + sector * 2 + (k > 0.5f ? 1 : 0)};
    }
    const vec2 heart(across / (0.5f * petal), (k - 0.56f) / 0.30f);
    const float toHeart = (glm::length(heart) - 1.0f) * 0.5f * petal;
    if (toHeart < 0) return {sector % 2 == 0 ? kGold : kSky, -toHeart, 60 + sector};
    // A crossbar at the heart's middle divides the petal.
    const float toBar = glm::abs(k - 0.56f) * 0.42f;
    return {sector % 2 == 0 ? kRuby : kCobalt, glm::min(glm::min(ring, toPetal), glm::min(toHeart, toBar)),
            80 + sector * 2 + (k > 0.56f ? 1 : 0)};
  }
  if (r < 0.95f) {
    constexpr int kRoundels = 24;
    const float ring = glm::min(r - 0.69f, 0.95f - r), step = 2.0f * glm::pi<float>() / kRoundels;
    const float around = turn * kRoundels;
    const int roundel = static_cast<int>(around) % kRoundels;
    const float angle = (static_cast<float>(roundel) + 0.5f) * step - glm::pi<float>();
    const float far = glm::length(p - 0.82f * vec2(glm::cos(angle), glm::sin(angle)));
    if (far < 0.045f) return {roundel % 2 == 0 ? kRuby : kPale, 0.045f - far, 120 + roundel};
    if (far < 0.092f) return {roundel % 2 == 0 ? kGold : kEmerald, glm::min(far - 0.045f, 0.092f - far), 150 + roundel};
    const float toRay = glm::abs(around - glm::floor(around + 0.5f)) * step * r;  // between neighbouring roundels
    return {r > 0.82f ? kCobalt : kViolet, glm::min(glm::min(ring, far - 0.092f), toRay),
            180 + roundel * 2 + (r > 0.82f ? 1 : 0)};
  }
  return {vec3(0), 0, 0};
}

}  // namespace

scene::Image roseWindow() {
  constexpr float kLead = 0.0075f;  // half the width of the cames, of the window's radius
  Cutout canvas(768, 768);
  canvas.paint({0, 0}, {1, 1}, [](vec2 uv) {
    const Pane pane = rosePane(uv * 2.0f - 1.0f);
    if (pane.toLead < kLead) return glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
    const float tone = 0.72f + 0.36f * cellHash(pane.number, 1, 251);  // no two sheets are alike
    const float streak = 0.86f + 0.28f * valueNoise(uv * vec2(24.0f, 60.0f), ivec2(24, 60), 252);
    const float grime = glm::smoothstep(kLead, 4.0f * kLead, pane.toLead);  // dirt gathers along the lead
    return glm::vec4(pane.color * tone * streak * (0.72f + 0.28f * grime), 0.80f);
  });
  return canvas.image("rose window", vec3(0));
}

}  // namespace tyndall::levels::cellar
