/* fog_depth: a template for plugins. Everything a plugin needs is here: a parameter table, a layout, prepare, the
 * entry. Written in C11 to show that the ABI asks for nothing more; C++ does as well. */
#include <stdlib.h>
#include <string.h>

#include "tyndall/plugin.h"

/* ---- Parameters: the host makes command line, presets, editor widgets and documentation from this. */

enum { kSigmaT, kAlbedo, kTile, kParameterCount };

static const char* const kTiles[] = {"8", "16"};

static const TyParameter kParameters[kParameterCount] = {
    [kSigmaT] = {.struct_size = sizeof(TyParameter),
                 .type = TY_PARAMETER_FLOAT,
                 .id = "fog_depth.sigma_t",
                 .name = "Extinction",
                 .unit = "1/m",
                 .doc = "Extinction coefficient of the fog.",
                 .default_value = 0.05,
                 .min_value = 0,
                 .max_value = 10},
    [kAlbedo] = {.struct_size = sizeof(TyParameter),
                 .type = TY_PARAMETER_FLOAT,
                 .id = "fog_depth.albedo",
                 .name = "Albedo",
                 .unit = "",
                 .doc = "Share of the extinguished light that is scattered instead of absorbed.",
                 .default_value = 0.8,
                 .min_value = 0,
                 .max_value = 1},
    /* Structural: a change needs other dispatch counts and another pipeline, so the host asks for a new layout. */
    [kTile] = {.struct_size = sizeof(TyParameter),
               .type = TY_PARAMETER_ENUM,
               .id = "fog_depth.tile",
               .name = "Tile",
               .unit = "pixels",
               .doc = "Side of a workgroup; changes speed only.",
               .choices = kTiles,
               .choice_count = 2,
               .flags = TY_PARAMETER_STRUCTURAL},
};

static const TyParameter* parameters(uint32_t* count) {
  *count = kParameterCount;
  return kParameters;
}

/* ---- The instance owns what layout() hands out until the next layout(). */

struct TyInstance {
  TyUniformBlock uniform;
  TyBinding bindings[3];
  TySpecialization constants[2];
  TyPass pass;
  TyDebugView view;
  TyLayout layout;
};

static const TyHost* g_host;

static bool init(const TyHost* host) {
  g_host = host;
  return true;
}
static void shutdown(void) { g_host = NULL; }

static TyInstance* create(void) {
  TyInstance* instance = calloc(1, sizeof *instance);
  if (instance == NULL) g_host->log(g_host->context, TY_LOG_ERROR, "out of memory");
  return instance;
}
static void destroy(TyInstance* instance) { free(instance); }

/* ---- Layout: what to make and run. Depends on nothing but its arguments. */

/* Filled by prepare(), read by fog.comp.glsl (scalar layout: the same offsets as in C). */
typedef struct Uniforms {
  float view_from_clip[16];
  float source[3];
  float sigma_t;
} Uniforms;

static const TyLayout* layout(TyInstance* self, const TyDevice* device, const TyStructure* structure) {
  (void)device;
  memset(self, 0, sizeof *self);
  self->layout.struct_size = sizeof(TyLayout);

  bool sun = false;
  for (uint32_t i = 0; i < structure->light_count; ++i) sun = sun || structure->light_kinds[i] == TY_LIGHT_DIRECTIONAL;
  if (!sun) return &self->layout; /* no pass: nothing to do */

  self->uniform = (TyUniformBlock){.struct_size = sizeof(TyUniformBlock), .name = "fog", .size = sizeof(Uniforms)};
  const TyBinding bindings[3] = {
      {.struct_size = sizeof(TyBinding), .binding = 0, .source = TY_SOURCE_SCENE_DEPTH, .access = TY_ACCESS_SAMPLED},
      {.struct_size = sizeof(TyBinding), .binding = 1, .source = TY_SOURCE_OUTPUT, .access = TY_ACCESS_STORAGE_WRITE},
      {.struct_size = sizeof(TyBinding),
       .binding = 2,
       .source = TY_SOURCE_UNIFORM,
       .index = 0,
       .access = TY_ACCESS_UNIFORM},
  };
  memcpy(self->bindings, bindings, sizeof bindings);

  const uint32_t tile = structure->values[kTile] == 1 ? 16 : 8;
  self->constants[0] = (TySpecialization){.id = 0, .value = tile};
  self->constants[1] = (TySpecialization){.id = 1, .value = tile};

  self->pass = (TyPass){.struct_size = sizeof(TyPass),
                        .kind = TY_PASS_COMPUTE,
                        .name = "fog",
                        .shader = "fog.comp",
                        .bindings = self->bindings,
                        .binding_count = 3,
                        .groups = {(structure->width + tile - 1) / tile, (structure->height + tile - 1) / tile, 1},
                        .specializations = self->constants,
                        .specialization_count = 2};
  self->view = (TyDebugView){.struct_size = sizeof(TyDebugView),
                             .source = TY_SOURCE_OUTPUT,
                             .name = "fog_transmittance",
                             .doc = "Share of the surface's light that reaches the eye",
                             .channel = 3,
                             .low = 0,
                             .high = 1};
  self->layout.uniforms = &self->uniform;
  self->layout.uniform_count = 1;
  self->layout.passes = &self->pass;
  self->layout.pass_count = 1;
  self->layout.debug_views = &self->view;
  self->layout.debug_view_count = 1;
  return &self->layout;
}

/* ---- Prepare: the numbers of one frame. */

static bool prepare(TyInstance* self, const TyFrame* frame, const TyUniformData* out) {
  (void)self;
  const TyLight* sun = NULL;
  for (uint32_t i = 0; i < frame->light_count && sun == NULL; ++i)
    if (frame->lights[i].kind == TY_LIGHT_DIRECTIONAL) sun = &frame->lights[i];
  if (sun == NULL) {
    g_host->log(g_host->context, TY_LOG_ERROR, "the frame lacks the sun that its layout was made for");
    return false;
  }
  Uniforms u;
  memcpy(u.view_from_clip, frame->view->view_from_clip, sizeof u.view_from_clip);
  const float isotropic =
      0.07957747155f; /* 1/(4 pi): the phase function of even scattering, normalised over the sphere */
  for (int i = 0; i < 3; ++i) u.source[i] = (float)frame->values[kAlbedo] * isotropic * sun->radiance[i];
  u.sigma_t = (float)frame->values[kSigmaT];
  memcpy(out->data[0], &u, sizeof u);
  return true;
}

/* ---- The one exported symbol. */

TY_EXPORT const TyPlugin tyndall_plugin = {
    .abi_version = TY_ABI_VERSION,
    .struct_size = sizeof(TyPlugin),
    .id = "fog_depth",
    .name = "Depth fog",
    .version = "1.0.0",
    .doc = "Closed-form single scattering of the first sun in even fog, without shadows: the template for plugins.",
    .init = init,
    .shutdown = shutdown,
    .parameters = parameters,
    .create = create,
    .destroy = destroy,
    .layout = layout,
    .prepare = prepare,
};
