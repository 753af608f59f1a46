#define GLM_ENABLE_EXPERIMENTAL
#include "pictures.hpp"

#include <glm/gtx/quaternion.hpp>

#include "scene/write_glb.hpp"

namespace tyndall::quality {

image::FloatImage QualityTest::read(const std::string& name) const {
  auto picture = image::readExr(folder_ / name);
  EXPECT_TRUE(picture) << (picture ? "" : picture.error().message);
  return picture ? picture.take() : image::FloatImage{};
}

image::FloatImage QualityTest::scatter(const std::string& level, const Arguments& settings) const {
  Arguments call = {"render", level, "--size", "320x180", "--scatter", "s.exr"};
  for (const std::string& setting : settings) call.insert(call.end(), {"--set", setting});
  const cli::Outcome outcome = tyndall(call);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return read("s.exr");
}

image::FloatImage QualityTest::distance(const std::string& level) const {
  const cli::Outcome outcome =
      tyndall({"render", level, "--size", "320x180", "--depth", "d.exr", "--set", "volumetrics.technique=none"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return read("d.exr");
}

image::FloatImage QualityTest::truth(const std::string& level, int samples) const {
  const cli::Outcome outcome =
      tyndall({"truth", level, "--size", "320x180", "--samples", std::to_string(samples), "--out", "t.exr"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return read("t.exr");
}

std::string QualityTest::writeLevel(const std::string& name, const std::vector<scene::Primitive>& primitives,
                                    const glm::vec3& sunTravels, const scene::Camera& lens) const {
  scene::Scene level;
  level.name = name;
  scene::Material material;
  material.doubleSided = true;
  level.materials.push_back(material);
  level.meshes.push_back({"things", primitives});
  level.cameras.push_back(lens);
  scene::Light sun;
  sun.intensity = 8;
  level.lights.push_back(sun);
  scene::Node things, eye, lamp;
  things.mesh = 0;
  eye.camera = 0;
  eye.translation = {0, 2, 10};
  lamp.light = 0;
  const glm::vec3 d = glm::normalize(sunTravels);
  lamp.rotation = glm::rotation(glm::vec3(0, 0, -1), d);
  level.nodes = {things, eye, lamp};
  const auto written = scene::writeGlb(level, folder_ / (name + ".glb"));
  EXPECT_TRUE(written) << (written ? "" : written.error().message);
  return name + ".glb";
}

double nRmse(const image::FloatImage& picture, const image::FloatImage& reference) {
  const auto metrics = image::compare(picture, reference);
  EXPECT_TRUE(metrics) << (metrics ? "" : metrics.error().message);
  return metrics ? metrics->nRmse : 1e9;
}

scene::Primitive plate(float x0, float x1, float z0, float z1, float y) {
  scene::Primitive made;
  for (const auto& [x, z] : {std::pair{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}}) {
    scene::Vertex v;
    v.position = {x, y, z};
    v.normal = {0, 1, 0};
    made.vertices.push_back(v);
    made.bounds.add(v.position);
  }
  made.indices = {0, 2, 1, 0, 3, 2};
  made.material = 0;
  return made;
}

}  // namespace tyndall::quality
