#include <algorithm>

#include "draw_record.hpp"
#include "passes.hpp"

namespace tyndall::render {

namespace {

ShadowedLight describe(const FrameData& frame, const scene::LightView& light, const ShadowFit& fit, ImageRef map,
                       ImageRef moments, std::uint32_t size) {
  ShadowedLight out;
  out.light = light;
  out.shadowMap = map;
  out.moments = moments;
  out.faceCount = fit.faceCount;
  out.size = size;
  out.clipFromWorld = fit.clipFromWorld;
  out.casterCorners = boxCorners(frame.draws.casters, frame.view.eye);
  const shared::CookieBlock cookie = cookieBlock(light, frame.resources->cookies);
  out.cookie = cookie.faces ? frame.cookieArray : frame.noCookie;
  out.cookieLayer = cookie.layer;
  out.cookieFaces = cookie.faces;
  out.cookieRepeats = cookie.repeats;
  out.cookieFromWorld = cookie.cookieFromWorld;
  return out;
}

}  // namespace

Result<void> addShadowPasses(Graph& graph, const PassTools& tools, const std::shared_ptr<FrameData>& frame,
                             const std::vector<scene::LightView>& lights, ShadowCache* cache) {
  constexpr VkImageLayout kRead = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  if (cache) cache->keepOnly(frame->plan.shadowed);
  const Result<CasterPipelines> pipelines = casterPipelines(tools.pipelines);
  if (!pipelines) return pipelines.error();
  std::vector<std::pair<std::uint32_t, ShadowedLight>> inFileOrder;
  for (const PlannedLight& light : frame->plan.shadowed) {
    gpu::ImageDesc desc;
    desc.name = "shadow map of light " + std::to_string(light.source);
    desc.format = kDepthFormat;
    desc.width = desc.height = light.size;
    desc.layers = light.fit.faceCount;
    std::shared_ptr<KeptShadowMap> kept;
    const std::uint64_t content = cache ? shadowContent(*frame, light.fit) : 0;
    ImageRef map;
    if (cache) {
      const Result<std::shared_ptr<KeptShadowMap>> found = cache->map(light.source, desc);
      if (!found) return found.error();
      kept = *found;
      frame->keptShadowMaps.push_back(kept);
      map = graph.import(kept->image, kept->drawn ? kRead : VK_IMAGE_LAYOUT_UNDEFINED, kRead);
    } else {
      map = graph.image(desc);
    }
    frame->shadowMaps.push_back(map);

    if (!kept || !kept->drawn || kept->content != content) {
      graph.pass("shadow " + std::to_string(light.source))
          .use(map, Use::kDepthWrite)
          .run([frame = FramePointer(frame), pipelines = *pipelines, map, fit = light.fit, kept,
                content](PassContext& context) {
            for (std::uint32_t face = 0; face < fit.faceCount; ++face) {
              PassContext::DepthAttachment depth{map, true, 1.0f};
              depth.view.baseLayer = face;
              depth.view.layerCount = 1;
              context.beginRendering({}, &depth);
              if (fit.useful) recordCasters(context, *frame, pipelines, fit.clipFromWorld[face]);
              context.endRendering();
            }
            if (kept) kept->drawn = true, kept->content = content;
          });
    }

    ImageRef moments;
    if (frame->momentFormat != VK_FORMAT_UNDEFINED) {
      const Result<ImageRef> made = addMomentPasses(graph, tools, *frame, light, map);
      if (!made) return made.error();
      moments = *made;
    }
    frame->momentMaps.push_back(moments);
    inFileOrder.emplace_back(light.source, describe(*frame, lights[light.source], light.fit, map, moments, light.size));
  }
  std::sort(inFileOrder.begin(), inFileOrder.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [index, light] : inFileOrder) frame->shadowedLights.push_back(std::move(light));
  return {};
}

void bindLights(PassContext& context, const PassTools& tools, const FrameData& frame, gpu::Descriptors& descriptors,
                const LightBindings& bindings, std::uint32_t first, std::uint32_t count) {
  const BlockRange& blocks = frame.lightBlocks;
  descriptors
      .uniformBuffer(bindings.shadowed, blocks.buffer, blocks.offset + first * sizeof(shared::LightBlock),
                     kShadowSlots * sizeof(shared::LightBlock))
      .storageBuffer(bindings.all, blocks.buffer, blocks.offset, blocks.size);
  gpu::ViewDesc array;
  array.array = true;
  descriptors.sampled(bindings.cookies, frame.cookies ? frame.resources->cookies.image.view(array) : tools.unusedMap,
                      tools.samplers.cookie);
  for (std::uint32_t slot = 0; slot < kShadowSlots; ++slot) {
    if (slot >= count) {
      descriptors.sampled(bindings.firstMap + slot, tools.unusedMap, tools.samplers.texel);
      continue;
    }
    gpu::ViewDesc whole;
    whole.array = true;
    const VkImageView map = context.view(frame.surfaceMap(first + slot), whole);
    if (frame.surfaceMaps != ShadowMaps::kDepths) {
      descriptors.sampled(bindings.firstMap + slot, map, tools.samplers.trilinear);
      continue;
    }
    // Beyond a sun's or a spot's map everything is lit; a cube's neighbouring face is better guessed by the edge.
    const bool cube = frame.plan.shadowed[first + slot].fit.faceCount > 1;
    descriptors.sampled(bindings.firstMap + slot, map, cube ? tools.samplers.texel : tools.samplers.borderLit);
  }
}

}  // namespace tyndall::render
