// From a layout's passes to the graph's.
#include <algorithm>
#include <cstring>

#include "base/assert.hpp"
#include "built.hpp"

namespace tyndall::host {
namespace {

using render::PassContext;
using render::Use;

/// A pass may sample some parts of an image while it stores to others: the image is then in GENERAL for both.
VkImageLayout sampledLayout(const Built& built, std::uint32_t pass, const TyBinding& b) {
  for (const PassUse& use : built.uses[pass])
    if (use.resource == LayoutResource{b.source, b.index} && use.access == PassAccess::kSampledStorage)
      return VK_IMAGE_LAYOUT_GENERAL;
  return VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
}

/// What one run of a pass needs while it records; everything by value, because it records later.
struct Run {
  std::shared_ptr<Built> built;
  std::shared_ptr<const FrameRefs> refs;
  std::uint32_t pass = 0, light = TY_NONE, slot = 0;

  const LayoutPass& layoutPass() const { return built->layout.passes[pass]; }
  std::uint32_t block() const { return light == TY_NONE ? 0 : light; }  ///< which per-light block
  render::ImageRef image(std::uint32_t source, std::uint32_t index) const {
    switch (source) {
      case TY_SOURCE_IMAGE: return refs->images[index];
      case TY_SOURCE_SCENE_DEPTH: return refs->depth;
      case TY_SOURCE_SHADOW_MAP: return refs->shadowMaps[light];
      case TY_SOURCE_SHADOW_MOMENTS: return refs->shadowMoments[light];
      case TY_SOURCE_LIGHT_COOKIE: return refs->cookies[light];
      default: return refs->output;
    }
  }
};

void bind(PassContext& context, const Run& run) {
  const gpu::Pipeline& pipeline = *run.built->pipelines[run.pass];
  vkCmdBindPipeline(context.commands(), pipeline.bindPoint(), pipeline.handle());
  gpu::Descriptors descriptors(context.commands(), pipeline);
  for (const TyBinding& b : run.layoutPass().bindings) {
    if (b.source == TY_SOURCE_UNIFORM) {
      const auto place = run.built->uniforms.place(b.index, run.block(), run.slot);
      descriptors.uniformBuffer(b.binding, run.built->uniforms.buffer(), place.offset, place.size);
    } else if (b.source == TY_SOURCE_BUFFER) {
      descriptors.storageBuffer(b.binding, context.buffer(run.refs->buffers[b.index]));
    } else {
      const VkImageView view = context.view(run.image(b.source, b.index), b.source == TY_SOURCE_LIGHT_COOKIE
                                                                              ? run.refs->cookieViews[run.light]
                                                                              : viewOf(run.built->layout, b));
      if (b.access == TY_ACCESS_SAMPLED)
        descriptors.sampled(b.binding, view, samplerOf(context.device(), b.sampler),
                            sampledLayout(*run.built, run.pass, b));
      else
        descriptors.storageImage(b.binding, view);
    }
  }
  descriptors.push();
}

VkClearColorValue clearColor(const Run& run, const TyTarget& target) {
  VkClearColorValue value{};
  const bool integer = target.source == TY_SOURCE_IMAGE && isInteger(run.built->layout.images[target.index].d.format);
  for (int i = 0; i < 4; ++i) {
    if (integer)
      value.uint32[i] = static_cast<std::uint32_t>(std::clamp(target.clear[i], 0.0f, 4294967040.0f));
    else
      value.float32[i] = target.clear[i];
  }
  return value;
}

void beginRendering(PassContext& context, const Run& run) {
  const auto view = [](const TyTarget& t) { return gpu::ViewDesc{t.mip, 1, t.layer, 1, false}; };
  std::vector<PassContext::ColorAttachment> colors;
  for (const TyTarget& t : run.layoutPass().targets)
    colors.push_back({run.image(t.source, t.index), t.load == 0, clearColor(run, t), view(t)});
  if (const auto& t = run.layoutPass().depthTarget) {
    const PassContext::DepthAttachment depth{run.image(t->source, t->index), t->load == 0, t->clear[0], false,
                                             view(*t)};
    context.beginRendering(std::move(colors), &depth);
  } else {
    context.beginRendering(std::move(colors));
  }
}

void record(PassContext& context, const Run& run) {
  const TyPass& d = run.layoutPass().d;
  if (d.kind == TY_PASS_FULL_SCREEN) {
    beginRendering(context, run);
    bind(context, run);
    vkCmdDraw(context.commands(), 3, 1, 0, 0);
    context.endRendering();
    return;
  }
  bind(context, run);
  if (d.kind == TY_PASS_COMPUTE)
    vkCmdDispatch(context.commands(), d.groups[0], d.groups[1], d.groups[2]);
  else
    vkCmdDispatchIndirect(context.commands(), context.buffer(run.refs->buffers[d.indirect_buffer]), d.indirect_offset);
}

Use useFor(PassAccess access, bool compute, bool partOfWritten) {
  switch (access) {
    case PassAccess::kSampled: return compute ? Use::kSampledCompute : Use::kSampledGraphics;
    // A fragment shader's read-only storage buffer: the graph has no other use for it.
    case PassAccess::kStorageRead: return compute ? Use::kStorageReadCompute : Use::kSampledGraphics;
    // "Old contents are lost" is true of the part that is bound; the rest of the image must survive.
    case PassAccess::kStorageWrite: return partOfWritten ? Use::kStorageReadWriteCompute : Use::kStorageWriteCompute;
    case PassAccess::kStorageReadWrite: return Use::kStorageReadWriteCompute;
    case PassAccess::kSampledStorage: return Use::kSampledStorageCompute;
    case PassAccess::kColorWrite: return partOfWritten ? Use::kColorReadWrite : Use::kColorWrite;
    case PassAccess::kColorReadWrite: return Use::kColorReadWrite;
    case PassAccess::kDepthWrite: return partOfWritten ? Use::kDepthReadWrite : Use::kDepthWrite;
    case PassAccess::kDepthReadWrite: return Use::kDepthReadWrite;
    case PassAccess::kIndirect: return Use::kIndirect;
  }
  return Use::kSampledCompute;
}

void clearHistory(render::Graph& graph, const std::shared_ptr<Built>& built,
                  const std::shared_ptr<const FrameRefs>& refs, const std::string& owner) {
  auto pass = graph.pass("clear history", owner);
  std::vector<std::uint32_t> images, buffers;
  for (std::uint32_t i = 0; i < refs->images.size(); ++i)
    if (isHistory(built->layout.images[i])) images.push_back(i), pass.use(refs->images[i], Use::kTransferWrite);
  for (std::uint32_t i = 0; i < refs->buffers.size(); ++i)
    if (isHistory(built->layout.buffers[i])) buffers.push_back(i), pass.use(refs->buffers[i], Use::kTransferWrite);
  pass.keep().run([built, refs, images, buffers](PassContext& context) {
    for (const std::uint32_t i : images) {
      const bool depth = built->layout.images[i].d.format == TY_FORMAT_D32_FLOAT;
      const VkImageSubresourceRange all{
          static_cast<VkImageAspectFlags>(depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT), 0,
          VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
      const VkImage image = context.image(refs->images[i]);
      const VkClearColorValue black{};
      const VkClearDepthStencilValue zero{};
      if (depth)
        vkCmdClearDepthStencilImage(context.commands(), image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &zero, 1, &all);
      else
        vkCmdClearColorImage(context.commands(), image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &black, 1, &all);
    }
    for (const std::uint32_t i : buffers)
      vkCmdFillBuffer(context.commands(), context.buffer(refs->buffers[i]), 0, VK_WHOLE_SIZE, 0);
    built->resources.historyCleared = true;
  });
}

std::shared_ptr<FrameRefs> declare(const render::EffectInput& input, Built& built, const std::string& owner) {
  auto refs = std::make_shared<FrameRefs>();
  const Layout& layout = built.layout;
  refs->depth = input.depth;
  refs->recorded = std::make_shared<std::vector<bool>>(built.runs.size());
  refs->idle = std::make_shared<std::vector<bool>>(built.runs.size());
  for (const render::ShadowedLight& light : input.lights) {
    refs->shadowMaps.push_back(light.shadowMap);
    refs->shadowMoments.push_back(light.moments);
    refs->cookies.push_back(light.cookie);
    refs->cookieViews.push_back({0, 0, light.cookieLayer, std::max(1u, light.cookieFaces), true});
  }
  const VkImageLayout before = built.resources.historyCleared ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_UNDEFINED;
  for (std::size_t i = 0; i < layout.images.size(); ++i) {
    const bool history = isHistory(layout.images[i]);
    refs->images.push_back(history ? input.graph.import(built.resources.images[i], before, VK_IMAGE_LAYOUT_GENERAL)
                                   : input.graph.image(describe(layout.images[i]), owner));
    refs->imageHasContents.push_back(history);
  }
  for (std::size_t i = 0; i < layout.buffers.size(); ++i)
    refs->buffers.push_back(
        isHistory(layout.buffers[i])
            ? input.graph.import(built.resources.buffers[i])
            : input.graph.buffer({.name = layout.buffers[i].name, .size = layout.buffers[i].d.size}, owner));
  gpu::ImageDesc output;
  output.name = owner + " output";
  output.format = VK_FORMAT_R32G32B32A32_SFLOAT;
  output.width = input.view.width;
  output.height = input.view.height;
  refs->output = input.graph.image(output, owner);
  for (const PassRun& run : built.runs)
    for (const PassUse& use : built.uses[run.pass])
      if (use.resource.source == TY_SOURCE_IMAGE && writesTo(use.access))
        refs->imageHasContents[use.resource.index] = true;
  return refs;
}

void readCounters(render::Graph& graph, const std::shared_ptr<Built>& built,
                  const std::shared_ptr<const FrameRefs>& refs, const std::string& owner, std::uint32_t slot) {
  const auto from = refs->buffers[built->layout.counters->buffer];
  const auto to = graph.import(built->resources.counterSlots[slot]);
  graph.pass("read counters", owner)
      .use(from, Use::kTransferRead)
      .use(to, Use::kTransferWrite)
      .keep()
      .run([built, from, to, slot](PassContext& context) {
        const VkBufferCopy copy{0, 0, built->resources.counterSlots[slot].size()};
        vkCmdCopyBuffer(context.commands(), context.buffer(from), context.buffer(to), 1, &copy);
        VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,   nullptr,
                                 VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                 VK_PIPELINE_STAGE_2_HOST_BIT,         VK_ACCESS_2_HOST_READ_BIT};
        VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
        info.memoryBarrierCount = 1;
        info.pMemoryBarriers = &barrier;
        vkCmdPipelineBarrier2(context.commands(), &info);
      });
}

}  // namespace

std::uint64_t bytesUsed(const Built& built, const FrameRefs& refs) {
  const Layout& layout = built.layout;
  std::vector<bool> images(layout.images.size()), buffers(layout.buffers.size());
  bool output = false;
  for (std::size_t r = 0; r < built.runs.size(); ++r) {
    if (!(*refs.recorded)[r]) continue;
    for (const PassUse& use : built.uses[built.runs[r].pass]) {
      if (use.resource.source == TY_SOURCE_IMAGE) images[use.resource.index] = true;
      if (use.resource.source == TY_SOURCE_BUFFER) buffers[use.resource.index] = true;
      output |= use.resource.source == TY_SOURCE_OUTPUT;
    }
  }
  if (layout.counters && !layout.counters->names.empty()) buffers[layout.counters->buffer] = true;
  std::uint64_t bytes = output ? built.outputBytes() : 0;
  for (std::size_t i = 0; i < images.size(); ++i)
    if (images[i] || isHistory(layout.images[i])) bytes += imageBytes(layout.images[i].d);
  for (std::size_t i = 0; i < buffers.size(); ++i)
    if (buffers[i] || isHistory(layout.buffers[i])) bytes += layout.buffers[i].d.size;
  return bytes;
}

std::vector<std::uint64_t> bytesOfLights(const Built& built, const FrameRefs& refs) {
  const Layout& layout = built.layout;
  std::vector<std::uint64_t> bytes(refs.shadowMaps.size(), 0);
  for (std::uint32_t light = 0; light < bytes.size(); ++light) {
    std::vector<bool> images(layout.images.size()), buffers(layout.buffers.size());
    for (std::size_t r = 0; r < built.runs.size(); ++r) {
      if (built.runs[r].light != light || !(*refs.recorded)[r] || (*refs.idle)[r]) continue;
      for (const PassUse& use : built.uses[built.runs[r].pass]) {
        if (use.resource.source == TY_SOURCE_IMAGE) images[use.resource.index] = true;
        if (use.resource.source == TY_SOURCE_BUFFER) buffers[use.resource.index] = true;
      }
    }
    for (std::size_t i = 0; i < images.size(); ++i)
      if (images[i]) bytes[light] += imageBytes(layout.images[i].d);
    for (std::size_t i = 0; i < buffers.size(); ++i)
      if (buffers[i]) bytes[light] += layout.buffers[i].d.size;
  }
  return bytes;
}

std::optional<std::uint64_t> bytesMoved(const Built& built, const FrameRefs& refs) {
  std::uint64_t bytes = 0;
  std::uint32_t only = TY_NONE;
  for (std::size_t r = 0; r < built.runs.size(); ++r) {
    if (!(*refs.recorded)[r] || (*refs.idle)[r]) continue;
    const std::uint32_t light = built.runs[r].light;
    if (light != TY_NONE && only != TY_NONE && light != only) return std::nullopt;
    if (light != TY_NONE) only = light;
    bytes += built.moved[built.runs[r].pass];
  }
  return bytes;
}

bool isRunOf(const std::string& graphName, const std::string& name) {
  return graphName == name || graphName.starts_with(name + " [light ");
}

std::shared_ptr<const FrameRefs> addFramePasses(const render::EffectInput& input, const std::shared_ptr<Built>& built,
                                                const std::string& owner, std::uint32_t slot) {
  const auto refs = declare(input, *built, owner);
  const Layout& layout = built->layout;
  const bool history =
      std::any_of(layout.images.begin(), layout.images.end(), [](const LayoutImage& i) { return isHistory(i); }) ||
      std::any_of(layout.buffers.begin(), layout.buffers.end(), [](const LayoutBuffer& b) { return isHistory(b); });
  if (history && !built->resources.historyCleared) clearHistory(input.graph, built, refs, owner);
  const bool counters = layout.counters && !layout.counters->names.empty();
  if (layout.counters) {
    const auto buffer = refs->buffers[layout.counters->buffer];
    input.graph.pass("clear counters", owner).use(buffer, Use::kTransferWrite).run([buffer](PassContext& context) {
      vkCmdFillBuffer(context.commands(), context.buffer(buffer), 0, VK_WHOLE_SIZE, 0);
    });
  }

  std::vector<LayoutResource> written;
  for (std::size_t index = 0; index < built->runs.size(); ++index) {
    const PassRun& passRun = built->runs[index];
    const LayoutPass& p = layout.passes[passRun.pass];
    const Run run{built, refs, passRun.pass, passRun.light, slot};
    const auto recorded = [all = refs->recorded, index] { (*all)[index] = true; };
    const bool compute = p.d.kind == TY_PASS_COMPUTE || p.d.kind == TY_PASS_COMPUTE_INDIRECT;
    auto pass = input.graph.pass(
        passRun.light == TY_NONE ? p.name : p.name + " [light " + std::to_string(passRun.light) + "]", owner);
    for (const PassUse& use : built->uses[passRun.pass]) {
      const bool before = std::find(written.begin(), written.end(), use.resource) != written.end();
      if (writesTo(use.access) && !before) written.push_back(use.resource);
      if (use.resource.source == TY_SOURCE_BUFFER) {
        pass.use(refs->buffers[use.resource.index], useFor(use.access, compute, before));
        continue;
      }
      bool parts = false, kept = false;
      if (use.resource.source == TY_SOURCE_IMAGE) {
        const LayoutImage& image = layout.images[use.resource.index];
        parts = image.d.mips > 1 || image.d.depth > 1;
        kept = isHistory(image);
      }
      pass.use(run.image(use.resource.source, use.resource.index),
               useFor(use.access, compute, parts && (before || kept)));
    }
    if (built->uniforms.skipped(passRun.pass, run.block())) {
      pass.idle().run([recorded, idle = refs->idle, index](PassContext&) { recorded(), (*idle)[index] = true; });
      continue;
    }
    if (p.d.kind != TY_PASS_CASTERS) {
      pass.run([run, recorded](PassContext& context) { recorded(), record(context, run); });
      continue;
    }
    glm::mat4 clipFromWorld{1};
    std::memcpy(&clipFromWorld[0][0], built->uniforms.staged(p.d.caster_uniform, run.block()), sizeof clipFromWorld);
    pass.run([run, recorded, clipFromWorld, draw = input.drawCasters](PassContext& context) {
      recorded();
      beginRendering(context, run);
      draw(context, clipFromWorld);
      context.endRendering();
    });
  }
  if (counters) readCounters(input.graph, built, refs, owner, slot);
  return refs;
}

}  // namespace tyndall::host
