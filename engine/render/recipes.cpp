#include "recipes.hpp"

#include <cstddef>
#include <string>

#include "scene/scene.hpp"
#include "shared/exposure.h"
#include "shared/light.h"

namespace tyndall::render {

namespace {

constexpr VkDescriptorType kUniform = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
constexpr VkDescriptorType kStorage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr VkDescriptorType kSampled = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;

void addSampled(std::vector<gpu::Binding>& bindings, std::uint32_t first, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) bindings.push_back({first + i, kSampled});
}

void setFacing(gpu::GraphicsPipelineDesc& desc, Facing facing) {
  desc.cull = facing == Facing::kBoth ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT;
  desc.frontFace = facing == Facing::kFrontMirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE;
}

const char* text(Facing facing) {
  return facing == Facing::kBoth ? "both faces" : facing == Facing::kFront ? "front" : "mirrored front";
}

template <class T>
VkVertexInputAttributeDescription attribute(std::uint32_t location, VkFormat format, T scene::Vertex::*member) {
  static const scene::Vertex vertex;
  const auto offset =
      reinterpret_cast<const std::byte*>(&(vertex.*member)) - reinterpret_cast<const std::byte*>(&vertex);
  return {location, 0, format, static_cast<std::uint32_t>(offset)};
}

void addVertices(gpu::GraphicsPipelineDesc& desc, bool position, bool shading, bool uvAndColor) {
  using scene::Vertex;
  desc.vertexBindings = {{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX}};
  if (position) desc.vertexAttributes.push_back(attribute(0, VK_FORMAT_R32G32B32_SFLOAT, &Vertex::position));
  if (shading) desc.vertexAttributes.push_back(attribute(1, VK_FORMAT_R32G32B32_SFLOAT, &Vertex::normal));
  if (shading) desc.vertexAttributes.push_back(attribute(2, VK_FORMAT_R32G32B32A32_SFLOAT, &Vertex::tangent));
  if (uvAndColor) desc.vertexAttributes.push_back(attribute(3, VK_FORMAT_R32G32_SFLOAT, &Vertex::uv));
  if (uvAndColor) desc.vertexAttributes.push_back(attribute(4, VK_FORMAT_R32G32B32A32_SFLOAT, &Vertex::color));
}

Recipe geometry(const std::string& name, const std::string& fragment, Facing facing, std::uint32_t textures) {
  Recipe recipe;
  recipe.vertex = "geometry.vert";
  recipe.fragment = fragment;
  recipe.desc.name = name + ", " + text(facing) + ", maps " + std::to_string(textures);
  recipe.desc.bindings = {{0, kUniform}, {1, kStorage}, {2, kUniform}};
  addSampled(recipe.desc.bindings, 3, 6);
  addVertices(recipe.desc, true, true, true);
  setFacing(recipe.desc, facing);
  recipe.desc.depthFormat = kDepthFormat;
  recipe.desc.depthTest = true;
  recipe.desc.depthCompare = VK_COMPARE_OP_GREATER_OR_EQUAL;  // reversed depth
  return recipe;
}

Recipe fullScreen(const std::string& name, const std::string& fragment, VkFormat target) {
  Recipe recipe;
  recipe.vertex = "fullscreen.vert";
  recipe.fragment = fragment;
  recipe.desc.name = name;
  recipe.desc.colors = {{target}};
  return recipe;
}

const char* cookiesText(bool cookies) { return cookies ? ", cookies" : ""; }

std::string mapsText(std::uint32_t slots, ShadowMaps maps) {
  static constexpr const char* kKinds[] = {" shadow maps", " quantised moment shadow maps", " moment shadow maps"};
  return std::to_string(slots) + kKinds[static_cast<std::uint32_t>(maps)];
}

}  // namespace

Recipe gbufferRecipe(Facing facing, bool mask, std::uint32_t textures) {
  Recipe recipe = geometry(mask ? "G-buffer, alpha-tested" : "G-buffer", "gbuffer.frag", facing, textures);
  recipe.desc.specialization = {{0, mask ? 1u : 0u}, {2, textures}};
  recipe.desc.colors = {{kBaseFormat}, {kNormalFormat}, {kEmissiveFormat}};
  recipe.desc.depthWrite = true;
  return recipe;
}

Recipe casterRecipe(bool mask) {
  Recipe recipe;
  recipe.vertex = mask ? "caster_mask.vert" : "caster.vert";
  recipe.fragment = mask ? "caster_mask.frag" : "";
  recipe.desc.name = mask ? "casters, alpha-tested" : "casters";
  recipe.desc.bindings = {{0, kStorage}, {1, kUniform}, {2, kSampled}};
  recipe.desc.pushConstantBytes = sizeof(glm::mat4);
  addVertices(recipe.desc, true, false, mask);
  // Both faces, also of single-sided surfaces: a wall shadows from either side.
  recipe.desc.cull = VK_CULL_MODE_NONE;
  recipe.desc.depthClamp = true;
  recipe.desc.depthFormat = kDepthFormat;
  recipe.desc.depthTest = recipe.desc.depthWrite = true;
  recipe.desc.depthCompare = VK_COMPARE_OP_LESS_OR_EQUAL;
  return recipe;
}

Recipe transparentRecipe(Facing facing, std::uint32_t textures, std::uint32_t slots, ShadowMaps maps, bool cookies) {
  Recipe recipe =
      geometry("transparent, " + mapsText(slots, maps) + cookiesText(cookies), "transparent.frag", facing, textures);
  recipe.desc.bindings.push_back({9, kUniform});
  addSampled(recipe.desc.bindings, 10, shared::kShadowSlots);
  recipe.desc.bindings.push_back({14, kStorage});
  recipe.desc.bindings.push_back({15, kSampled});
  recipe.desc.bindings.push_back({16, kUniform});
  recipe.desc.bindings.push_back({17, kSampled});
  recipe.desc.specialization = {
      {1, slots}, {2, textures}, {3, static_cast<std::uint32_t>(maps)}, {4, cookies ? 1u : 0u}};
  recipe.desc.pushConstantBytes = sizeof(UnshadowedLights);
  gpu::ColorTarget target{kColorFormat, true};
  target.sourceFactor = VK_BLEND_FACTOR_SRC_ALPHA;
  target.destinationFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  target.sourceAlphaFactor = VK_BLEND_FACTOR_ZERO;
  target.destinationAlphaFactor = VK_BLEND_FACTOR_ONE;
  recipe.desc.colors = {target};
  return recipe;
}

Recipe lightingRecipe(bool base, std::uint32_t slots, ShadowMaps maps, bool cookies) {
  Recipe recipe = fullScreen((base ? "lighting, " : "more lighting, ") + mapsText(slots, maps) + cookiesText(cookies),
                             "lighting.frag", kColorFormat);
  recipe.desc.bindings = {{0, kUniform}, {1, kUniform}};
  addSampled(recipe.desc.bindings, 2, 4 + shared::kShadowSlots);
  recipe.desc.bindings.push_back({10, kStorage});
  recipe.desc.bindings.push_back({11, kSampled});
  recipe.desc.bindings.push_back({12, kUniform});
  recipe.desc.bindings.push_back({13, kSampled});
  recipe.desc.specialization = {
      {0, base ? 1u : 0u}, {1, slots}, {3, static_cast<std::uint32_t>(maps)}, {4, cookies ? 1u : 0u}};
  recipe.desc.pushConstantBytes = sizeof(UnshadowedLights);
  gpu::ColorTarget& target = recipe.desc.colors[0];
  target.blend = !base;
  target.sourceFactor = target.destinationFactor = VK_BLEND_FACTOR_ONE;
  target.sourceAlphaFactor = VK_BLEND_FACTOR_ZERO;
  target.destinationAlphaFactor = VK_BLEND_FACTOR_ONE;
  return recipe;
}

Recipe compositeRecipe(bool scatter, bool metered) {
  Recipe recipe = fullScreen(
      std::string(scatter ? "composite with scatter" : "composite") + (metered ? ", automatic exposure" : ""),
      "composite.frag", kPictureFormat);
  addSampled(recipe.desc.bindings, 0, 2);
  recipe.desc.bindings.push_back({2, kStorage});
  recipe.desc.specialization = {{0, scatter ? 1u : 0u}, {1, metered ? 1u : 0u}};
  recipe.desc.pushConstantBytes = sizeof(float);
  return recipe;
}

Recipe distanceRecipe() {
  Recipe recipe = fullScreen("distance", "distance.frag", kDistanceFormat);
  addSampled(recipe.desc.bindings, 0, 1);
  recipe.desc.pushConstantBytes = sizeof(DistancePush);
  return recipe;
}

Recipe debugViewRecipe() {
  Recipe recipe = fullScreen("debug view", "debug_view.frag", kPictureFormat);
  addSampled(recipe.desc.bindings, 0, 1);
  recipe.desc.pushConstantBytes = sizeof(DebugPush);
  return recipe;
}

ComputeRecipe exposureMeterRecipe(bool scatter) {
  ComputeRecipe recipe;
  recipe.shader = "exposure_meter.comp";
  recipe.desc.name = scatter ? "exposure meter with scatter" : "exposure meter";
  recipe.desc.bindings = {{0, kSampled}, {1, kSampled}, {2, kSampled}, {3, kStorage}};
  recipe.desc.pushConstantBytes = sizeof(shared::MeterPush);
  recipe.desc.specialization = {{0, scatter ? 1u : 0u}};
  return recipe;
}

ComputeRecipe exposureAdaptRecipe() {
  ComputeRecipe recipe;
  recipe.shader = "exposure_adapt.comp";
  recipe.desc.name = "exposure adapt";
  recipe.desc.bindings = {{0, kStorage}, {1, kStorage}, {2, kStorage}};
  recipe.desc.pushConstantBytes = sizeof(shared::MeterPush);
  return recipe;
}

ComputeRecipe momentBlurRecipe(bool rows, VkFormat format) {
  const bool quantise = format == kMoments64Format;
  ComputeRecipe recipe;
  recipe.shader = "moments_blur.comp";
  recipe.desc.name = std::string(rows ? "moments blur x" : "moments blur y") + (quantise ? ", quantised" : "");
  recipe.desc.bindings = {{0, kSampled}, {1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}};
  recipe.desc.pushConstantBytes = sizeof(float);
  recipe.desc.specialization = {{0, rows ? 1u : 0u}, {1, quantise ? 1u : 0u}};
  return recipe;
}

ComputeRecipe skySpreadRecipe() {
  ComputeRecipe recipe;
  recipe.shader = "sky_spread.comp";
  recipe.desc.name = "sky maps";
  recipe.desc.bindings = {{0, kSampled}, {1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}};
  return recipe;
}

ComputeRecipe momentMipRecipe() {
  ComputeRecipe recipe;
  recipe.shader = "moments_mip.comp";
  recipe.desc.name = "moments mips";
  recipe.desc.bindings = {{0, kSampled}, {1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}};
  return recipe;
}

}  // namespace tyndall::render
