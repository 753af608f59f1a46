// The plain march against the least that any march must do: 320 texel fetches a pixel along a line through a map of the
// same size, summed and stored, in the same run. A rival that is slower than that by much would flatter the rest.
#include <algorithm>
#include <fstream>
#include <optional>

#include <unistd.h>

#include <gtest/gtest.h>

#include "gpu/pipeline.hpp"
#include "gpu/shader.hpp"
#include "laboratory.hpp"
#include "table.hpp"

namespace tyndall::figures {
namespace {

constexpr std::uint32_t kWidth = 1280, kHeight = 720, kMap = 4096, kSteps = 320;

// Lines of a few texels a step, neighbouring pixels on neighbouring ones, as a shadow map is marched through.
constexpr const char* kBareLoop = R"(#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const int kSteps = 1;
layout(binding = 0) uniform sampler2D map;
layout(binding = 1, rgba32f) writeonly uniform image2D result;
void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(result)))) return;
  vec2 share = (vec2(pixel) + 0.5) / vec2(imageSize(result));
  vec2 at = vec2(600.0, 2048.0);
  vec2 along = (vec2(3800.0, 400.0 + 3300.0 * share.x) - at) * (0.3 + 0.7 * share.y) / float(kSteps);
  float lit = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    at += along;
    lit += texelFetch(map, ivec2(at), 0).x > 0.5 ? 1.0 : 0.0;
  }
  imageStore(result, pixel, vec4(lit));
}
)";

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

class BareLoop {
 public:
  explicit BareLoop(app::Session& session) : device_(session.device()), memory_(session.graphMemory()) {
    const auto path =
        std::filesystem::temp_directory_path() / ("tyndall-bare-" + std::to_string(::getpid()) + ".comp.glsl");
    std::ofstream(path) << kBareLoop;
    auto code = gpu::compileGlsl(path, "comp", {});
    std::filesystem::remove(path);
    if (!code) throw std::runtime_error(code.error().message);
    pipeline_.emplace(take(gpu::createPipeline(
        device_,
        gpu::ComputePipelineDesc{
            .name = "bare loop",
            .shader = std::make_shared<gpu::Shader>(gpu::Shader{"bare.comp", code.take(), 1}),
            .bindings = {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}, {1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}},
            .specialization = {{0, kSteps}}})));
  }

  double milliseconds() {
    auto commands = device_.beginFrame();
    if (!commands) throw std::runtime_error(commands.error().message);
    render::Graph graph(device_, memory_);
    const render::ImageRef map =
        graph.image({.name = "map", .format = VK_FORMAT_R32_SFLOAT, .width = kMap, .height = kMap});
    const render::ImageRef result =
        graph.image({.name = "result", .format = VK_FORMAT_R32G32B32A32_SFLOAT, .width = kWidth, .height = kHeight});
    const VkSamplerCreateInfo nearest{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    const VkSampler sampler = device_.sampler(nearest);
    graph.pass("clear").use(map, render::Use::kTransferWrite).keep().run([map](render::PassContext& pass) {
      const VkClearColorValue half{{0.75f, 0, 0, 0}};
      const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
      vkCmdClearColorImage(pass.commands(), pass.image(map), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &half, 1, &all);
    });
    graph.pass("bare loop")
        .use(map, render::Use::kSampledCompute)
        .use(result, render::Use::kStorageWriteCompute)
        .keep()
        .run([&, map, result](render::PassContext& pass) {
          vkCmdBindPipeline(pass.commands(), pipeline_->bindPoint(), pipeline_->handle());
          gpu::Descriptors(pass.commands(), *pipeline_)
              .sampled(0, pass.view(map), sampler)
              .storageImage(1, pass.view(result))
              .push();
          vkCmdDispatch(pass.commands(), kWidth / 8, kHeight / 8, 1);
        });
    if (auto compiled = graph.compile(); !compiled) throw std::runtime_error(compiled.error().message);
    auto stamps = take(gpu::Timestamps::create(device_, 8));
    graph.record(*commands, &stamps);
    if (!device_.endFrame() || !device_.waitIdle()) throw std::runtime_error("the bare loop could not be run");
    return stamps.milliseconds().at(1);
  }

 private:
  template <class T>
  static T take(Result<T> made) {
    if (!made) throw std::runtime_error(made.error().message);
    return made.take();
  }
  gpu::Device& device_;
  render::GraphMemory& memory_;
  std::optional<gpu::Pipeline> pipeline_;
};

TEST(MarchFloor, TheMarchIsWithinTwiceABareLoopOfFetches) {
  Report report("march_floor");
  for (const char* level : {"hall", "forest"}) {
    Laboratory lab(level, 0, kWidth, kHeight);
    BareLoop bare(lab.session());
    lab.shoot({"volumetrics.technique=ray_march", "volumetrics.steps=" + std::to_string(kSteps),
               "volumetrics.jitter=white", "shadows.resolution=4096"});
    bare.milliseconds();
    std::vector<double> floor, march;
    for (int i = 0; i < 5; ++i) {
      floor.push_back(bare.milliseconds());
      march.push_back(lab.again(1).front().pluginMs());
    }
    const double ratio = median(march) / median(floor);
    report.line(std::string(level) + ", " + lab.device() + ": ray_march 320 " + figure(median(march)) +
                " ms, bare loop of 320 fetches " + figure(median(floor)) + " ms, ratio " + figure(ratio));
    EXPECT_LT(ratio, 2) << level;
    EXPECT_GT(ratio, 0.3) << level << ": the loop does what the march does not";
  }
}

}  // namespace
}  // namespace tyndall::figures
