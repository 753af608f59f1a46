#include "stage.hpp"

#include <cstring>

namespace tyndall::render::test {

namespace {

// A readback buffer and the pass that fills it.
struct Copy {
  gpu::Buffer buffer;
  template <class T>
  std::vector<T> take(std::size_t count) const {
    std::vector<T> values(count);
    std::memcpy(values.data(), buffer.mapped(), count * sizeof(T));
    return values;
  }
};

void addCopy(gpu::Device& device, Graph& graph, ImageRef image, Copy& copy) {
  const gpu::ImageDesc desc = graph.desc(image);
  copy.buffer = device
                    .createBuffer({"readback", VkDeviceSize{desc.width} * desc.height * gpu::texelBytes(desc.format),
                                   VK_BUFFER_USAGE_TRANSFER_DST_BIT, true})
                    .take();
  const BufferRef target = graph.import(copy.buffer);
  graph.pass("copy").use(image, Use::kTransferRead).use(target, Use::kTransferWrite).run([=](PassContext& context) {
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {desc.width, desc.height, 1};
    vkCmdCopyImageToBuffer(context.commands(), context.image(image), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           context.buffer(target), 1, &region);
  });
}

}  // namespace

Stage& Stage::get() {
  static Stage stage;
  return stage;
}

Stage::Stage() {
  gpu::DeviceOptions options;
  options.validation = true;
  auto device = gpu::Device::create(options);
  if (!device) throw std::runtime_error(device.error().message);
  device_ = device.take();
  memory_ = std::make_unique<GraphMemory>(*device_);
  auto renderer = Renderer::create(*device_, std::filesystem::path(TYNDALL_BIN_DIR) / "shaders");
  if (!renderer) throw std::runtime_error(renderer.error().message);
  renderer_ = renderer.take();
}

Shot Stage::render(const scene::Scene& scene, const scene::CameraView& camera,
                   const std::vector<scene::LightView>& lights, Options options) {
  Shot shot;
  shot.width = options.width;
  shot.height = options.height;
  Renderer& renderer = options.renderer ? *options.renderer : *renderer_;
  if (options.upload) {
    EXPECT_TRUE(renderer.setScene(scene).ok());
  }
  Renderer::Input input{scene, options.worldFromNode ? *options.worldFromNode : scene::worldMatrices(scene, 0), camera,
                        lights};
  input.width = options.width;
  input.height = options.height;
  input.settings = options.settings;
  if (input.settings.shadowResolution == 2048) input.settings.shadowResolution = 512;  // small levels; a fast test
  input.effect = options.effect;

  Graph graph(*device_, *memory_);
  Result<FrameOutput> output = renderer.addFrame(graph, input);
  if (!output) throw std::runtime_error(output.error().message);
  Copy color, distance, picture;
  const View view = makeView(camera, options.width, options.height);
  addCopy(*device_, graph, output->color, color);
  addCopy(*device_, graph, renderer.addDistance(graph, view, output->depth), distance);
  addCopy(*device_, graph, output->picture, picture);
  Result<void> compiled = graph.compile();
  if (!compiled) throw std::runtime_error(compiled.error().message);
  Result<VkCommandBuffer> commands = device_->beginFrame();
  if (!commands) throw std::runtime_error(commands.error().message);
  graph.record(*commands, nullptr);
  EXPECT_TRUE(device_->endFrame().ok());
  EXPECT_TRUE(device_->waitIdle().ok());
  shot.passes = graph.passes();
  shot.statistics = graph.statistics();
  const std::size_t count = std::size_t{shot.width} * shot.height;
  shot.color = color.take<glm::vec4>(count);
  shot.distance = distance.take<float>(count);
  shot.picture = picture.take<glm::u8vec4>(count);
  return shot;
}

glm::ivec2 pixelOf(const scene::CameraView& camera, const Shot& shot, const glm::vec3& world) {
  const View view = makeView(camera, shot.width, shot.height);
  const glm::vec4 clip = view.clipFromView * view.viewFromWorld * glm::vec4(world, 1);
  const glm::vec2 pixel = (glm::vec2(clip) / clip.w * 0.5f + 0.5f) * glm::vec2(shot.width, shot.height);
  EXPECT_TRUE(clip.w > 0 && pixel.x >= 0 && pixel.y >= 0 && pixel.x < static_cast<float>(shot.width) &&
              pixel.y < static_cast<float>(shot.height))
      << "not in the picture: " << pixel.x << ", " << pixel.y;
  return glm::ivec2(pixel);
}

glm::vec3 radianceAt(const scene::CameraView& camera, const Shot& shot, const glm::vec3& world) {
  const glm::ivec2 p = pixelOf(camera, shot, world);
  return glm::vec3(shot.at(static_cast<std::uint32_t>(p.x), static_cast<std::uint32_t>(p.y)));
}

}  // namespace tyndall::render::test
