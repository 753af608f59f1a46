// The exported entry: answers the host's calls from the registry of techniques.
#include <cstddef>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>

#include "layout_builder.hpp"
#include "registry.hpp"
#include "tyndall/plugin.h"

struct TyInstance {
  volumetrics::LayoutBuilder builder;
  const volumetrics::Technique* technique = nullptr;  ///< of the layout last returned; null: nothing to do
  std::uint32_t localLightsReported = 0;
  bool cookiesReported = false;
  bool linearImpossible = false;  ///< as last reported
  bool linearHandsOver = false;   ///< as last reported
  bool linearCookie = false;      ///< as last reported
  bool momentsMissing = false;    ///< as last reported
  bool scanImpossible = false;    ///< as last reported
};

namespace volumetrics {
namespace {

const TyHost* host = nullptr;

void say(std::uint32_t level, const std::string& line) {
  if (host != nullptr && host->log != nullptr) host->log(host->context, level, line.c_str());
}

bool init(const TyHost* given) {
  host = given;
  return true;
}

void shutdown() { host = nullptr; }

const TyParameter* parameters(std::uint32_t* count) {
  const auto table = parameterTable();
  *count = static_cast<std::uint32_t>(table.size());
  return table.data();
}

const TyTechnique* listTechniques(std::uint32_t* count, std::uint32_t* selector) {
  static const std::vector<TyTechnique> list = [] {
    std::vector<TyTechnique> made;
    for (const Technique& technique : techniques())
      made.push_back({sizeof(TyTechnique), static_cast<std::uint32_t>(technique.reads.size()), technique.id,
                      technique.name, technique.doc, technique.reads.data()});
    return made;
  }();
  *count = static_cast<std::uint32_t>(list.size());
  *selector = techniqueIndex();
  return list.data();
}

TyInstance* create() { return std::make_unique<TyInstance>().release(); }
void destroy(TyInstance* instance) { const std::unique_ptr<TyInstance> owned(instance); }

/// Says once per change how many lights the chosen technique cannot scatter, instead of leaving them out in silence.
void reportLocalLights(TyInstance& instance, std::uint32_t leftOut) {
  if (leftOut > instance.localLightsReported)
    say(TY_LOG_WARNING, std::to_string(leftOut) +
                            " spot or point light(s) light surfaces but scatter nothing with volumetrics.technique=" +
                            instance.technique->id + ": only directional lights do");
  instance.localLightsReported = leftOut;
}

const TyLayout* layout(TyInstance* instance, const TyDevice* device, const TyStructure* structure) try {
  LayoutContext context{*device, *structure, readSettings(structure->values, structure->value_count), 0,
                        TY_FORMAT_UNKNOWN};
  // A host of version 1.0 hands in a shorter struct.
  if (structure->struct_size >= offsetof(TyStructure, shadow_moments_format) + sizeof structure->shadow_moments_format)
    context.shadowMoments = structure->shadow_moments_format;
  const bool cookies =
      structure->struct_size >= offsetof(TyStructure, light_cookies) + sizeof structure->light_cookies &&
      structure->light_cookies != nullptr;
  for (std::uint32_t i = 0; i < structure->light_count; ++i) {
    const bool sun = structure->light_kinds[i] == TY_LIGHT_DIRECTIONAL;
    context.directionalLights += sun ? 1 : 0;
    if (cookies && structure->light_cookies[i] != 0) ++(sun ? context.sunCookies : context.localCookies);
  }
  instance->builder.clear();
  instance->technique = nullptr;
  const TyParameter& choice = parameterTable()[techniqueIndex()];
  const char* name = choice.choices[context.settings.technique];
  if (context.settings.enabled != 0 && std::string_view(name) != "none") {
    instance->technique = findTechnique(name);
    if (instance->technique == nullptr) {
      say(TY_LOG_ERROR, std::string("volumetrics.technique: '") + name + "' is not built yet");
      return nullptr;
    }
    reportLocalLights(*instance, instance->technique->localLights ? 0 : context.localLights());
    const bool cookiesLeftOut = !instance->technique->localLights && context.sunCookies > 0;
    if (cookiesLeftOut && !instance->cookiesReported)
      say(TY_LOG_WARNING, std::to_string(context.sunCookies) +
                              " directional light(s) scatter without their cookie with volumetrics.technique=" +
                              instance->technique->id);
    instance->cookiesReported = cookiesLeftOut;
    instance->technique->layout(context, instance->builder);
  }
  const bool missing = instance->builder.roles().momentsMissing;
  if (missing && !instance->momentsMissing)
    say(TY_LOG_WARNING,
        "volumetrics.filtered_resampling: this host makes no moment shadow maps; the rows are resampled unfiltered");
  instance->momentsMissing = missing;
  const bool noScan = instance->builder.roles().scanImpossible;
  if (noScan && !instance->scanImpossible)
    say(TY_LOG_WARNING,
        "volumetrics.prefix_scheme=scan: this device's shared memory does not hold a row of so many columns; rows are "
        "built "
        "by blocks");
  instance->scanImpossible = noScan;
  return &instance->builder.finish();
} catch (const std::exception& error) {
  say(TY_LOG_ERROR, std::string("layout failed: ") + error.what());
  return nullptr;
}

bool prepare(TyInstance* instance, const TyFrame* frame, const TyUniformData* out) try {
  if (instance->technique == nullptr) return true;
  volumetrics::FrameReport report;
  instance->technique->prepare(
      {*frame, *out, readSettings(frame->values, frame->value_count), instance->builder.roles(), report});
  if (report.linearImpossible && !instance->linearImpossible)
    say(TY_LOG_WARNING,
        "volumetrics.rectification=linear: no projective map exists while the light or its antipode is in view; "
        "the epipolar one is used until it does");
  instance->linearImpossible = report.linearImpossible;
  if (report.linearHandsOver && !instance->linearHandsOver)
    say(TY_LOG_WARNING,
        "volumetrics.rectification=linear: the light or its antipode is so near the screen, or the columns are so few, "
        "that the projective map degenerates; the epipolar one takes over in part or wholly until it does not");
  instance->linearHandsOver = report.linearHandsOver;
  if (report.linearCookie && !instance->linearCookie)
    say(TY_LOG_WARNING,
        "volumetrics.rectification=linear: a sun with a cookie is visible all along a ray, which projective maps do "
        "not hold; "
        "the epipolar one is used for it");
  instance->linearCookie = report.linearCookie;
  return true;
} catch (const std::exception& error) {
  say(TY_LOG_ERROR, std::string("prepare failed: ") + error.what());
  return false;
}

const void* extension(const char*) { return nullptr; }

}  // namespace
}  // namespace volumetrics

extern "C" TY_EXPORT const TyPlugin tyndall_plugin;
const TyPlugin tyndall_plugin = {
    TY_ABI_VERSION,
    sizeof(TyPlugin),
    "volumetrics",
    "Volumetrics",
    "0.1.0",
    "Single scattering in a homogeneous medium: god rays and volumetric shadows.",
    volumetrics::init,
    volumetrics::shutdown,
    volumetrics::parameters,
    volumetrics::listTechniques,
    volumetrics::create,
    volumetrics::destroy,
    volumetrics::layout,
    volumetrics::prepare,
    volumetrics::extension,
};
