// The forest's tileable surfaces.
#include <glm/gtc/constants.hpp>

#include "forest_textures.hpp"
#include "noise.hpp"

namespace tyndall::levels::forest {

using glm::ivec2;
using glm::vec2;
using glm::vec3;

Surface litter() {
  return {512, 512, [](vec2 uv) {
            const float patches = fbm(uv * 4.0f, ivec2(4), 5, 11), fine = fbm(uv * 64.0f, ivec2(64), 3, 12);
            const vec2 bent = uv + 0.012f * vec2(fbm(uv * 16.0f, ivec2(16), 2, 13), fbm(uv * 16.0f, ivec2(16), 2, 14));
            const Cellular leaf = cellular(bent * 44.0f, ivec2(44), 15);
            const float rim = glm::smoothstep(0.02f, 0.16f, leaf.second - leaf.nearest);
            const float fallen =
                glm::smoothstep(0.45f, 0.6f, patches + 0.45f * (leaf.id - 0.5f));  // leaves here, moss elsewhere
            const vec3 soil = glm::mix(vec3(0.20f, 0.15f, 0.10f), vec3(0.30f, 0.235f, 0.16f), fine);
            const vec3 moss = glm::mix(vec3(0.17f, 0.215f, 0.075f), vec3(0.33f, 0.37f, 0.13f), fine);
            const vec3 dry =
                glm::mix(vec3(0.33f, 0.235f, 0.135f), vec3(0.47f, 0.365f, 0.225f), leaf.id) * (0.75f + 0.5f * fine);
            const vec3 under = glm::mix(moss, soil, glm::smoothstep(0.48f, 0.62f, fbm(uv * 8.0f, ivec2(8), 4, 17)));
            Texel t;
            t.color = glm::mix(under, dry, fallen * (0.35f + 0.65f * rim)) * (0.82f + 0.36f * patches);
            t.height = 2.0f * patches + 1.4f * fine + fallen * (1.3f * rim + 1.2f * leaf.id);
            t.roughness = 0.93f;
            return t;
          }};
}

Surface roughBark() {
  return {256, 512, [](vec2 uv) {
            const float drift = fbm(uv * vec2(4, 4), ivec2(4, 4), 3, 21) - 0.5f;
            const vec2 p = vec2(uv.x + 0.05f * drift, uv.y) * vec2(11.0f, 6.0f);
            const Cellular plate = cellular(p, ivec2(11, 6), 22);
            const float ridge = glm::smoothstep(0.03f, 0.42f, plate.second - plate.nearest);
            const float fibre = fbm(uv * vec2(48, 10), ivec2(48, 10), 4, 23), stain = fbm(uv * 5.0f, ivec2(5), 4, 24);
            Texel t;
            t.color =
                glm::mix(vec3(0.15f, 0.115f, 0.085f), vec3(0.40f, 0.335f, 0.27f), ridge * (0.45f + 0.55f * fibre));
            t.color = glm::mix(t.color, vec3(0.30f, 0.34f, 0.17f) * (0.6f + 0.6f * fibre),
                               0.6f * glm::smoothstep(0.52f, 0.72f, stain));  // algae
            t.height = 4.5f * ridge + 1.8f * fibre;
            t.roughness = 0.9f;
            return t;
          }};
}

Surface birchBark() {
  return {256, 512, [](vec2 uv) {
            const float fine = fbm(uv * vec2(8, 64), ivec2(8, 64), 3, 31);
            const Cellular mark = cellular(uv * vec2(4, 22), ivec2(4, 22), 32);
            const float scar = (1.0f - glm::smoothstep(0.16f, 0.3f, mark.nearest)) * glm::step(0.35f, mark.id);
            const float rough = glm::smoothstep(0.58f, 0.7f, fbm(uv * vec2(4, 5), ivec2(4, 5), 4, 33));
            Texel t;
            t.color = glm::mix(vec3(0.66f, 0.62f, 0.55f), vec3(0.83f, 0.80f, 0.74f), fine);
            t.color =
                glm::mix(t.color, vec3(0.13f, 0.115f, 0.10f), glm::clamp(0.9f * scar + 0.85f * rough, 0.0f, 0.95f));
            t.height = 0.7f * fine - 1.2f * scar + 1.6f * rough * fine;
            t.roughness = 0.75f;
            return t;
          }};
}

Surface rock() {
  return {256, 256, [](vec2 uv) {
            const float coarse = fbm(uv * 6.0f, ivec2(6), 6, 41), fine = fbm(uv * 48.0f, ivec2(48), 2, 42);
            const float crack = glm::smoothstep(0.0f, 0.07f, glm::abs(fbm(uv * 4.0f, ivec2(4), 4, 43) - 0.5f));
            const float moss = glm::smoothstep(0.5f, 0.66f, fbm(uv * 5.0f, ivec2(5), 5, 44));
            Texel t;
            t.color = glm::mix(vec3(0.34f, 0.33f, 0.31f), vec3(0.58f, 0.56f, 0.52f), coarse) * (0.6f + 0.4f * crack) *
                      (0.85f + 0.3f * fine);
            t.color = glm::mix(t.color, vec3(0.26f, 0.31f, 0.11f) * (0.6f + 0.8f * fine), 0.8f * moss);
            t.height = 3.2f * coarse + 0.9f * fine + 1.6f * crack + 0.8f * moss;
            t.roughness = 0.88f;
            return t;
          }};
}

Surface planks() {
  return {256, 256, [](vec2 uv) {
            const float drift = fbm(uv * vec2(2, 10), ivec2(2, 10), 3, 51),
                        fibre = fbm(uv * vec2(8, 96), ivec2(8, 96), 3, 52);
            const float crack = glm::smoothstep(0.66f, 0.76f, fbm(uv * vec2(3, 30), ivec2(3, 30), 3, 53));
            const float green = glm::smoothstep(0.5f, 0.75f, fbm(uv * 4.0f, ivec2(4), 4, 54));
            Texel t;
            t.color = glm::mix(vec3(0.27f, 0.235f, 0.20f), vec3(0.53f, 0.485f, 0.42f), 0.55f * fibre + 0.45f * drift);
            t.color = glm::mix(t.color, vec3(0.27f, 0.30f, 0.14f), 0.45f * green) * (1.0f - 0.6f * crack);
            t.height = 1.6f * fibre - 2.0f * crack;
            t.roughness = 0.88f;
            return t;
          }};
}

}  // namespace tyndall::levels::forest
