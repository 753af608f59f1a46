// What a pass may do while it records.
#include <algorithm>

#include "base/assert.hpp"
#include "graph_state.hpp"

namespace tyndall::render {

Use Graph::State::useOf(std::uint32_t id) const {
  TY_ASSERT(currentPass != ~0u, "a PassContext outlived its pass");
  const GraphPass& pass = passes[currentPass];
  const auto found =
      std::find_if(pass.uses.begin(), pass.uses.end(), [&](const plan::ResourceUse& u) { return u.resource == id; });
  TY_ASSERT(found != pass.uses.end(), "pass '" + pass.name + "' did not declare its use of '" +
                                          (id < input.resources.size() ? input.resources[id].name : "?") + "'");
  return found->use;
}

VkImage Graph::State::imageHandle(const GraphResource& resource) const {
  if (resource.image) return resource.image->handle();
  return resource.rawImage ? resource.rawImage : memory.resources[resource.physical].image->handle();
}

VkImageView Graph::State::imageView(const GraphResource& resource, const gpu::ViewDesc& view) const {
  if (resource.image) return resource.image->view(view);
  if (!resource.rawImage) return memory.resources[resource.physical].image->view(view);
  TY_ASSERT(view == gpu::ViewDesc{} && resource.rawView,
            "'" + resource.imageDesc.name + "' came with one view of its whole only");
  return resource.rawView;
}

VkBuffer Graph::State::bufferHandle(const GraphResource& resource) const {
  return resource.buffer ? resource.buffer->handle() : memory.resources[resource.physical].buffer->handle();
}

VkCommandBuffer PassContext::commands() const { return commands_; }
gpu::Device& PassContext::device() const { return graph_.device; }

VkImageView PassContext::view(ImageRef image, const gpu::ViewDesc& desc) const {
  graph_.useOf(image.id);
  return graph_.imageView(graph_.resource(image.id, false), desc);
}

VkImage PassContext::image(ImageRef image) const {
  graph_.useOf(image.id);
  return graph_.imageHandle(graph_.resource(image.id, false));
}

VkBuffer PassContext::buffer(BufferRef buffer) const {
  graph_.useOf(buffer.id);
  return graph_.bufferHandle(graph_.resource(buffer.id, true));
}

const gpu::ImageDesc& PassContext::desc(ImageRef image) const { return graph_.resource(image.id, false).imageDesc; }

}  // namespace tyndall::render
