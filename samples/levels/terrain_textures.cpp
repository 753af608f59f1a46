// What the dale alone is made of.
#include "noise.hpp"
#include "random.hpp"
#include "terrain_parts.hpp"

namespace tyndall::levels::terrain {

Surface heath() {
  return {512, 512, [](glm::vec2 uv) {
            const float patches = fbm(uv * 5.0f, glm::ivec2(5), 5, 301), fine = fbm(uv * 72.0f, glm::ivec2(72), 3, 302);
            const glm::vec2 bent = uv + 0.02f * glm::vec2(fbm(uv * 9.0f, glm::ivec2(9), 2, 303), patches);
            const float blades = fbm(bent * glm::vec2(110, 40), glm::ivec2(110, 40), 2, 304);
            const Cellular pebble = cellular(uv * 40.0f, glm::ivec2(40), 305);
            const float stone = (1.0f - glm::smoothstep(0.22f, 0.34f, pebble.nearest)) * glm::step(0.78f, pebble.id);
            Texel t;
            t.color = glm::vec3(0.70f + 0.62f * (blades - 0.5f) + 0.50f * (fine - 0.5f) + 0.40f * (patches - 0.5f));
            t.color = glm::mix(t.color, glm::vec3(0.82f, 0.80f, 0.78f) * (0.7f + 0.4f * fine), 0.7f * stone);
            t.height = 2.4f * patches + 1.6f * blades + 1.0f * fine + 1.2f * stone;
            t.roughness = 0.95f;
            return t;
          }};
}

scene::Image dryGrass() {
  Cutout canvas(256, 256);
  Random random(15);
  for (int i = 0; i < 64; ++i) {  // blades, back to front
    const float x0 = random.range(0.22f, 0.78f), lean = random.range(-0.34f, 0.34f), high = random.range(0.35f, 0.97f),
                width = random.range(0.009f, 0.016f);
    const glm::vec3 color = glm::mix(glm::vec3(0.52f, 0.50f, 0.24f), glm::vec3(0.86f, 0.75f, 0.47f), random.unit());
    canvas.paint({glm::max(0.0f, x0 - 0.4f), 1.0f - high}, {glm::min(1.0f, x0 + 0.4f), 1.0f}, [&](glm::vec2 uv) {
      const float up = (1.0f - uv.y) / high, off = glm::abs(uv.x - (x0 + lean * up * up));
      const float w = width * (1.0f - up * up);
      return up > 1.0f || off > w ? glm::vec4(0) : glm::vec4(color * (0.65f + 0.4f * up), 1);
    });
  }
  return canvas.image("dry grass", {0.68f, 0.60f, 0.35f});
}

}  // namespace tyndall::levels::terrain
