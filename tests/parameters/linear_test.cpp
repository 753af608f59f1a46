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
  // The sun passes the screen's edge at a yaw of 45.7 degrees, its corner at about pitch 29. The first pose of each
  // pitch is far from both.
  struct Pose {
    float yaw, pitch;
  };
  std::vector<Pose> poses;
  constexpr float kYaws[] = {-65.0f, -49.0f, -47.0f, -46.05f, -46.0f, -45.75f, -45.7f, -45.65f, -45.0f};
  for (const float pitch : {10.0f, 29.0f})
    for (const float yaw : kYaws) poses.push_back({yaw, pitch});
  // One layout after the other, each over all poses: a change of layout makes pipelines, which takes longer than a
  // frame.
  const auto pictures = [&](const Settings& settings) {
    std::vector<image::FloatImage> all;
    for (const Pose& pose : poses) {
      lab.pose({{0, 1, 1}, pose.yaw, pose.pitch});
      all.push_back(lab.shoot(small + settings).scatter);
    }
    return all;
  };
  const std::vector<image::FloatImage> marches = pictures({"volumetrics.technique=ray_march", "volumetrics.steps=512"});
  const auto errors = [&](const Settings& settings) {
    const std::vector<image::FloatImage> all = pictures(settings);
    std::vector<double> of;
    for (std::size_t i = 0; i < all.size(); ++i) of.push_back(errorOf(all[i], marches[i]).nRmse);
    return of;
  };
  for (const host::TechniqueInfo& technique : lab.session().catalogue().effectPlugin().techniques()) {
    if (std::find(technique.reads.begin(), technique.reads.end(), "volumetrics.rectification") == technique.reads.end())
      continue;
    const Settings chosen = {"volumetrics.technique=" + technique.id};
    for (const char* splits : {"1", "4"}) {
      const Settings split = chosen + Settings{std::string("volumetrics.splits=") + splits};
      const std::vector<double> epipolar = errors(split + Settings{"volumetrics.rectification=epipolar"}),
                                linear = errors(split + Settings{"volumetrics.rectification=linear"});
      double apart = 0;
      for (std::size_t i = 0; i < poses.size(); ++i) {
        const bool far = i % std::size(kYaws) == 0;
        if (far) {
          apart = linear[i];
          continue;
        }
        EXPECT_LT(linear[i], std::max(apart, epipolar[i]) + 0.05)
            << technique.id << " splits " << splits << " yaw " << poses[i].yaw << " pitch " << poses[i].pitch;
        if (i % std::size(kYaws) > 1) {
          EXPECT_LT(std::abs(linear[i] - linear[i - 1]), 0.04)
              << technique.id << " splits " << splits << " yaw " << poses[i].yaw;
        }
      }
    }
  }
}

}  // namespace
}  // namespace tyndall::figures
