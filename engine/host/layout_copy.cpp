// From the plugin's memory into ours.
#include "host/layout.hpp"

namespace tyndall::host {
namespace {

std::string at(const char* what, std::size_t i) { return std::string(what) + "[" + std::to_string(i) + "]"; }

Result<std::vector<std::string>> readNames(const char* const* names, std::uint32_t count, const std::string& what) {
  if (count > kMostElements || (count > 0 && names == nullptr))
    return failed(what + ": the list of names is null or too long");
  std::vector<std::string> read;
  for (std::uint32_t i = 0; i < count; ++i) {
    auto name = readName(names[i], what + ": name " + std::to_string(i));
    if (!name) return name.error();
    read.push_back(name.take());
  }
  return read;
}

/// Arrays of structs that carry no size of their own.
template <class T>
Result<std::vector<T>> readPlain(const T* first, std::uint32_t count, const std::string& what) {
  if (count > kMostElements || (count > 0 && first == nullptr)) return failed(what + ": the array is null or too long");
  return count == 0 ? std::vector<T>{} : std::vector<T>(first, first + count);
}

/// Structs that hold nothing but numbers and a name.
template <class Copy, class T>
Result<void> copyNamed(std::vector<Copy>& to, const T* first, std::uint32_t count, const char* what) {
  auto read = readArray(first, count, what);
  if (!read) return read.error();
  for (std::size_t i = 0; i < read->size(); ++i) {
    T d = (*read)[i];
    auto name = readName(d.name, at(what, i) + ".name");
    if (!name) return name.error();
    d.name = nullptr;
    to.push_back({name.take(), d});
  }
  return {};
}

Result<LayoutPass> copyPass(const TyPass& from, const std::string& what) {
  LayoutPass pass;
  pass.d = from;
  auto name = readName(from.name, what + ".name");
  if (!name) return name.error();
  pass.name = name.take();
  const std::string here = "pass '" + pass.name + "'";
  // A caster pass draws with the host's own shaders.
  if (from.kind != TY_PASS_CASTERS || from.shader != nullptr) {
    auto shader = readText(from.shader, here + ": shader");
    if (!shader) return shader.error();
    pass.shader = shader.take();
  }
  auto bindings = readArray(from.bindings, from.binding_count, here + ": bindings");
  if (!bindings) return bindings.error();
  pass.bindings = bindings.take();
  auto constants = readPlain(from.specializations, from.specialization_count, here + ": specializations");
  if (!constants) return constants.error();
  pass.specializations = constants.take();
  auto targets = readArray(from.targets, from.target_count, here + ": targets");
  if (!targets) return targets.error();
  pass.targets = targets.take();
  if (from.depth_target != nullptr) pass.depthTarget = readStruct<TyTarget>(from.depth_target);
  pass.d.name = pass.d.shader = nullptr;
  pass.d.bindings = nullptr;
  pass.d.specializations = nullptr;
  pass.d.targets = pass.d.depth_target = nullptr;
  return pass;
}

}  // namespace

Result<Layout> copyLayout(const TyLayout* from) {
  if (from == nullptr) return failed("it gave no layout");
  const auto d = readStruct<TyLayout>(from);
  Layout layout;
  if (auto r = copyNamed(layout.images, d.images, d.image_count, "images"); !r) return r.error();
  if (auto r = copyNamed(layout.buffers, d.buffers, d.buffer_count, "buffers"); !r) return r.error();
  if (auto r = copyNamed(layout.uniforms, d.uniforms, d.uniform_count, "uniforms"); !r) return r.error();

  auto passes = readArray(d.passes, d.pass_count, "passes");
  if (!passes) return passes.error();
  for (std::size_t i = 0; i < passes->size(); ++i) {
    auto pass = copyPass((*passes)[i], at("passes", i));
    if (!pass) return pass.error();
    layout.passes.push_back(pass.take());
  }

  auto views = readArray(d.debug_views, d.debug_view_count, "debug_views");
  if (!views) return views.error();
  for (std::size_t i = 0; i < views->size(); ++i) {
    LayoutDebugView view;
    view.d = (*views)[i];
    auto name = readName(view.d.name, at("debug_views", i) + ".name");
    if (!name) return name.error();
    auto doc = readText(view.d.doc, at("debug_views", i) + ".doc");
    if (!doc) return doc.error();
    view.name = name.take();
    view.doc = doc.take();
    view.d.name = view.d.doc = nullptr;
    layout.debugViews.push_back(std::move(view));
  }

  if (d.counters != nullptr) {
    const auto counters = readStruct<TyCounters>(d.counters);
    auto names = readNames(counters.names, counters.name_count, "counters");
    if (!names) return names.error();
    layout.counters = LayoutCounters{counters.buffer, names.take()};
  }

  auto tunables = readArray(d.tunables, d.tunable_count, "tunables");
  if (!tunables) return tunables.error();
  for (std::size_t i = 0; i < tunables->size(); ++i) {
    const TyTunable& t = (*tunables)[i];
    auto variants = readPlain(t.variants, t.variant_count, at("tunables", i) + ".variants");
    if (!variants) return variants.error();
    auto names = readNames(t.passes, t.pass_count, at("tunables", i) + ".passes");
    if (!names) return names.error();
    layout.tunables.push_back({t.parameter, t.automatic, variants.take(), names.take()});
  }
  return layout;
}

}  // namespace tyndall::host
