#include "lattice_textures.hpp"

#include <glm/gtc/constants.hpp>

#include "noise.hpp"

namespace tyndall::levels::lattice {
namespace {

using glm::ivec2;
using glm::vec2;
using glm::vec3;

}  // namespace

Surface concrete() {
  return {512, 512, [](vec2 uv) {
            const float coarse = fbm(uv * 4.0f, ivec2(4), 5, 601), fine = fbm(uv * 80.0f, ivec2(80), 3, 602);
            const Cellular slab = cellular(uv * 5.0f + 0.2f * vec2(fbm(uv * 16.0f, ivec2(16), 3, 603)), ivec2(5), 604);
            const float crack = 1.0f - glm::smoothstep(0.0f, 0.012f, slab.second - slab.nearest);
            const vec2 edge = glm::abs(glm::fract(uv + 0.5f) - 0.5f);
            const float joint = 1.0f - glm::smoothstep(0.002f, 0.004f, glm::min(edge.x, edge.y));
            const float oil = glm::smoothstep(0.58f, 0.70f, fbm(uv * 5.0f, ivec2(5), 4, 605));
            const float damp = glm::smoothstep(0.44f, 0.60f, fbm(uv * 3.0f, ivec2(3), 4, 606));
            Texel t;
            t.color = vec3(0.44f, 0.42f, 0.395f) * (0.72f + 0.34f * coarse + 0.2f * (fine - 0.4f));
            t.color *= (1.0f - 0.30f * damp) * (1.0f - 0.55f * oil);
            t.color =
                glm::mix(t.color, vec3(0.10f, 0.095f, 0.09f), glm::max(0.7f * crack * glm::step(0.4f, slab.id), joint));
            t.height = 1.2f * coarse + 1.0f * fine * (1.0f - 0.8f * damp) - 1.6f * glm::max(crack, joint);
            t.roughness = glm::mix(0.92f, 0.30f, glm::max(0.8f * damp, oil));
            return t;
          }};
}

Surface sheet() {
  constexpr float kRibs = 14.0f;
  return {512, 512, [](vec2 uv) {
            const float rib = 0.5f + 0.5f * glm::cos(uv.x * kRibs * 2.0f * glm::pi<float>());
            const float coarse = fbm(uv * 5.0f, ivec2(5), 5, 611), fine = fbm(uv * 64.0f, ivec2(64), 3, 612);
            const float run = fbm(uv * vec2(40.0f, 3.0f), ivec2(40, 3), 3, 613);
            const float lap = glm::smoothstep(0.35f, 0.5f, glm::abs(uv.y - 0.5f));
            const float red = glm::smoothstep(0.52f, 0.68f, 0.55f * coarse + 0.3f * run + 0.25f * lap + 0.1f * fine);
            Texel t;
            t.color = glm::mix(vec3(0.36f, 0.385f, 0.39f) * (0.8f + 0.3f * coarse),
                               vec3(0.40f, 0.22f, 0.13f) * (0.65f + 0.6f * fine), red);
            t.height = 10.0f * rib + 0.8f * fine * red;
            t.roughness = glm::mix(0.55f, 0.92f, red);
            return t;
          }};
}

scene::Image chainLink() {
  constexpr float kWire = 0.05f;  // half its thickness, in diamonds
  Cutout canvas(256, 256);
  canvas.paint({0, 0}, {1, 1}, [](vec2 uv) {
    const vec2 p = uv * static_cast<float>(kDiamonds);
    const float a = glm::abs(glm::fract(p.x + p.y) - 0.5f), c = glm::abs(glm::fract(p.x - p.y) - 0.5f);
    const float off = glm::min(a, c) * glm::one_over_root_two<float>();
    if (off > kWire) return glm::vec4(0);
    const float round = glm::sqrt(1.0f - off * off / (kWire * kWire));
    return glm::vec4(vec3(0.52f, 0.53f, 0.53f) * (0.45f + 0.55f * round) * (a < c ? 1.0f : 0.85f), 1);
  });
  return canvas.image("chain link", vec3(0.4f));
}

}  // namespace tyndall::levels::lattice
