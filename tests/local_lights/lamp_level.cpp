#define GLM_ENABLE_EXPERIMENTAL
#include "lamp_level.hpp"

#include <stdexcept>

#include <unistd.h>
#include <glm/gtx/quaternion.hpp>

#include "scene/write_glb.hpp"

namespace tyndall::local_lights {
namespace {

scene::Primitive parallelogram(const glm::vec3& a, const glm::vec3& u, const glm::vec3& v) {
  scene::Primitive made;
  for (const glm::vec2 at : {glm::vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    scene::Vertex vertex;
    vertex.position = a + at.x * u + at.y * v;
    vertex.normal = glm::normalize(glm::cross(u, v));
    made.vertices.push_back(vertex);
    made.bounds.add(vertex.position);
  }
  made.indices = {0, 1, 2, 0, 2, 3};
  made.material = 0;
  return made;
}

/// Squares of red, green, blue, white and black; twice as wide as high for a point light.
scene::Image squares(bool wide) {
  constexpr std::uint32_t kSquare = 32;
  constexpr std::uint8_t kColours[5][3] = {{255, 40, 30}, {30, 220, 60}, {40, 60, 255}, {255, 255, 255}, {0, 0, 0}};
  scene::Image image;
  image.name = "squares";
  image.width = kSquare * (wide ? 8 : 4);
  image.height = kSquare * 4;
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const auto& colour = kColours[(x / kSquare + 3 * (y / kSquare)) % 5];
      image.rgba.insert(image.rgba.end(), {colour[0], colour[1], colour[2], 255});
    }
  return image;
}

}  // namespace

std::vector<Bar> slatsBefore(const Lamp& lamp, float ahead) {
  const glm::vec3 z = glm::normalize(lamp.towards);
  const glm::vec3 x = glm::normalize(glm::cross(z, glm::vec3(0.2f, 1, 0.1f))), y = glm::cross(x, z);
  std::vector<Bar> bars;
  for (int i = -2; i <= 2; ++i) {
    const glm::vec3 middle = lamp.position + ahead * z + 0.25f * static_cast<float>(i) * y;
    bars.push_back({middle - 0.8f * x, middle + 0.7f * x, 0.1f * y});
  }
  return bars;
}

std::vector<Bar> cage(const glm::vec3& around, float half) {
  std::vector<Bar> bars;
  for (const glm::vec3& side : {glm::vec3(1, 0, 0), glm::vec3(0, 0, 1), glm::vec3(-1, 0, 0), glm::vec3(0, 0, -1)}) {
    const glm::vec3 across(-side.z, 0, side.x);
    for (int i = 0; i < 4; ++i) {
      const glm::vec3 foot = around + half * side + half * (-0.85f + 0.45f * static_cast<float>(i)) * across;
      bars.push_back({foot - glm::vec3(0, half, 0), foot + glm::vec3(0, 1.2f * half, 0), 0.2f * half * across});
    }
  }
  return bars;
}

std::vector<Bar> roof() {
  std::vector<Bar> bars;
  for (int i = 0; i < 6; ++i) {
    const float z = -6.0f + 2 * static_cast<float>(i);
    bars.push_back({{-6, 4, z}, {6, 4, z}, {0, 0, 0.8f}});
  }
  return bars;
}

std::string writeLevel(const std::string& name, const std::vector<Lamp>& lamps, const std::vector<Bar>& bars,
                       bool shell) {
  scene::Scene level;
  level.name = name;
  scene::Material material;
  material.doubleSided = true;
  level.materials.push_back(material);
  scene::Mesh mesh{"things", {}};
  if (shell) {
    mesh.primitives.push_back(parallelogram({-12, 0, 12}, {24, 0, 0}, {0, 0, -24}));
    mesh.primitives.push_back(parallelogram({-12, 0, -12}, {24, 0, 0}, {0, 12, 0}));
  }
  for (const Bar& bar : bars) mesh.primitives.push_back(parallelogram(bar.a, bar.b - bar.a, bar.across));
  if (!mesh.primitives.empty()) {
    level.meshes.push_back(mesh);
    scene::Node things;
    things.mesh = 0;
    level.nodes.push_back(things);
  }
  level.cameras.push_back({"eye", 0.9f, 0.1f, 40.0f});
  scene::Node eye;
  eye.camera = 0;
  eye.translation = {0, 2, 8};
  level.nodes.push_back(eye);
  for (const Lamp& lamp : lamps) {
    scene::Light light;
    light.kind = lamp.kind;
    light.color = lamp.color;
    light.intensity = lamp.intensity;
    light.range = lamp.range;
    light.innerConeAngle = lamp.inner;
    light.outerConeAngle = lamp.outer;
    if (lamp.cookie) {
      light.cookie = scene::Cookie{static_cast<std::int32_t>(level.textures.size()), glm::vec2(4)};
      level.textures.push_back({static_cast<std::int32_t>(level.images.size()), {}});
      level.images.push_back(squares(lamp.kind == scene::LightKind::kPoint));
    }
    scene::Node node;
    node.light = static_cast<std::int32_t>(level.lights.size());
    node.translation = lamp.position;
    node.rotation = glm::rotation(glm::vec3(0, 0, -1), glm::normalize(lamp.towards));
    level.lights.push_back(light);
    level.nodes.push_back(node);
  }
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("tyndall-lamps-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / (name + ".glb");
  if (const auto written = scene::writeGlb(level, file); !written) throw std::runtime_error(written.error().message);
  return file.string();
}

}  // namespace tyndall::local_lights
