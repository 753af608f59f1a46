// A device with validation, a renderer, and everything a frame gives read back.
#pragma once

#include <optional>

#include <gtest/gtest.h>

#include "level.hpp"
#include "render/frame.hpp"

namespace tyndall::render::test {

struct Shot {
  std::uint32_t width = 0, height = 0;
  std::vector<glm::vec4> color;  ///< radiance before the medium
  std::vector<float> distance;
  std::vector<glm::u8vec4> picture;
  std::vector<PassTime> passes;
  GraphStatistics statistics;
  const glm::vec4& at(std::uint32_t x, std::uint32_t y) const { return color[y * width + x]; }
};

class Stage {
 public:
  static Stage& get();  ///< one device for all tests of the program

  struct Options {
    std::uint32_t width = 64, height = 64;
    FrameSettings settings;
    Effect* effect = nullptr;
    Renderer* renderer = nullptr;  ///< null: the stage's own
    std::optional<std::vector<glm::mat4>> worldFromNode;
    bool upload = true;  ///< false: the scene uploaded last, whose numbers may have changed
  };
  Shot render(const scene::Scene& scene, const scene::CameraView& camera, const std::vector<scene::LightView>& lights,
              Options options);
  Shot render(const scene::Scene& scene, const scene::CameraView& camera, const std::vector<scene::LightView>& lights) {
    return render(scene, camera, lights, Options{});
  }
  gpu::Device& device() { return *device_; }
  Renderer& renderer() { return *renderer_; }

 private:
  Stage();
  std::unique_ptr<gpu::Device> device_;
  std::unique_ptr<GraphMemory> memory_;
  std::unique_ptr<Renderer> renderer_;
};

/// Fails a test that made the validation layer speak.
class FrameTest : public testing::Test {
 protected:
  void SetUp() override { before_ = Stage::get().device().validationMessages(); }
  void TearDown() override { EXPECT_EQ(Stage::get().device().validationMessages(), before_); }
  Stage& stage() { return Stage::get(); }

 private:
  std::uint32_t before_ = 0;
};

/// The pixel that sees a world point.
glm::ivec2 pixelOf(const scene::CameraView& camera, const Shot& shot, const glm::vec3& world);
/// Radiance there.
glm::vec3 radianceAt(const scene::CameraView& camera, const Shot& shot, const glm::vec3& world);

}  // namespace tyndall::render::test
