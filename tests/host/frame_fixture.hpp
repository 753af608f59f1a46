// Frames for the GPU tests: a device with validation, a depth image of our choice, shadow maps of constant depth.
#pragma once

#include <cstdlib>
#include <cstring>
#include <functional>

#include <gtest/gtest.h>

#include "host/host.hpp"
#include "temporary_folder.hpp"

namespace tyndall::host {

class FrameFixture : public testing::Test {
 protected:
  static constexpr std::uint32_t kWidth = 37, kHeight = 21;  // no multiple of any workgroup

  void SetUp() override {
    ::setenv("XDG_CACHE_HOME", cache_.path().c_str(), 1);  // tunables of one test are not another's
    gpu::DeviceOptions options;
    options.validation = true;
    auto created = gpu::Device::create(options);
    ASSERT_TRUE(created) << created.error().message;
    device_ = created.take();
    memory_ = std::make_unique<render::GraphMemory>(*device_);
    scene::CameraView camera;
    camera.camera.yfov = 1.1f;
    camera.camera.znear = 0.25f;
    camera.camera.zfar = 80.0f;
    camera.worldFromView = glm::mat4(1);
    camera.worldFromView[3] = glm::vec4(3, 2, 1, 1);
    view_ = render::makeView(camera, kWidth, kHeight);
    std::vector<float> depths(kWidth * kHeight);
    for (std::size_t i = 0; i < depths.size(); ++i) depths[i] = i % 5 == 0 ? 0.0f : static_cast<float>(i % 97) / 97.0f;
    depths_ = depths;
    depth_ = depthImage("depth", kWidth, kHeight, 1, depths);
  }

  void TearDown() override {
    effect_.reset();
    plugin_.reset();
    if (device_) {
      ASSERT_TRUE(device_->waitIdle());
      EXPECT_EQ(device_->validationMessages(), 0u);
    }
    shadowMaps_.clear();
    momentMaps_.clear();
    cookies_ = {};
    white_ = {};
    depth_ = {};
    timestamps_ = {};
    memory_.reset();
    device_.reset();
  }

  gpu::Image depthImage(const char* name, std::uint32_t w, std::uint32_t h, std::uint32_t layers,
                        const std::vector<float>& depths) {
    auto image =
        device_->createImage({.name = name,
                              .format = VK_FORMAT_D32_SFLOAT,
                              .width = w,
                              .height = h,
                              .layers = layers,
                              .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
                                       VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT});
    EXPECT_TRUE(image) << image.error().message;
    for (std::uint32_t layer = 0; layer < layers; ++layer)
      EXPECT_TRUE(device_->upload(*image, std::as_bytes(std::span(depths)), 0, layer));
    return image.take();
  }

  /// A moment map of 8x8 texels; the third channel of each texel is 100 times its mip plus `value`.
  gpu::Image momentImage(std::uint32_t layers, float value) {
    auto image = device_->createImage(
        {.name = "moments",
         .format = VK_FORMAT_R32G32B32A32_SFLOAT,
         .width = 8,
         .height = 8,
         .layers = layers,
         .mips = 4,
         .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    EXPECT_TRUE(image) << image.error().message;
    for (std::uint32_t mip = 0; mip < 4; ++mip) {
      const std::vector<glm::vec4> texels(64u >> (2 * mip),
                                          glm::vec4(0, 0, 100.0f * static_cast<float>(mip) + value, 0));
      for (std::uint32_t layer = 0; layer < layers; ++layer)
        EXPECT_TRUE(device_->upload(*image, std::as_bytes(std::span(texels)), mip, layer));
    }
    return image.take();
  }

  /// Cookies of 8x8 texels in seven layers: 100 times the layer plus 10 times the mip, and 1000 more in the last column
  /// of mip 0. And one white texel.
  void offerCookies() {
    const auto make = [&](const char* name, std::uint32_t side, std::uint32_t layers, std::uint32_t mips) {
      return device_
          ->createImage({.name = name,
                         .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                         .width = side,
                         .height = side,
                         .layers = layers,
                         .mips = mips,
                         .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT})
          .take();
    };
    cookies_ = make("cookies", 8, 7, 4);
    white_ = make("white", 1, 1, 1);
    const std::vector<glm::vec4> one(1, glm::vec4(1));
    EXPECT_TRUE(device_->upload(white_, std::as_bytes(std::span(one))));
    for (std::uint32_t layer = 0; layer < 7; ++layer)
      for (std::uint32_t mip = 0; mip < 4; ++mip) {
        std::vector<glm::vec4> texels(64u >> (2 * mip), glm::vec4(static_cast<float>(100 * layer + 10 * mip)));
        for (std::size_t i = 7; mip == 0 && i < 64; i += 8) texels[i] += 1000.0f;
        EXPECT_TRUE(device_->upload(cookies_, std::as_bytes(std::span(texels)), mip, layer));
      }
  }

  void load(const std::filesystem::path& library) {
    auto plugin = Plugin::load(library);
    ASSERT_TRUE(plugin) << plugin.error().message;
    plugin_ = plugin.take();
    ASSERT_TRUE(table_.add(plugin_->parameters()));
    makeEffect();
  }
  void makeEffect() {
    auto effect = PluginEffect::create(*device_, *plugin_, table_);
    ASSERT_TRUE(effect);
    effect_ = effect.take();
  }

  void addLight(scene::LightKind kind, glm::vec3 color, float intensity, float shadowDepth) {
    const std::uint32_t faces = kind == scene::LightKind::kPoint ? 6 : 1;
    shadowMaps_.push_back(depthImage("shadow", 8, 8, faces, std::vector<float>(64, shadowDepth)));
    momentMaps_.push_back(momentImage(faces, static_cast<float>(momentMaps_.size())));
    scene::LightView light;
    light.light.kind = kind;
    light.light.color = color;
    light.light.intensity = intensity;
    light.direction = glm::vec3(0, -1, 0);
    lights_.push_back(light);
  }

  struct Picture {
    bool empty = true;
    std::vector<glm::vec4> texels;
    glm::vec4 at(std::uint32_t x, std::uint32_t y) const { return texels[y * kWidth + x]; }
  };

  /// One frame through graph and device; `also` may add passes that read debug images.
  Picture frame(bool reset = false, const std::function<void(render::Graph&)>& also = {}) {
    render::Graph graph(*device_, *memory_);
    std::vector<render::ShadowedLight> lights;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
      render::ShadowedLight light;
      light.light = lights_[i];
      light.shadowMap = graph.import(shadowMaps_[i], VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                                     VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
      if (offerMoments_)
        light.moments = graph.import(momentMaps_[i], VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                                     VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
      light.faceCount = lights_[i].light.kind == scene::LightKind::kPoint ? 6 : 1;
      light.size = 8;
      if (cookies_) {
        if (cookieRefs_.size() > i) light = cookieRefs_[i](light);
        light.cookie = graph.import(light.cookieFaces ? cookies_ : white_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                                    VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
      }
      lights.push_back(light);
    }
    const auto depth =
        graph.import(depth_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    render::EffectInput input{graph, view_, depth, lights, reset, drawCasters_};
    auto output = effect_->addPasses(input);
    EXPECT_TRUE(output) << output.error().message;
    if (also) also(graph);
    Picture picture;
    if (dropFirstOfNewLayout_ && effect_->background() == PluginEffect::Background::kIdle) {
      dropFirstOfNewLayout_ = false;
      effect_->frameDropped(failed("no room"));
      return picture;
    }
    gpu::Buffer host;
    if (*output) {
      picture.empty = false;
      host = copyOut(graph, *output);
    }
    EXPECT_TRUE(graph.compile());
    auto commands = device_->beginFrame();
    EXPECT_TRUE(commands);
    if (!timestamps_.capacity()) timestamps_ = gpu::Timestamps::create(*device_, 64).take();
    graph.record(*commands, &timestamps_);
    EXPECT_TRUE(device_->endFrame());
    effect_->frameSubmitted();
    EXPECT_TRUE(device_->waitIdle());
    times_ = graph.passes();
    const auto ms = timestamps_.milliseconds();
    for (std::size_t i = 0; i < times_.size(); ++i) times_[i].milliseconds = ms.at(i);
    if (fakeTimes_) fakeTimes_(times_);
    effect_->frameFinished(times_);
    if (!picture.empty) {
      picture.texels.resize(kWidth * kHeight);
      std::memcpy(picture.texels.data(), host.mapped(), picture.texels.size() * sizeof(glm::vec4));
    }
    return picture;
  }

  /// Reads one mip of the first layer of an image into a host buffer.
  gpu::Buffer copyOut(render::Graph& graph, render::ImageRef image, std::uint32_t mip = 0) {
    gpu::ImageDesc desc = graph.desc(image);
    desc.width = std::max(1u, desc.width >> mip);
    desc.height = std::max(1u, desc.height >> mip);
    auto host = device_->createBuffer({.name = "read back",
                                       .size = std::uint64_t{desc.width} * desc.height * gpu::texelBytes(desc.format),
                                       .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                       .hostVisible = true});
    EXPECT_TRUE(host);
    const VkBuffer handle = host->handle();
    graph.pass("read back").use(image, render::Use::kTransferRead).keep().run([=](render::PassContext& context) {
      VkBufferImageCopy copy{};
      copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, 1};
      copy.imageExtent = {desc.width, desc.height, 1};
      vkCmdCopyImageToBuffer(context.commands(), context.image(image), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, handle, 1,
                             &copy);
      VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,   nullptr,
                               VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                               VK_PIPELINE_STAGE_2_HOST_BIT,         VK_ACCESS_2_HOST_READ_BIT};
      VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
      info.memoryBarrierCount = 1;
      info.pMemoryBarriers = &barrier;
      vkCmdPipelineBarrier2(context.commands(), &info);
    });
    return host.take();
  }

  bool ran(const std::string& pass) const {
    for (const auto& time : times_)
      if (time.name == pass) return true;
    return false;
  }

  test::TemporaryFolder cache_;
  std::unique_ptr<gpu::Device> device_;
  std::unique_ptr<render::GraphMemory> memory_;
  gpu::Timestamps timestamps_;
  render::View view_;
  gpu::Image depth_;
  std::vector<float> depths_;
  std::vector<gpu::Image> shadowMaps_, momentMaps_;
  gpu::Image cookies_, white_;  ///< empty: cookies are not offered
  std::vector<std::function<render::ShadowedLight(render::ShadowedLight)>> cookieRefs_;  ///< gives light i its cookie
  bool offerMoments_ = true;  ///< else the lights have none, as where the device cannot filter them
  std::vector<scene::LightView> lights_;
  std::function<void(render::PassContext&, const glm::mat4&)> drawCasters_;
  std::function<void(std::vector<render::PassTime>&)> fakeTimes_;
  std::vector<render::PassTime> times_;
  bool dropFirstOfNewLayout_ = false;  ///< the first frame with nothing left to build is not submitted
  params::Table table_;
  std::unique_ptr<Plugin> plugin_;
  std::unique_ptr<PluginEffect> effect_;
};

}  // namespace tyndall::host
