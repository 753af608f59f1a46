#include "pipelines.hpp"

#include <iterator>

#include "base/assert.hpp"
#include "full_screen_vert.h"
#include "resources.hpp"
#include "spirv_interface.hpp"

namespace tyndall::host {
namespace {

VkDescriptorType descriptorType(const TyBinding& binding) {
  if (binding.source == TY_SOURCE_UNIFORM) return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  if (binding.source == TY_SOURCE_BUFFER) return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  return binding.access == TY_ACCESS_SAMPLED ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                             : VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
}

VkFormat targetFormat(const Layout& layout, const TyTarget& target) {
  return target.source == TY_SOURCE_OUTPUT ? VK_FORMAT_R32G32B32A32_SFLOAT
                                           : vulkanFormat(layout.images[target.index].d.format);
}

gpu::ColorTarget colorTarget(const Layout& layout, const TyTarget& target) {
  gpu::ColorTarget color;
  color.format = targetFormat(layout, target);
  color.blend = target.blend != TY_BLEND_NONE;
  color.sourceFactor = color.sourceAlphaFactor = VK_BLEND_FACTOR_ONE;
  color.destinationFactor = color.destinationAlphaFactor = VK_BLEND_FACTOR_ONE;  // min and max ignore the factors
  color.op = target.blend == TY_BLEND_MIN   ? VK_BLEND_OP_MIN
             : target.blend == TY_BLEND_MAX ? VK_BLEND_OP_MAX
                                            : VK_BLEND_OP_ADD;
  return color;
}

std::string keyOf(const Layout& layout, const LayoutPass& pass, const gpu::Shader& shader) {
  std::string key = pass.shader + '#' + std::to_string(shader.version);
  const auto add = [&key](std::uint64_t number) { key += ',' + std::to_string(number); };
  for (const TyBinding& b : pass.bindings) add(b.binding), add(static_cast<std::uint64_t>(descriptorType(b)));
  key += 's';
  for (const TySpecialization& s : pass.specializations) add(s.id), add(s.value);
  key += 't';
  for (const TyTarget& t : pass.targets) add(static_cast<std::uint64_t>(targetFormat(layout, t))), add(t.blend);
  key += pass.depthTarget ? 'd' : '-';
  add(pass.d.depth_compare);
  return key;
}

}  // namespace

Pipelines::Pipelines(gpu::Device& device, const std::filesystem::path& shaderFolder)
    : device_(device), shaders_(shaderFolder) {
  auto shader = std::make_shared<gpu::Shader>();
  shader->name = "full_screen.vert";
  shader->code.assign(std::begin(kFullScreenVert), std::end(kFullScreenVert));
  fullScreen_ = std::move(shader);
}

Result<gpu::Pipeline> makePipeline(gpu::Device& device, const PipelinePlan& plan) {
  return plan.graphics ? gpu::createPipeline(device, plan.fullScreen) : gpu::createPipeline(device, plan.compute);
}

Result<PipelinePlan> Pipelines::planOf(const Layout& layout, const LayoutPass& pass,
                                       std::shared_ptr<const gpu::Shader> shader) const {
  std::vector<gpu::Binding> bindings;
  std::vector<ShaderBinding> given;
  for (const TyBinding& b : pass.bindings) {
    bindings.push_back({b.binding, descriptorType(b)});
    given.push_back({b.binding, descriptorType(b)});
  }
  if (auto agree = checkShaderBindings(shader->code, given); !agree)
    return failed("shader '" + pass.shader + "' of pass '" + pass.name + "' " + agree.error().message);
  std::vector<gpu::Specialization> constants;
  for (const TySpecialization& s : pass.specializations) constants.push_back({s.id, s.value});

  PipelinePlan plan;
  plan.key = keyOf(layout, pass, *shader);
  plan.graphics = pass.d.kind == TY_PASS_FULL_SCREEN;
  if (!plan.graphics) {
    plan.compute.name = pass.name;
    plan.compute.shader = std::move(shader);
    plan.compute.bindings = std::move(bindings);
    plan.compute.specialization = std::move(constants);
    return plan;
  }
  gpu::GraphicsPipelineDesc& desc = plan.fullScreen;
  desc.name = pass.name;
  desc.vertex = fullScreen_;
  desc.fragment = std::move(shader);
  desc.bindings = std::move(bindings);
  desc.specialization = std::move(constants);
  for (const TyTarget& t : pass.targets) desc.colors.push_back(colorTarget(layout, t));
  if (pass.depthTarget) {
    desc.depthFormat = VK_FORMAT_D32_SFLOAT;
    desc.depthTest = desc.depthWrite = true;
    desc.depthCompare = pass.d.depth_compare == 1   ? VK_COMPARE_OP_LESS_OR_EQUAL
                        : pass.d.depth_compare == 2 ? VK_COMPARE_OP_GREATER_OR_EQUAL
                                                    : VK_COMPARE_OP_ALWAYS;
  }
  return plan;
}

Result<std::vector<std::optional<PipelinePlan>>> Pipelines::plan(const Layout& layout) {
  std::vector<std::optional<PipelinePlan>> plans;
  for (const LayoutPass& pass : layout.passes) {
    if (pass.d.kind == TY_PASS_CASTERS) {
      plans.emplace_back();
      continue;
    }
    auto shader = shaders_.get(pass.shader);
    if (!shader) return shader.error();
    auto plan = planOf(layout, pass, shader.take());
    if (!plan) return plan.error();
    plans.push_back(plan.take());
  }
  return plans;
}

PipelinePtr Pipelines::find(const std::string& key) const {
  const auto found = made_.find(key);
  return found == made_.end() ? nullptr : found->second;
}

Result<std::vector<PipelinePtr>> Pipelines::of(const std::vector<std::optional<PipelinePlan>>& plans) {
  std::map<std::string, PipelinePtr> fresh;
  for (const auto& plan : plans) {
    if (!plan || has(plan->key) || fresh.contains(plan->key)) continue;
    auto made = makePipeline(device_, *plan);
    if (!made) return made.error();
    fresh[plan->key] = std::make_shared<const gpu::Pipeline>(made.take());
  }
  return adopt(plans, std::move(fresh));
}

std::vector<PipelinePtr> Pipelines::adopt(const std::vector<std::optional<PipelinePlan>>& plans,
                                          std::map<std::string, PipelinePtr> fresh) {
  std::vector<PipelinePtr> pipelines;
  std::map<std::string, PipelinePtr> used;
  for (const auto& plan : plans) {
    if (!plan) {
      pipelines.push_back(nullptr);
      continue;
    }
    const auto kept = made_.find(plan->key);
    const PipelinePtr& pipeline = used[plan->key] = kept != made_.end() ? kept->second : fresh[plan->key];
    TY_ASSERT(pipeline, "nobody made the pipeline " + plan->key);
    pipelines.push_back(pipeline);
  }
  made_ = std::move(used);
  return pipelines;
}

std::vector<std::string> Pipelines::reload(bool& changed) {
  std::vector<std::string> lines;
  const auto reloaded = shaders_.reloadChanged();
  for (const std::string& name : reloaded.changed) lines.push_back(name + ": reloaded");
  for (const Error& error : reloaded.errors) lines.push_back(error.message);
  changed = !reloaded.changed.empty();
  return lines;
}

}  // namespace tyndall::host
