#include "app/readback.hpp"

#include <cstring>

namespace tyndall::app {

Result<void> Readback::copy(Session& session, render::Graph& graph, const char* name, render::ImageRef image,
                            std::uint64_t texelBytes, gpu::Buffer& buffer) {
  const std::uint64_t bytes = std::uint64_t{width_} * height_ * texelBytes;
  if (!buffer || buffer.size() != bytes) {
    auto made = session.device().createBuffer({name, bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, true});
    if (!made) return made.error();
    buffer = made.take();
  }
  const render::BufferRef target = graph.import(buffer);
  graph.pass(name, kOwner)
      .use(image, render::Use::kTransferRead)
      .use(target, render::Use::kTransferWrite)
      .keep()
      .run([image, target, this](render::PassContext& pass) {
        VkBufferImageCopy region{};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageExtent = {width_, height_, 1};
        vkCmdCopyImageToBuffer(pass.commands(), pass.image(image), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                               pass.buffer(target), 1, &region);
        // Waiting for the frame orders execution only; this makes the copy visible to the host's reads.
        VkMemoryBarrier2 toHost{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
        toHost.srcStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
        toHost.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
        toHost.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT, toHost.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
        VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
        dependency.memoryBarrierCount = 1, dependency.pMemoryBarriers = &toHost;
        vkCmdPipelineBarrier2(pass.commands(), &dependency);
      });
  return {};
}

Result<void> Readback::addPasses(Session& session, render::Graph& graph, const render::FrameOutput& output,
                                 const FrameRequest& request, const ReadbackWants& wants) {
  width_ = request.width;
  height_ = request.height;
  scatterIsEmpty_ = !output.scatter;
  if (wants.picture)
    if (auto done = copy(session, graph, "read picture", output.picture, 4, picture_); !done) return done;
  if (wants.scatter && output.scatter)
    if (auto done = copy(session, graph, "read scatter", output.scatter, 16, scatter_); !done) return done;
  if (wants.distance) {
    const render::ImageRef distance = session.renderer().addDistance(graph, output.view, output.depth);
    if (auto done = copy(session, graph, "read distance", distance, 4, distance_); !done) return done;
  }
  return {};
}

image::ByteImage Readback::picture() const {
  image::ByteImage result{width_, height_, 3, {}};
  const std::size_t pixels = std::size_t{width_} * height_;
  result.values.resize(pixels * 3);
  const std::byte* rgba = picture_.mapped();
  for (std::size_t i = 0; i < pixels; ++i) std::memcpy(&result.values[3 * i], rgba + 4 * i, 3);
  return result;
}

image::FloatImage Readback::scatter() const {
  image::FloatImage result{width_, height_, 4, {}};
  result.values.resize(std::size_t{width_} * height_ * 4);
  if (scatterIsEmpty_)
    for (std::size_t i = 3; i < result.values.size(); i += 4) result.values[i] = 1;
  else
    std::memcpy(result.values.data(), scatter_.mapped(), result.values.size() * sizeof(float));
  return result;
}

image::FloatImage Readback::distance() const {
  image::FloatImage result{width_, height_, 1, {}};
  result.values.resize(std::size_t{width_} * height_);
  std::memcpy(result.values.data(), distance_.mapped(), result.values.size() * sizeof(float));
  return result;
}

}  // namespace tyndall::app
