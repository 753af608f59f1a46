// The editor's two frames: the picture into an image that is kept, and the window around it.
#include <algorithm>
#include <cstring>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "editor.hpp"
#include "image/image_io.hpp"

namespace tyndall::editor {
namespace {

/// Copies all of `from` into `to`: colour images of the same size and texel size.
void addCopy(render::Graph& graph, const char* name, render::ImageRef from, render::ImageRef to) {
  graph.pass(name, "editor")
      .use(from, render::Use::kTransferRead)
      .use(to, render::Use::kTransferWrite)
      .run([from, to](render::PassContext& pass) {
        const gpu::ImageDesc& size = pass.desc(from);
        VkImageCopy region{};
        region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.extent = {size.width, size.height, 1};
        vkCmdCopyImage(pass.commands(), pass.image(from), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, pass.image(to),
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
      });
}

}  // namespace

bool Editor::pictureWanted() const {
  const bool otherSize =
      !picture_ || (!dividing_ && (picture_.desc().width != viewWidth_ || picture_.desc().height != viewHeight_));
  return workspace_.changed || workspace_.playing || workspace_.continuous || options_.frames > 0 || otherSize ||
         session_->exposureMoving() || session_->background() == host::PluginEffect::Background::kReady;
}

Result<void> Editor::renderPicture() {
  workspace_.changed = false;  // also after an error: what cannot be drawn is not tried again until something changes
  app::FrameRequest request;
  request.width = viewWidth_, request.height = viewHeight_;
  request.camera = camera_->view(fileCamera());
  request.seconds = workspace_.seconds;
  request.debugView = workspace_.debugView;
  request.meter = true;
  request.adaptSeconds = static_cast<float>(glfwGetTime() - std::max(pictureTime_, stillTime_));
  gpu::Image next;
  if (!picture_ || picture_.desc().width != viewWidth_ || picture_.desc().height != viewHeight_) {
    gpu::ImageDesc desc{
        .name = "shown picture", .format = VK_FORMAT_R8G8B8A8_UNORM, .width = viewWidth_, .height = viewHeight_};
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    auto made = session_->device().createImage(desc);
    if (!made) return made.error();
    next = made.take();
  }
  gpu::Image& target = next ? next : picture_;
  render::Graph graph(session_->device(), session_->graphMemory());
  auto output = session_->buildFrame(graph, request);
  if (!output) return output.error();
  const render::ImageRef shown =
      graph.import(target, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  addCopy(graph, "keep picture", output->picture, shown);
  if (auto submitted = session_->submitFrame(graph); !submitted) return submitted;
  if (next) picture_ = std::move(next);
  if (session_->statistics().waitedForMemory)
    workspace_.tell("memory is short: the images before had to go before the new ones could be made", false);
  ++pictures_;
  timesTaken_ = false;
  pictureTime_ = glfwGetTime();
  memoryReturned_ = false;
  return {};
}

Result<void> Editor::renderWindow() {
  gpu::Device& device = session_->device();
  auto commands = device.beginFrame();
  if (!commands) return commands.error();
  auto target = swapchain_->acquire();
  if (!target) return target.error();
  const VkExtent2D extent = swapchain_->extent();
  render::Graph graph(device, *windowMemory_);
  const render::ImageRef picture =
      graph.import(picture_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  const gpu::ImageDesc size{
      .name = "window", .format = swapchain_->format(), .width = extent.width, .height = extent.height};
  const render::ImageRef window = graph.image(size, "editor");
  if (auto added = renderer_->addPass(graph, *ImGui::GetDrawData(), picture, window); !added) return added;
  if (*target) {
    // The graph needs no view of it: it is only copied to.
    const render::ImageRef image = graph.importRaw((*target)->image, VK_NULL_HANDLE, size, VK_IMAGE_LAYOUT_UNDEFINED,
                                                   VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
    addCopy(graph, "show window", window, image);
  }
  if (!options_.screenshot.empty())
    if (auto added = addScreenshot(graph, window); !added) return added;
  if (auto compiled = graph.compile(); !compiled) return compiled;
  graph.record(*commands, nullptr);
  if (auto ended = device.endFrame(*target ? (*target)->signals : gpu::FrameSignals{}); !ended) return ended;
  if (*target) return swapchain_->present(**target);
  return {};
}

Result<void> Editor::addScreenshot(render::Graph& graph, render::ImageRef window) {
  const gpu::ImageDesc& size = graph.desc(window);
  screenshotSize_ = {size.width, size.height};
  const VkDeviceSize bytes = VkDeviceSize{4} * size.width * size.height;
  if (!screenshot_ || screenshot_.size() != bytes) {
    auto made = session_->device().createBuffer({"screenshot", bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, true});
    if (!made) return made.error();
    screenshot_ = made.take();
  }
  const render::BufferRef buffer = graph.import(screenshot_);
  graph.pass("screenshot", "editor")
      .use(window, render::Use::kTransferRead)
      .use(buffer, render::Use::kTransferWrite)
      .run([window, buffer, extent = screenshotSize_](render::PassContext& pass) {
        VkBufferImageCopy region{};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageExtent = {extent.width, extent.height, 1};
        vkCmdCopyImageToBuffer(pass.commands(), pass.image(window), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                               pass.buffer(buffer), 1, &region);
      });
  return {};
}

Result<void> Editor::writeScreenshot() {
  if (options_.screenshot.empty()) return {};
  if (!screenshot_) return failed("--screenshot: no frame was shown before the window was closed");
  image::ByteImage picture{screenshotSize_.width, screenshotSize_.height, 3, {}};
  const std::size_t pixels = std::size_t{picture.width} * picture.height;
  picture.values.resize(pixels * 3);
  const bool blueFirst = swapchain_->format() == VK_FORMAT_B8G8R8A8_UNORM;
  const auto* source = reinterpret_cast<const std::uint8_t*>(screenshot_.mapped());
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < 3; ++c) picture.values[3 * i + c] = source[4 * i + (blueFirst ? 2 - c : c)];
  const auto write = [&](const std::filesystem::path& path) { return image::writePng(path, picture); };
  if (auto written = outputs_.write("--screenshot", write); !written) return written;
  return outputs_.commit();
}

}  // namespace tyndall::editor
