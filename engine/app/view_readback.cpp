#include "app/view_readback.hpp"

#include <algorithm>

#include "app/readback.hpp"
#include "base/assert.hpp"
#include "texel_format.hpp"

namespace tyndall::app {
namespace {

constexpr std::uint32_t kShowsRgb = 4, kShowsNormal = 5;  // DebugImage::channel beyond R G B A

}  // namespace

image::FloatImage exrOf(const ViewPicture& picture) {
  const std::uint32_t channels = picture.channels == 2 ? 3 : picture.channels;
  image::FloatImage result{picture.width, picture.height, channels, {}};
  result.values.reserve(std::size_t{picture.width} * picture.height * channels);
  for (std::size_t i = 0; i < picture.values.size(); i += picture.channels)
    for (std::uint32_t c = 0; c < channels; ++c)
      result.values.push_back(c < picture.channels ? picture.values[i + c] : 0.0f);
  return result;
}

Result<void> ViewReadback::addPasses(Session& session, render::Graph& graph, const render::FrameOutput& output,
                                     const std::vector<ViewRequest>& wanted) {
  TY_ASSERT(output.views.size() == wanted.size(), "the frame offers " + std::to_string(output.views.size()) +
                                                      " views, " + std::to_string(wanted.size()) + " are read");
  copies_.clear();
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const render::Effect::DebugImage& view = output.views[i];
    Copy& copy = copies_.emplace_back();
    copy.picture.name = wanted[i].name;
    if (!view.image) continue;
    const gpu::ImageDesc& desc = graph.desc(view.image);
    const TexelFormat format = texelFormat(desc.format);
    if (!format.name)
      return failed("debug view '" + wanted[i].name + "': its image's format (VkFormat " + std::to_string(desc.format) +
                    ") cannot be read");
    ViewPicture& picture = copy.picture;
    picture.layers = desc.layers, picture.mips = desc.mips;
    picture.layer = std::min(wanted[i].layer.value_or(view.view.baseLayer), desc.layers - 1);
    picture.mip = std::min(wanted[i].mip.value_or(view.view.baseMip), desc.mips - 1);
    picture.width = std::max(1u, desc.width >> picture.mip), picture.height = std::max(1u, desc.height >> picture.mip);
    picture.channels = format.channels, picture.format = format.name;
    copy.format = desc.format;
    copy.isNormal = view.channel == kShowsNormal;
    picture.shown = copy.isNormal ? kShowsRgb : view.channel;
    picture.low = copy.isNormal ? -1 : view.low, picture.high = copy.isNormal ? 1 : view.high;
    const VkDeviceSize bytes = VkDeviceSize{gpu::texelBytes(desc.format)} * picture.width * picture.height;
    auto made = session.device().createBuffer({"view readback", bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, true});
    if (!made) return made.error();
    copy.buffer = made.take();
  }
  // All buffers first: the graph keeps their addresses.
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    if (!copies_[i].buffer) continue;
    const ViewPicture& picture = copies_[i].picture;
    const render::BufferRef target = graph.import(copies_[i].buffer);
    const VkImageAspectFlags aspect =
        copies_[i].format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
    VkBufferImageCopy region{};
    region.imageSubresource = {aspect, picture.mip, picture.layer, 1};
    region.imageExtent = {picture.width, picture.height, 1};
    graph.pass("read " + picture.name, Readback::kOwner)
        .use(output.views[i].image, render::Use::kTransferRead)
        .use(target, render::Use::kTransferWrite)
        .keep()
        .run([image = output.views[i].image, target, region](render::PassContext& pass) {
          vkCmdCopyImageToBuffer(pass.commands(), pass.image(image), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                 pass.buffer(target), 1, &region);
        });
  }
  return {};
}

std::vector<ViewPicture> ViewReadback::pictures() const {
  std::vector<ViewPicture> pictures;
  for (const Copy& copy : copies_) {
    ViewPicture& picture = pictures.emplace_back(copy.picture);
    if (!copy.buffer) continue;
    const std::size_t count = std::size_t{picture.width} * picture.height;
    picture.values = decodeTexels(copy.format, copy.buffer.mapped(), count);
    if (!copy.isNormal) continue;
    std::vector<float> normals(count * 3);
    for (std::size_t i = 0; i < count; ++i)
      unitFromOct(picture.values[i * picture.channels], picture.values[i * picture.channels + 1], &normals[i * 3]);
    picture.values = std::move(normals);
    picture.channels = 3;
  }
  return pictures;
}

}  // namespace tyndall::app
