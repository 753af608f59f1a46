// Declaring: resources, imports, passes.
#include <algorithm>

#include "base/assert.hpp"
#include "graph_state.hpp"

namespace tyndall::render {

Graph::Graph(gpu::Device& device, GraphMemory& memory) : state_(std::make_unique<State>(device, memory.state())) {}
Graph::~Graph() = default;

ImageRef Graph::image(const gpu::ImageDesc& desc, std::string_view owner) {
  TY_ASSERT(!state_->compiled, "image '" + desc.name + "' declared after compile()");
  TY_ASSERT(desc.format != VK_FORMAT_UNDEFINED && desc.width > 0 && desc.height > 0 && desc.depth > 0 &&
                desc.layers > 0 && desc.mips > 0,
            "image '" + desc.name + "' lacks a format or has no texels");
  GraphResource resource;
  resource.owner = owner;
  resource.imageDesc = desc;
  state_->resources.push_back(std::move(resource));
  return {static_cast<std::uint32_t>(state_->resources.size() - 1)};
}

BufferRef Graph::buffer(const gpu::BufferDesc& desc, std::string_view owner) {
  TY_ASSERT(!state_->compiled, "buffer '" + desc.name + "' declared after compile()");
  TY_ASSERT(desc.size > 0, "buffer '" + desc.name + "' has no bytes");
  GraphResource resource;
  resource.isBuffer = true;
  resource.owner = owner;
  resource.bufferDesc = desc;
  state_->resources.push_back(std::move(resource));
  return {static_cast<std::uint32_t>(state_->resources.size() - 1)};
}

// The same image imported twice is one resource, or its two timelines would not know of each other.
ImageRef Graph::import(const gpu::Image& image, VkImageLayout layoutBefore, VkImageLayout layoutAfter) {
  TY_ASSERT(!state_->compiled && image, "import() of an empty image or after compile()");
  GraphResource resource;
  resource.imageDesc = image.desc();
  resource.before = layoutBefore;
  resource.after = layoutAfter;
  resource.image = &image;
  for (std::uint32_t i = 0; i < state_->resources.size(); ++i) {
    const GraphResource& other = state_->resources[i];
    if (!other.image || other.image->handle() != image.handle()) continue;
    TY_ASSERT(other.before == layoutBefore && other.after == layoutAfter,
              "image '" + image.desc().name + "' imported twice with different layouts");
    return {i};
  }
  state_->resources.push_back(std::move(resource));
  return {static_cast<std::uint32_t>(state_->resources.size() - 1)};
}

BufferRef Graph::import(const gpu::Buffer& buffer) {
  TY_ASSERT(!state_->compiled && buffer, "import() of an empty buffer or after compile()");
  for (std::uint32_t i = 0; i < state_->resources.size(); ++i)
    if (state_->resources[i].buffer && state_->resources[i].buffer->handle() == buffer.handle()) return {i};
  GraphResource resource;
  resource.isBuffer = true;
  resource.bufferDesc = {.name = "imported buffer", .size = buffer.size(), .hostVisible = buffer.mapped() != nullptr};
  resource.buffer = &buffer;
  state_->resources.push_back(std::move(resource));
  return {static_cast<std::uint32_t>(state_->resources.size() - 1)};
}

ImageRef Graph::importRaw(VkImage image, VkImageView view, const gpu::ImageDesc& desc, VkImageLayout before,
                          VkImageLayout after) {
  TY_ASSERT(!state_->compiled && image != VK_NULL_HANDLE, "importRaw() of no image or after compile()");
  for (const GraphResource& other : state_->resources)
    TY_ASSERT(other.rawImage != image, "image '" + desc.name + "' imported twice");
  GraphResource resource;
  resource.imageDesc = desc;
  resource.before = before;
  resource.after = after;
  resource.rawImage = image;
  resource.rawView = view;
  state_->resources.push_back(std::move(resource));
  return {static_cast<std::uint32_t>(state_->resources.size() - 1)};
}

Graph::Pass Graph::pass(std::string_view name, std::string_view owner) {
  TY_ASSERT(!state_->compiled, "pass '" + std::string(name) + "' declared after compile()");
  state_->passes.push_back({.name = std::string(name), .owner = std::string(owner)});
  return Pass(*this, static_cast<std::uint32_t>(state_->passes.size() - 1));
}

namespace {
// Declaring the same use again changes nothing; a different one is a mistake that compile() reports.
void addUse(GraphPass& pass, std::uint32_t id, Use use) {
  const bool known = std::any_of(pass.uses.begin(), pass.uses.end(),
                                 [&](const plan::ResourceUse& u) { return u.resource == id && u.use == use; });
  if (!known) pass.uses.push_back({id, use});
}
}  // namespace

Graph::Pass& Graph::Pass::use(ImageRef image, Use use) {
  GraphPass& pass = graph_.state_->passes[index_];
  TY_ASSERT(image, "pass '" + pass.name + "' uses an empty ImageRef");
  graph_.state_->resource(image.id, false);
  addUse(pass, image.id, use);
  return *this;
}

Graph::Pass& Graph::Pass::use(BufferRef buffer, Use use) {
  GraphPass& pass = graph_.state_->passes[index_];
  TY_ASSERT(buffer, "pass '" + pass.name + "' uses an empty BufferRef");
  graph_.state_->resource(buffer.id, true);
  addUse(pass, buffer.id, use);
  return *this;
}

Graph::Pass& Graph::Pass::keep() {
  graph_.state_->passes[index_].keep = true;
  return *this;
}

Graph::Pass& Graph::Pass::idle() {
  graph_.state_->passes[index_].idle = true;
  return *this;
}

void Graph::Pass::run(std::function<void(PassContext&)> record) {
  graph_.state_->passes[index_].record = std::move(record);
}

const gpu::ImageDesc& Graph::desc(ImageRef image) const { return state_->resource(image.id, false).imageDesc; }

const GraphResource& Graph::State::resource(std::uint32_t id, bool isBuffer) const {
  TY_ASSERT(id < resources.size(), "resource " + std::to_string(id) + " of " + std::to_string(resources.size()));
  TY_ASSERT(resources[id].isBuffer == isBuffer, "resource " + std::to_string(id) + " is of the other kind");
  return resources[id];
}

}  // namespace tyndall::render
