#include "imgui_renderer.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <utility>

#include <imgui.h>

#include "base/assert.hpp"
#include "base/file.hpp"

namespace tyndall::editor {
namespace {

struct Push {
  float scale[2], offset[2];
};

constexpr VkIndexType kIndexType = sizeof(ImDrawIdx) == 2 ? VK_INDEX_TYPE_UINT16 : VK_INDEX_TYPE_UINT32;

/// The part of the target that a command may draw into; empty when nothing of it is visible.
VkRect2D scissor(const ImDrawData& data, const ImVec4& clip, const gpu::ImageDesc& target) {
  const auto edge = [](float points, float origin, float scale, std::uint32_t limit) {
    return static_cast<std::int32_t>(std::clamp((points - origin) * scale, 0.0f, static_cast<float>(limit)));
  };
  const ImVec2 scale = data.FramebufferScale;
  const std::int32_t left = edge(clip.x, data.DisplayPos.x, scale.x, target.width),
                     right = edge(clip.z, data.DisplayPos.x, scale.x, target.width);
  const std::int32_t top = edge(clip.y, data.DisplayPos.y, scale.y, target.height),
                     bottom = edge(clip.w, data.DisplayPos.y, scale.y, target.height);
  return {
      {left, top},
      {static_cast<std::uint32_t>(std::max(right - left, 0)), static_cast<std::uint32_t>(std::max(bottom - top, 0))}};
}

/// A host-visible buffer of at least `bytes`, with room to grow.
Result<void> fit(gpu::Device& device, gpu::Buffer& buffer, const char* name, std::size_t bytes,
                 VkBufferUsageFlags usage) {
  if (buffer && buffer.size() >= bytes) return {};
  auto made = device.createBuffer({name, std::max<VkDeviceSize>(bytes * 2, 65536), usage, true});
  if (!made) return made.error();
  buffer = made.take();
  return {};
}

}  // namespace

Result<std::unique_ptr<ImGuiRenderer>> ImGuiRenderer::create(gpu::Device& device, VkFormat format) {
  std::unique_ptr<ImGuiRenderer> made(new ImGuiRenderer(device));
  ImGuiIO& io = ImGui::GetIO();
  io.BackendRendererName = "tyndall";
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  if (auto font = made->makeFont(); !font) return font.error();
  if (auto pipeline = made->makePipeline(format); !pipeline) return pipeline.error();
  VkSamplerCreateInfo sampler{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  sampler.magFilter = sampler.minFilter = VK_FILTER_LINEAR;
  sampler.addressModeU = sampler.addressModeV = sampler.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  made->sampler_ = device.sampler(sampler);
  sampler.magFilter = sampler.minFilter = VK_FILTER_NEAREST;
  made->nearest_ = device.sampler(sampler);
  return made;
}

Result<void> ImGuiRenderer::makeFont() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  unsigned char* texels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsRGBA32(&texels, &width, &height);
  gpu::ImageDesc desc{.name = "editor font", .format = VK_FORMAT_R8G8B8A8_UNORM};
  desc.width = static_cast<std::uint32_t>(width), desc.height = static_cast<std::uint32_t>(height);
  desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  auto image = device_.createImage(desc);
  if (!image) return image.error();
  font_ = image.take();
  if (auto done = device_.upload(
          font_, {reinterpret_cast<const std::byte*>(texels), std::size_t{4} * desc.width * desc.height});
      !done)
    return done;
  atlas.SetTexID(reinterpret_cast<ImTextureID>(Texture::kFont));
  atlas.ClearTexData();
  return {};
}

Result<void> ImGuiRenderer::makePipeline(VkFormat format) {
  gpu::ShaderFolder shaders(executableFolder() / "shaders");
  auto vertex = shaders.get("imgui.vert"), fragment = shaders.get("imgui.frag");
  if (!vertex) return vertex.error();
  if (!fragment) return fragment.error();
  gpu::GraphicsPipelineDesc desc;
  desc.name = "user interface";
  desc.vertex = vertex.take(), desc.fragment = fragment.take();
  desc.bindings = {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
  desc.pushConstantBytes = sizeof(Push);
  desc.vertexBindings = {{0, sizeof(ImDrawVert), VK_VERTEX_INPUT_RATE_VERTEX}};
  desc.vertexAttributes = {{0, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, pos)},
                           {1, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, uv)},
                           {2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(ImDrawVert, col)}};
  gpu::ColorTarget over{format,
                        true,
                        VK_BLEND_FACTOR_SRC_ALPHA,
                        VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
                        VK_BLEND_FACTOR_ONE,
                        VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
                        VK_BLEND_OP_ADD};
  desc.colors = {over};
  auto made = gpu::createPipeline(device_, desc);
  if (!made) return made.error();
  pipeline_ = made.take();
  return {};
}

Result<void> ImGuiRenderer::copyGeometry(const ImDrawData& data) {
  // The device's begin of this frame has waited for the last frame that read this slot's buffers.
  Geometry& frame = geometry_[device_.submittedFrames() % geometry_.size()];
  const std::size_t vertexBytes = static_cast<std::size_t>(data.TotalVtxCount) * sizeof(ImDrawVert);
  const std::size_t indexBytes = static_cast<std::size_t>(data.TotalIdxCount) * sizeof(ImDrawIdx);
  if (auto fits = fit(device_, frame.vertices, "editor vertices", vertexBytes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
      !fits)
    return fits;
  if (auto fits = fit(device_, frame.indices, "editor indices", indexBytes, VK_BUFFER_USAGE_INDEX_BUFFER_BIT); !fits)
    return fits;
  std::byte* vertices = frame.vertices.mapped();
  std::byte* indices = frame.indices.mapped();
  for (const ImDrawList* list : std::span(data.CmdLists, static_cast<std::size_t>(data.CmdListsCount))) {
    std::memcpy(vertices, list->VtxBuffer.Data, static_cast<std::size_t>(list->VtxBuffer.size_in_bytes()));
    std::memcpy(indices, list->IdxBuffer.Data, static_cast<std::size_t>(list->IdxBuffer.size_in_bytes()));
    vertices += list->VtxBuffer.size_in_bytes();
    indices += list->IdxBuffer.size_in_bytes();
  }
  return {};
}

Texture ImGuiRenderer::addTexture() {
  return std::exchange(nextTexture_, Texture{static_cast<std::intptr_t>(nextTexture_) + 1});
}

Result<void> ImGuiRenderer::addPass(render::Graph& graph, const ImDrawData& data, render::ImageRef picture,
                                    render::ImageRef target) {
  if (auto copied = copyGeometry(data); !copied) return copied;
  const Geometry& frame = geometry_[device_.submittedFrames() % geometry_.size()];
  const render::ImageRef font =
      graph.import(font_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  struct Source {
    render::ImageRef image;
    VkSampler sampler;
  };
  std::map<Texture, Source> sources{{Texture::kFont, {font, sampler_}}, {Texture::kPicture, {picture, sampler_}}};
  for (const auto& [texture, shown] : textures_)
    sources[texture] = {
        graph.import(*shown.image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL),
        shown.nearest ? nearest_ : sampler_};
  render::Graph::Pass drawn = graph.pass("user interface", "editor");
  for (const auto& [texture, source] : sources) drawn.use(source.image, render::Use::kSampledGraphics);
  drawn.use(target, render::Use::kColorWrite).run([this, &data, &frame, sources, target](render::PassContext& pass) {
    const VkCommandBuffer commands = pass.commands();
    const gpu::ImageDesc& size = pass.desc(target);
    pass.beginRendering({{target, true, VkClearColorValue{{0.06f, 0.06f, 0.07f, 1}}}});
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.handle());
    const VkBuffer vertices = frame.vertices.handle();
    const VkDeviceSize zero = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &zero);
    vkCmdBindIndexBuffer(commands, frame.indices.handle(), 0, kIndexType);
    const Push push{{2 / data.DisplaySize.x, 2 / data.DisplaySize.y},
                    {-1 - data.DisplayPos.x * 2 / data.DisplaySize.x, -1 - data.DisplayPos.y * 2 / data.DisplaySize.y}};
    vkCmdPushConstants(commands, pipeline_.layout(), VK_SHADER_STAGE_ALL, 0, sizeof push, &push);
    ImTextureID bound = nullptr;
    std::uint32_t firstIndex = 0, firstVertex = 0;
    for (const ImDrawList* list : std::span(data.CmdLists, static_cast<std::size_t>(data.CmdListsCount))) {
      for (const ImDrawCmd& command : list->CmdBuffer) {
        TY_ASSERT(!command.UserCallback, "the editor's windows use no draw callbacks");
        const VkRect2D part = scissor(data, command.ClipRect, size);
        if (part.extent.width == 0 || part.extent.height == 0) continue;
        vkCmdSetScissor(commands, 0, 1, &part);
        if (const ImTextureID wanted = command.GetTexID(); wanted != bound) {
          // A texture that was removed since its window was drawn shows the font's for this one frame.
          const auto found = sources.find(static_cast<Texture>(reinterpret_cast<std::intptr_t>(wanted)));
          const Source& source = found != sources.end() ? found->second : sources.at(Texture::kFont);
          gpu::Descriptors(commands, pipeline_).sampled(0, pass.view(source.image), source.sampler).push();
          bound = wanted;
        }
        vkCmdDrawIndexed(commands, command.ElemCount, 1, firstIndex + command.IdxOffset,
                         static_cast<std::int32_t>(firstVertex + command.VtxOffset), 0);
      }
      firstIndex += static_cast<std::uint32_t>(list->IdxBuffer.Size);
      firstVertex += static_cast<std::uint32_t>(list->VtxBuffer.Size);
    }
    pass.endRendering();
  });
  return {};
}

}  // namespace tyndall::editor
