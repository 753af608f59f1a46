#include "noise.hpp"
#include "tower_parts.hpp"

namespace tyndall::levels::tower {

using glm::ivec2;
using glm::vec2;
using glm::vec3;

Surface slates() {
  constexpr int kRows = 12, kColumns = 10;
  return {512, 512, [](vec2 uv) {
            const float at = uv.y * kRows;
            const int row = static_cast<int>(at);
            const float along = uv.x * kColumns + 0.5f * static_cast<float>(row % 2) + 10.0f;
            const int column = static_cast<int>(along) % kColumns;
            const vec2 in(glm::fract(along), at - static_cast<float>(row));  // v down the slope: 1 at the lower edge
            const float id = cellHash(column, row, 401), chip = 0.10f * cellHash(column, row, 402);
            const float side = glm::smoothstep(0.02f, 0.06f, 0.5f - glm::abs(in.x - 0.5f));
            const float lip = 1.0f - glm::smoothstep(0.90f - chip, 0.96f - chip, in.y);
            const float fine = fbm(uv * 60.0f, ivec2(60), 3, 403), coarse = fbm(uv * 5.0f, ivec2(5), 4, 404);
            const float lichen = glm::smoothstep(0.60f, 0.74f, fbm(uv * 9.0f, ivec2(9), 4, 405));
            Texel t;
            t.color = glm::mix(vec3(0.27f, 0.27f, 0.30f), vec3(0.43f, 0.40f, 0.40f), id) *
                      (0.75f + 0.3f * fine + 0.2f * coarse);
            t.color = glm::mix(t.color, vec3(0.46f, 0.46f, 0.28f), 0.6f * lichen) * (0.35f + 0.65f * side * lip);
            t.height = 2.0f * side * lip + 2.4f * in.y * lip + 0.7f * fine + 0.6f * id;
            t.roughness = 0.72f + 0.2f * lichen;
            return t;
          }};
}

Surface plaster() {
  return {
      512, 512, [](vec2 uv) {
        const float coarse = fbm(uv * 4.0f, ivec2(4), 5, 411), fine = fbm(uv * 80.0f, ivec2(80), 3, 412);
        const float damp = glm::smoothstep(0.50f, 0.72f, fbm(uv * vec2(6, 3), ivec2(6, 3), 4, 413));
        const float crack = 1.0f - glm::smoothstep(0.0f, 0.018f, glm::abs(fbm(uv * 5.0f, ivec2(5), 5, 414) - 0.5f));
        const float off = glm::smoothstep(0.70f, 0.73f, fbm(uv * 6.0f, ivec2(6), 5, 415));  // fallen: the bricks show
        const vec2 brick = glm::fract(uv * vec2(12, 36) + vec2(0.5f * glm::floor(uv.y * 36.0f), 0));
        const float joint = brick.x < 0.06f || brick.y < 0.14f ? 0.0f : 1.0f;
        Texel t;
        t.color = vec3(0.78f, 0.72f, 0.61f) * (0.80f + 0.22f * coarse + 0.12f * (fine - 0.5f)) * (1.0f - 0.30f * damp) *
                  (1.0f - 0.35f * crack);
        t.color = glm::mix(
            t.color, glm::mix(vec3(0.60f, 0.56f, 0.50f), vec3(0.56f, 0.42f, 0.34f), joint) * (0.8f + 0.4f * fine), off);
        t.height = 1.4f * coarse + 0.8f * fine - 1.2f * crack - off * (2.5f - joint);
        t.roughness = 0.9f;
        return t;
      }};
}

}  // namespace tyndall::levels::tower
