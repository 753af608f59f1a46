// rectification=linear while a camera turns until the sun comes on the screen, past its edge and past its corner: the
// error against the dense march stays bounded and does not jump from step to step, whatever the technique and the
// number of maps. Its own map, at the end, has one column and slices a degree wide.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "laboratory.hpp"
#include "scene/write_glb.hpp"

namespace tyndall::figures {
namespace {

/// A yard with rows of posts, the sun low along -Z, a camera at eye height.
std::filesystem::path makeYard() {
  scene::Scene level;
  level.name = "yard";
  scene::Material material;
  material.doubleSided = true;
  level.materials.push_back(material);
  scene::Primitive things;
  const auto box = [&](const glm::vec3& low, const glm::vec3& high) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 2; ++side) {
        const auto first = static_cast<std::uint32_t>(things.vertices.size());
        for (int corner = 0; corner < 4; ++corner) {
          scene::Vertex vertex;
          glm::vec3 share(0);
          share[axis] = static_cast<float>(side);
          share[(axis + 1) % 3] = static_cast<float>(corner == 1 || corner == 2);
          share[(axis + 2) % 3] = static_cast<float>(corner >= 2);
          vertex.position = glm::mix(low, high, share);
          vertex.normal = glm::vec3(0);
          vertex.normal[axis] = side ? 1.0f : -1.0f;
          things.vertices.push_back(vertex);
        }
        for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) things.indices.push_back(first + i);
      }
    }
  };
  box({-30, -1.2f, -60}, {30, -1, 5});
  for (int row = 0; row < 4; ++row)
    for (int post = 0; post < 7; ++post) {
      const float x = 3.0f * static_cast<float>(post - 3) + 0.7f * static_cast<float>(row),
                  z = -8.0f - 9.0f * static_cast<float>(row);
      box({x, -1, z}, {x + 0.6f, 3.5f, z + 0.6f});
    }
  level.meshes.push_back({"things", {things}});
  level.cameras.push_back({"eye", 1.0471976f, 0.1f, 200.0f});
  scene::Light sun;
  sun.intensity = 4;
  level.lights.push_back(sun);
  scene::Node yard, eye, lamp;
  yard.mesh = 0;
  eye.camera = 0;
  lamp.light = 0;
  lamp.rotation = glm::quat(0, 0, 1, 0);  // shines along +Z
  level.nodes = {yard, eye, lamp};
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "tyndall_yard.glb";
  if (auto written = scene::writeGlb(level, file); !written) throw std::runtime_error(written.error().message);
  return file;
}

TEST(Linear, NearItsSingularityItHandsOver) {
  const std::filesystem::path file = makeYard();
  Laboratory lab(file.string(), 0, 80, 45);
  std::filesystem::remove(file);
  const Settings small = {"volumetrics.columns=512", "volumetrics.slices=512", "volumetrics.prefix_scheme=row",
                          "shadows.resolution=1024"};
  for (const host::TechniqueInfo& technique : lab.session().catalogue().effectPlugin().techniques()) {
    if (std::find(technique.reads.begin(), technique.reads.end(), "volumetrics.rectification") == technique.reads.end())
      continue;
    for (const char* splits : {"1", "4"}) {
      const auto error = [&](float yaw, float pitch, const char* rectification) {
        lab.pose({{0, 1, 1}, yaw, pitch});
        const image::FloatImage march =
            lab.shoot(small + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=512"}).scatter;
        return errorOf(lab.shoot(small + Settings{"volumetrics.technique=" + technique.id,
                                                  std::string("volumetrics.rectification=") + rectification,
                                                  std::string("volumetrics.splits=") + splits})
                           .scatter,
                       march)
            .nRmse;
      };
      // The sun passes the screen's edge at a yaw of 45.7 degrees, its corner at about pitch 29.
      for (const float pitch : {10.0f, 29.0f}) {
        const double apart = error(-65, pitch, "linear");
        double before = -1;
        for (const float yaw : {-49.0f, -47.0f, -46.05f, -46.0f, -45.75f, -45.7f, -45.65f, -45.0f}) {
          const double now = error(yaw, pitch, "linear");
          const double bound = std::max(apart, error(yaw, pitch, "epipolar")) + 0.05;
          EXPECT_LT(now, bound) << technique.id << " splits " << splits << " yaw " << yaw << " pitch " << pitch;
          if (before >= 0) {
            EXPECT_LT(std::abs(now - before), 0.04) << technique.id << " splits " << splits << " yaw " << yaw;
          }
          before = now;
        }
      }
    }
  }
}

}  // namespace
}  // namespace tyndall::figures
