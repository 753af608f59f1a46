#include "layout_builder.hpp"

#include <algorithm>
#include <string_view>

namespace volumetrics {
namespace {

TyBinding bind(std::uint32_t binding, TySource source, std::uint32_t index, TyAccess access,
               TySampler sampler = TY_SAMPLER_NEAREST_CLAMP) {
  TyBinding made{};
  made.struct_size = sizeof(TyBinding);
  made.binding = binding;
  made.source = source;
  made.index = index;
  made.access = access;
  made.sampler = sampler;
  return made;
}

}  // namespace

TyBinding uniformAt(std::uint32_t binding, std::uint32_t block) {
  return bind(binding, TY_SOURCE_UNIFORM, block, TY_ACCESS_UNIFORM);
}
TyBinding sceneDepthAt(std::uint32_t binding) { return bind(binding, TY_SOURCE_SCENE_DEPTH, 0, TY_ACCESS_SAMPLED); }
TyBinding shadowMapAt(std::uint32_t binding) { return bind(binding, TY_SOURCE_SHADOW_MAP, 0, TY_ACCESS_SAMPLED); }
TyBinding shadowMomentsAt(std::uint32_t binding) {
  return bind(binding, TY_SOURCE_SHADOW_MOMENTS, 0, TY_ACCESS_SAMPLED, TY_SAMPLER_LINEAR_MIPMAP_CLAMP);
}

TyBinding lightCookieAt(std::uint32_t binding, bool cookies) {
  if (!cookies) return shadowMapAt(binding);
  return bind(binding, TY_SOURCE_LIGHT_COOKIE, 0, TY_ACCESS_SAMPLED, TY_SAMPLER_LINEAR_MIPMAP_REPEAT);
}
TyBinding outputAt(std::uint32_t binding, TyAccess access) { return bind(binding, TY_SOURCE_OUTPUT, 0, access); }
TyBinding sampledAt(std::uint32_t binding, std::uint32_t image, TySampler sampler) {
  return bind(binding, TY_SOURCE_IMAGE, image, TY_ACCESS_SAMPLED, sampler);
}
TyBinding storageAt(std::uint32_t binding, std::uint32_t image, TyAccess access) {
  return bind(binding, TY_SOURCE_IMAGE, image, access);
}
TyBinding bufferAt(std::uint32_t binding, std::uint32_t buffer, TyAccess access) {
  return bind(binding, TY_SOURCE_BUFFER, buffer, access);
}

TyBinding mipOf(TyBinding binding, std::uint32_t mip) {
  binding.base_mip = mip;
  binding.mip_count = 1;
  return binding;
}

void LayoutBuilder::clear() { *this = LayoutBuilder(); }

std::uint32_t LayoutBuilder::image(const char* name, TyFormat format, std::uint32_t width, std::uint32_t height,
                                   std::uint32_t layers, bool array, std::uint32_t mips) {
  TyImage made{};
  made.struct_size = sizeof(TyImage);
  made.kind = array ? TY_IMAGE_2D_ARRAY : TY_IMAGE_2D;
  made.name = name;
  made.format = format;
  made.width = width;
  made.height = height;
  made.depth = layers;
  made.mips = mips;
  const auto sameName = [&](const TyImage& other) { return std::string_view(other.name) == made.name; };
  for (auto found = std::find_if(images_.begin(), images_.end(), sameName); found != images_.end();
       found = std::find_if(images_.begin(), images_.end(), sameName)) {
    if (found->kind == made.kind && found->format == format && found->width == width && found->height == height &&
        found->depth == layers && found->mips == mips)
      return static_cast<std::uint32_t>(found - images_.begin());
    made.name = names_.emplace_back(std::string(made.name) + " (other lights)").c_str();
  }
  images_.push_back(made);
  return static_cast<std::uint32_t>(images_.size() - 1);
}

std::uint32_t LayoutBuilder::buffer(const char* name, std::uint64_t bytes) {
  for (std::size_t i = 0; i < buffers_.size(); ++i)
    if (std::string_view(buffers_[i].name) == name && buffers_[i].size == bytes) return static_cast<std::uint32_t>(i);
  TyBuffer made{};
  made.struct_size = sizeof(TyBuffer);
  made.name = name;
  made.size = bytes;
  buffers_.push_back(made);
  return static_cast<std::uint32_t>(buffers_.size() - 1);
}

std::uint32_t LayoutBuilder::uniform(std::string name, std::uint32_t bytes, bool perLight) {
  TyUniformBlock made{};
  made.struct_size = sizeof(TyUniformBlock);
  made.per_light = perLight ? 1 : 0;
  made.name = names_.emplace_back(std::move(name)).c_str();
  made.size = bytes;
  uniforms_.push_back(made);
  return static_cast<std::uint32_t>(uniforms_.size() - 1);
}

std::uint32_t LayoutBuilder::compute(ComputePass pass) {
  pass.specializations.insert(pass.specializations.end(), common_.begin(), common_.end());
  for (TyBinding& binding : pass.bindings)
    if (binding.source == TY_SOURCE_UNIFORM && binding.index == substituted_) binding.index = substitute_;
  if (pass.lightKinds == kEachLight) {
    pass.lightKinds = roles_.classes.back().kinds;
    roles_.classes.back().passes.push_back(static_cast<std::uint32_t>(passes_.size()));
    const bool result = std::any_of(pass.bindings.begin(), pass.bindings.end(),
                                    [](const TyBinding& binding) { return binding.source == TY_SOURCE_OUTPUT; });
    if ((pass.lightKinds & kLocalLights) != 0 && !result)
      roles_.localRowPasses.push_back(static_cast<std::uint32_t>(passes_.size()));
  }
  passData_.push_back(std::move(pass));
  const ComputePass& data = passData_.back();
  TyPass made{};
  made.struct_size = sizeof(TyPass);
  made.kind = TY_PASS_COMPUTE;
  made.name = data.name.c_str();
  made.shader = data.shader;
  made.bindings = data.bindings.data();
  made.binding_count = static_cast<std::uint32_t>(data.bindings.size());
  made.per_light = data.lightKinds != 0 ? 1 : 0;
  made.light_kinds = data.lightKinds;
  made.groups[0] = data.groupsX;
  made.groups[1] = data.groupsY;
  made.groups[2] = data.groupsZ;
  made.specializations = data.specializations.data();
  made.specialization_count = static_cast<std::uint32_t>(data.specializations.size());
  made.indirect_buffer = TY_NONE;
  made.caster_uniform = TY_NONE;
  passes_.push_back(made);
  const auto index = static_cast<std::uint32_t>(passes_.size() - 1);
  if ((data.lightKinds & kLocalLights) != 0) roles_.localPasses.push_back(index);
  return index;
}

std::uint32_t LayoutBuilder::casters(std::string name, std::uint32_t image, std::uint32_t layer,
                                     std::uint32_t uniformBlock) {
  names_.push_back(std::move(name));
  TyTarget& target = targets_.emplace_back();
  target.struct_size = sizeof(TyTarget);
  target.source = TY_SOURCE_IMAGE;
  target.index = image;
  target.layer = layer;
  target.clear[0] = 1.0f;
  TyPass made{};
  made.struct_size = sizeof(TyPass);
  made.kind = TY_PASS_CASTERS;
  roles_.classes.back().passes.push_back(static_cast<std::uint32_t>(passes_.size()));
  made.name = names_.back().c_str();
  made.per_light = 1;
  made.light_kinds = 1u << TY_LIGHT_DIRECTIONAL;
  made.depth_target = &target;
  made.depth_compare = 1;
  made.indirect_buffer = TY_NONE;
  made.caster_uniform = uniformBlock;
  passes_.push_back(made);
  return static_cast<std::uint32_t>(passes_.size() - 1);
}

void LayoutBuilder::debugView(std::string name, std::string doc, TySource source, std::uint32_t index,
                              std::uint32_t layer, std::uint32_t channel, float low, float high, TyViewRole role) {
  if (std::any_of(views_.begin(), views_.end(), [&](const TyDebugView& view) { return name == view.name; })) return;
  TyDebugView made{};
  made.struct_size = sizeof(TyDebugView);
  made.source = source;
  made.name = names_.emplace_back(std::move(name)).c_str();
  made.doc = names_.emplace_back(std::move(doc)).c_str();
  made.index = index;
  made.layer = layer;
  made.channel = channel;
  made.low = low;
  made.high = high;
  made.role = role;
  views_.push_back(made);
}

void LayoutBuilder::tunable(std::uint32_t parameter, double automatic, std::vector<double> variants,
                            std::vector<const char*> passes) {
  if (std::any_of(tunables_.begin(), tunables_.end(),
                  [&](const TyTunable& other) { return other.parameter == parameter; }))
    return;
  variants_.push_back(std::move(variants));
  passNames_.push_back(std::move(passes));
  TyTunable made{};
  made.struct_size = sizeof(TyTunable);
  made.parameter = parameter;
  made.automatic = automatic;
  made.variants = variants_.back().data();
  made.variant_count = static_cast<std::uint32_t>(variants_.back().size());
  made.passes = passNames_.back().data();
  made.pass_count = static_cast<std::uint32_t>(passNames_.back().size());
  tunables_.push_back(made);
}

const TyLayout& LayoutBuilder::finish() {
  layout_ = {};
  layout_.struct_size = sizeof(TyLayout);
  layout_.images = images_.data();
  layout_.image_count = static_cast<std::uint32_t>(images_.size());
  layout_.buffers = buffers_.data();
  layout_.buffer_count = static_cast<std::uint32_t>(buffers_.size());
  layout_.uniforms = uniforms_.data();
  layout_.uniform_count = static_cast<std::uint32_t>(uniforms_.size());
  layout_.passes = passes_.data();
  layout_.pass_count = static_cast<std::uint32_t>(passes_.size());
  layout_.debug_views = views_.data();
  layout_.debug_view_count = static_cast<std::uint32_t>(views_.size());
  layout_.tunables = tunables_.data();
  layout_.tunable_count = static_cast<std::uint32_t>(tunables_.size());
  return layout_;
}

}  // namespace volumetrics
