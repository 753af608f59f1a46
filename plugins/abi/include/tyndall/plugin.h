/* Tyndall plugin ABI, version 1.3. One header, C11 and C++20, no other dependency.
 *
 * A plugin is a shared library with one exported symbol, `tyndall_plugin` (a TyPlugin). It owns no GPU object and
 * calls no graphics API: it describes, as plain data, the images, buffers and passes that its host makes and runs for
 * it ("layout"), and fills uniform blocks each frame ("prepare"). So both are tested without a GPU, and another engine
 * hosts a plugin by walking the same tables.
 *
 * Rules
 * - Versions: `abi_version` of TyPlugin is read first, before anything else is trusted. Same major: compatible; a host
 *   takes any minor up to its own and refuses a newer one (the plugin may need what the host lacks).
 * - Sizes: every struct that crosses the border starts with `struct_size`, its sizeof on the side that filled it. The
 *   reader copies min(struct_size, its own sizeof) bytes into zeroed memory: an older plugin's missing functions are
 *   null, its missing numbers 0, and zero always means "the old behaviour". Fields are only ever appended. Elements of
 *   arrays are stepped by the `struct_size` of the array's FIRST element (all elements of an array have the same).
 * - Threads: [main] is called from one thread at a time, the one that created the instance; [any] from any thread, at
 *   any time between init and shutdown. Nothing is called from two threads at once unless tagged [any].
 * - Memory: pointers that a plugin hands out (tables, layouts, strings) stay valid until the next call into the same
 *   function of the same instance, or until shutdown for those that belong to no instance. The host copies what it
 *   keeps (strings too) and never frees a plugin's memory. Pointers that a host hands in are valid during the call.
 * - Errors: a function returns false (or null) after one log line through TyHost.log; it never throws, aborts or exits.
 * - Strings: UTF-8, zero-terminated, never null unless stated.
 * - New in 1.1: TyUniformData.skip; a pass may sample and store to different parts of one image (TyBinding);
 *   TY_SOURCE_SHADOW_MOMENTS and TyStructure.shadow_moments_format; images that lights shine through
 * (TyStructure.light_cookies, TyLight.cookie_*, TY_SOURCE_LIGHT_COOKIE) and TY_SAMPLER_LINEAR_MIPMAP_REPEAT.
 * - New in 1.2: TyDebugView.role.
 * - New in 1.3: TyLight.cone_inner, cone_outer.
 * - Units: metres, radians, seconds; linear colour; matrices column-major, named result_from_source; view space looks
 *   down -Z, +Y up; clip space is Vulkan's (x right, y down, z in [0, 1]); depth of the scene is reversed (1 at the
 *   near plane, 0 at the far plane or where nothing was drawn).
 */
#ifndef TYNDALL_PLUGIN_H
#define TYNDALL_PLUGIN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TY_ABI_MAJOR 1u
#define TY_ABI_MINOR 3u
#define TY_ABI_VERSION ((TY_ABI_MAJOR << 16) | TY_ABI_MINOR)
#define TY_ABI_MAJOR_OF(version) ((version) >> 16)
#define TY_ABI_MINOR_OF(version) ((version)&0xffffu)

/* Name of the one exported symbol. Definition in the plugin:  TY_EXPORT const TyPlugin tyndall_plugin = {...}; */
#define TY_ENTRY_SYMBOL "tyndall_plugin"
#if defined(_WIN32)
#define TY_EXPORT __declspec(dllexport)
#else
#define TY_EXPORT __attribute__((visibility("default")))
#endif

/* "No such index" wherever an index may be absent. */
#define TY_NONE 0xffffffffu

/* ---------------------------------------------------------------------------------------------- parameters ---- */

typedef enum TyParameterType {
  TY_PARAMETER_BOOL = 0,
  TY_PARAMETER_INT = 1,
  TY_PARAMETER_FLOAT = 2,
  TY_PARAMETER_ENUM = 3
} TyParameterType;

enum {
  TY_PARAMETER_STRUCTURAL = 1u << 0, /* a change needs a new layout (images, passes or pipelines differ) */
  TY_PARAMETER_LOGARITHMIC = 1u << 1 /* a slider should be logarithmic */
};

/* One knob. From this table the host makes the command line, presets, editor widgets and documentation. Values cross
 * the border as double: bool 0/1, enum the index of the choice. */
typedef struct TyParameter {
  uint32_t struct_size;
  uint32_t type;    /* TyParameterType */
  const char* id;   /* "group.name", unique among everything a host has loaded */
  const char* name; /* for people: "Steps" */
  const char* unit; /* "m", "1/m", "" */
  const char* doc;  /* one or two sentences */
  double default_value;
  double min_value; /* inclusive; unused for bool and enum */
  double max_value;
  const char* const* choices; /* enum: choice_count names; else null */
  uint32_t choice_count;      /* at most 64 */
  uint32_t flags;             /* TY_PARAMETER_* */
  /* What is not built yet is refused by name, instead of being taken and ignored. Bit i of `unbuilt`: choice i (enum)
   * or value i (bool: bit 0 false, bit 1 true) is refused. For int and float, values outside [built_min, built_max] are
   * refused when built_min < built_max or `unbuilt` bit 0 is set. */
  uint64_t unbuilt;
  double built_min;
  double built_max;
} TyParameter;

/* ------------------------------------------------------------------------------ what layout() is told of ---- */

typedef enum TyLightKind { TY_LIGHT_DIRECTIONAL = 0, TY_LIGHT_SPOT = 1, TY_LIGHT_POINT = 2 } TyLightKind;

/* The device the passes will run on. */
typedef struct TyDevice {
  uint32_t struct_size;
  uint32_t is_cpu; /* 1: a software device (loops and texel fetches are cheap, barriers dear) */
  const char* name;
  uint32_t subgroup_size;
  uint32_t max_image_2d; /* texels a side */
  uint32_t max_image_layers;
  uint32_t max_shared_memory; /* bytes a workgroup */
  uint32_t max_workgroup_invocations;
  uint32_t max_push_descriptors; /* bindings a pass may have */
  uint64_t max_storage_buffer;   /* bytes */
} TyDevice;

/* Everything a layout may depend on; never matrices or times, so that it changes only when an image or a pipeline must.
 */
typedef struct TyStructure {
  uint32_t struct_size;
  uint32_t width, height; /* of the picture, texels, >= 1 */
  uint32_t light_count;
  const uint32_t* light_kinds;  /* TyLightKind of each light that has a shadow map, in the order of TyFrame.lights */
  const uint32_t* shadow_sizes; /* texels a side of each light's map (of one face, for a point light) */
  const double* values;         /* every parameter of the plugin's table, in table order */
  uint32_t value_count;
  /* Since 1.1: TyFormat of TY_SOURCE_SHADOW_MOMENTS, RGBA16 unorm (quantised, see there) or RGBA32 float;
   * TY_FORMAT_UNKNOWN: the host makes no such maps, and a layout that binds one is refused. */
  uint32_t shadow_moments_format;
  /* Since 1.1: layers of each light's TY_SOURCE_LIGHT_COOKIE that hold an image: 0 (the light has none), 1, or 6 for a
   * point light. Null: the host knows no cookies, and a layout that binds one is refused. */
  const uint32_t* light_cookies;
} TyStructure;

/* -------------------------------------------------------------------------------------------------- layout ---- */

/* Formats that every Vulkan 1.3 device with the features in docs/conventions.md can store to, sample and render to. */
typedef enum TyFormat {
  TY_FORMAT_UNKNOWN = 0,
  TY_FORMAT_R8_UNORM = 1,
  TY_FORMAT_RGBA8_UNORM = 2,
  TY_FORMAT_A2B10G10R10_UNORM = 3,
  TY_FORMAT_R16_UNORM = 4,
  TY_FORMAT_RG16_UNORM = 5,
  TY_FORMAT_RGBA16_UNORM = 6,
  TY_FORMAT_R16_FLOAT = 7,
  TY_FORMAT_RG16_FLOAT = 8,
  TY_FORMAT_RGBA16_FLOAT = 9,
  TY_FORMAT_R32_FLOAT = 10,
  TY_FORMAT_RG32_FLOAT = 11,
  TY_FORMAT_RGBA32_FLOAT = 12,
  TY_FORMAT_R32_UINT = 13,
  TY_FORMAT_RG32_UINT = 14,
  TY_FORMAT_RGBA32_UINT = 15,
  TY_FORMAT_D32_FLOAT = 16
} TyFormat;

typedef enum TyImageKind { TY_IMAGE_2D = 0, TY_IMAGE_2D_ARRAY = 1, TY_IMAGE_3D = 2 } TyImageKind;

enum {
  /* Kept between frames; zero after a new layout, worthless after reset. Others are transient: undefined at the frame's
   * start, their memory shared. A transient that a pass reads must have been written by an earlier pass of the frame.
   */
  TY_RESOURCE_HISTORY = 1u << 0
};

typedef struct TyImage {
  uint32_t struct_size;
  uint32_t kind;          /* TyImageKind */
  const char* name;       /* unique in the layout, for debug views, memory reports and GPU tools */
  uint32_t format;        /* TyFormat */
  uint32_t width, height; /* texels, >= 1 */
  uint32_t depth;         /* slices of a 3D image or layers of an array, >= 1 */
  uint32_t mips;          /* >= 1 */
  uint32_t flags;         /* TY_RESOURCE_* */
} TyImage;

typedef struct TyBuffer {
  uint32_t struct_size;
  uint32_t flags; /* TY_RESOURCE_* */
  const char* name;
  uint64_t size; /* bytes, >= 4 */
} TyBuffer;

/* A block that prepare() fills each frame. Bound to a shader as a uniform buffer with scalar layout. */
typedef struct TyUniformBlock {
  uint32_t struct_size;
  uint32_t per_light; /* 1: one block for each light */
  const char* name;
  uint32_t size; /* bytes, <= 16384, multiple of 4 */
} TyUniformBlock;

/* Where a binding's resource comes from. `index` means: */
typedef enum TySource {
  TY_SOURCE_IMAGE = 0,       /* TyLayout.images[index] */
  TY_SOURCE_BUFFER = 1,      /* TyLayout.buffers[index] */
  TY_SOURCE_UNIFORM = 2,     /* TyLayout.uniforms[index]; in a per-light pass, that light's block */
  TY_SOURCE_SCENE_DEPTH = 3, /* D32, reversed; width x height; index 0 */
  TY_SOURCE_SHADOW_MAP =
      4, /* per-light passes only: the light's map, D32 array (1 layer; 6 faces +X -X +Y -Y +Z -Z for a point light) */
  TY_SOURCE_OUTPUT = 5, /* the plugin's result: RGBA32F, width x height: RGB in-scattered radiance, A transmittance */
  /* Since 1.1, per-light passes only: the light's four-moment shadow map, a 2D array of as many layers and texels as
   * its shadow map, with all mips, for TY_ACCESS_SAMPLED of the whole. RGBA hold the means of z, z^2, z^3, z^4 over a
   * Gaussian of 1.5 texels, where z in [-1, 1] is 2d - 1 for a directional light's stored depth d, and grows linearly
   * with the distance along the face's axis, -1 at depth 0 and 1 at depth 1, for others. RGBA16 unorm holds them after
   * the quantisation transform of Peters et al. 2017, equation 3. It is made only in frames in which a pass that counts
   * reads it. */
  TY_SOURCE_SHADOW_MOMENTS = 6,
  /* Since 1.1, per-light passes only: the image whose colour multiplies the light's (a cookie, a gobo), a 2D array of
   * square layers with all mips, for TY_ACCESS_SAMPLED of the whole: one layer, or six faces +X -X +Y -Y +Z -Z for a
   * point light; one white texel in one layer for a light without (cookie_faces 0). RGB is linear: no decoding. Where
   * to look: TyLight.cookie_from_world. Which size it has the shader asks (textureSize): it may change without a new
   * layout. */
  TY_SOURCE_LIGHT_COOKIE = 7
} TySource;

typedef enum TyAccess {
  TY_ACCESS_SAMPLED = 0, /* texture or texelFetch */
  TY_ACCESS_STORAGE_READ = 1,
  TY_ACCESS_STORAGE_WRITE = 2, /* every texel the next passes read is written; old contents are lost */
  TY_ACCESS_STORAGE_READ_WRITE = 3,
  TY_ACCESS_UNIFORM = 4
} TyAccess;

typedef enum TySampler {
  TY_SAMPLER_NEAREST_CLAMP = 0,
  TY_SAMPLER_LINEAR_CLAMP = 1,
  TY_SAMPLER_NEAREST_REPEAT = 2,
  TY_SAMPLER_LINEAR_REPEAT = 3,
  TY_SAMPLER_LINEAR_MIPMAP_CLAMP = 4,
  TY_SAMPLER_LINEAR_MIPMAP_REPEAT = 5 /* since 1.1 */
} TySampler;

/* A pass uses each image and each buffer in one way: several sampled bindings of one image are one way, sampling it and
 * storing to it are two. Since 1.1 one exception: bindings of a compute pass that reach different parts of one image
 * (mips base_mip .. base_mip + mip_count - 1 of layers base_layer .. base_layer + layer_count - 1) may differ in
 * access, sampled here and stored to there, as long as no part that is written is reached by another binding; so a pass
 * makes one mip from another. Full-screen passes sample images, read buffers (TY_ACCESS_STORAGE_READ) and take uniform
 * blocks; storing is for compute passes. Depth and integer formats take nearest samplers only. */
typedef struct TyBinding {
  uint32_t struct_size;
  uint32_t binding; /* set 0, this binding */
  uint32_t source;  /* TySource */
  uint32_t index;
  uint32_t access;                  /* TyAccess */
  uint32_t sampler;                 /* TySampler, for TY_ACCESS_SAMPLED (a combined image sampler) */
  uint32_t base_mip, mip_count;     /* mip_count 0: all from base_mip (storage access: base_mip alone) */
  uint32_t base_layer, layer_count; /* layer_count 0: all from base_layer */
} TyBinding;

typedef struct TySpecialization {
  uint32_t id;    /* constant_id */
  uint32_t value; /* bit pattern of an int, uint, bool (0/1) or float */
} TySpecialization;

typedef enum TyPassKind {
  TY_PASS_COMPUTE = 0,          /* dispatch groups[0..2] */
  TY_PASS_COMPUTE_INDIRECT = 1, /* counts from buffers[indirect_buffer] at indirect_offset */
  TY_PASS_FULL_SCREEN = 2,      /* one triangle over the targets; the shader is a fragment shader */
  TY_PASS_CASTERS = 3,       /* draws shadow casters with the pass's own vertex transform (see TyPass.caster_uniform) */
  TY_PASS_SHADOW_VOLUMES = 4 /* draws extruded silhouettes; ability "tyndall.shadow_volumes", not in version 1.0 */
} TyPassKind;

typedef enum TyBlend { TY_BLEND_NONE = 0, TY_BLEND_ADD = 1, TY_BLEND_MIN = 2, TY_BLEND_MAX = 3 } TyBlend;

typedef struct TyTarget {
  uint32_t struct_size;
  uint32_t source; /* TY_SOURCE_IMAGE or TY_SOURCE_OUTPUT */
  uint32_t index;
  uint32_t mip, layer; /* the sub-view drawn to */
  uint32_t load;       /* 0: cleared to `clear`; 1: kept */
  uint32_t blend;      /* TyBlend (colour) */
  float clear[4];
} TyTarget;

typedef struct TyPass {
  uint32_t struct_size;
  uint32_t kind;      /* TyPassKind */
  const char* name;   /* shown by the timers: "rectify"; best unique in the layout */
  const char* shader; /* "<name>.comp" or "<name>.frag"; the host finds <plugin id>/<name>.<stage>.spv beside the
                       * library. Every binding it declares is among `bindings`. Caster passes: null */
  const TyBinding* bindings;
  uint32_t binding_count;
  uint32_t per_light;   /* 1: run once for each light whose kind is in light_kinds */
  uint32_t light_kinds; /* bit mask 1 << TyLightKind; 0: all */
  uint32_t groups[3];
  const TySpecialization* specializations;
  uint32_t specialization_count;
  const TyTarget* targets; /* full-screen and caster passes: colour targets */
  uint32_t target_count;
  const TyTarget* depth_target; /* null: none; blend is ignored, clear[0] is the depth */
  uint32_t depth_compare;       /* 0 always, 1 less-or-equal, 2 greater-or-equal */
  uint32_t indirect_buffer;
  uint64_t indirect_offset;
  uint32_t caster_uniform; /* caster passes: uniforms[] block that starts with mat4 clip_from_world. In version 1.0 they
                            * draw depth alone: a depth target, no colour target, no binding */
} TyPass;
/* Consecutive passes with per_light = 1 form a group. The host runs a group light by light - all passes of the group
 * for light 0, then all for light 1 - so that lights take turns in the same transient memory. */

/* What the numbers of a debug view mean, for tools that know no plugin by name. A host may treat roles that it does not
 * know as TY_VIEW_PLAIN. A layout has at most one view of each role from TY_VIEW_ROW_PLACE on, but for
 * TY_VIEW_WALK_LEVEL and TY_VIEW_WALK_LEVEL_ACROSS. */
typedef enum TyViewRole {
  TY_VIEW_PLAIN = 0,
  /* A map whose rows hold view rays: slices along x, columns along y, whatever its size. TY_VIEW_ROW_DEPTHS: it holds
   * the normalised depth of the first blocker, 1 for none: what lies before it on its light ray is lit. */
  TY_VIEW_ROWS = 1,
  TY_VIEW_ROW_DEPTHS = 2,
  /* Of each pixel, RGBA: where the end of its view ray lies in those maps, x and y from 0 to 1 over the whole map (its
   * column is clamped to the map); its inclination to the direction of the light, rad; its normalised depth, as
   * TY_VIEW_ROW_DEPTHS holds it. */
  TY_VIEW_ROW_PLACE = 3,
  /* Of each texel of those maps, RGB: points of its light ray in world space, m: one nearer to the light than all that
   * the view meets of it, and its blocker, or without one where the view last can meet it. A of START: 1, or 0 where
   * the texel has no light ray; of END: 1 for a blocker. */
  TY_VIEW_LIGHT_RAY_START = 4,
  TY_VIEW_LIGHT_RAY_END = 5,
  /* In-scattered radiance of every light (RGB) found without the technique's approximations, to judge its result by. */
  TY_VIEW_REFERENCE = 6,
  /* A search by bits through the sorted depths of each row of those maps: a ray asks which of the blockers of its
   * columns lie before it. RANKS: slices along x; the first channel at y holds, over 65535, how many of the slice's
   * depths are less than y / (height - 1). The rank of a depth lies between those of the two texels that it lies
   * between. */
  TY_VIEW_WALK_RANKS = 7,
  /* One view for each level of the search, in order. Slices along x, positions along y (ACROSS: the other way round),
   * 2^n of them, in 2^level nodes of equal size, each with the ranks of its own positions in the order of their
   * columns. Of the columns of a node up to a position: R, over 65535, how many have a rank in the node's first half;
   * G, which share of their weight those have. */
  TY_VIEW_WALK_LEVEL = 8,
  TY_VIEW_WALK_LEVEL_ACROSS = 9
} TyViewRole;

/* A picture the plugin can show of its insides. */
typedef struct TyDebugView {
  uint32_t struct_size;
  uint32_t source; /* TY_SOURCE_IMAGE, TY_SOURCE_SHADOW_MAP, TY_SOURCE_OUTPUT or (since 1.1) TY_SOURCE_SHADOW_MOMENTS */
  const char* name; /* "rectified" */
  const char* doc;
  uint32_t index;
  uint32_t mip, layer;
  uint32_t channel; /* 0..3 R G B A as grey; 4 RGB */
  float low, high;  /* values mapped to black and white */
  uint32_t role;    /* since 1.2: TyViewRole */
} TyDebugView;

/* A transient buffer that the host fills with zeros before the first pass and reads back after the frame; names[i]
 * names the i-th uint32 of it ("skipped: fully lit rays"). */
typedef struct TyCounters {
  uint32_t struct_size;
  uint32_t buffer;
  const char* const* names;
  uint32_t name_count;
} TyCounters;

/* Variants that differ in speed only. When the structural parameter `parameter` has the value `automatic`, the host
 * times the passes named in `passes` once per device with each of `variants` and from then on calls layout() with the
 * fastest. layout() is called with `automatic` only to learn of the tunables (nothing is run from that layout);
 * layout() and prepare() then see the variant in the place of the automatic value. */
typedef struct TyTunable {
  uint32_t struct_size;
  uint32_t parameter; /* index into the table */
  double automatic;
  const double* variants;
  uint32_t variant_count;
  const char* const* passes;
  uint32_t pass_count;
} TyTunable;

typedef struct TyLayout {
  uint32_t struct_size;
  const TyImage* images;
  uint32_t image_count;
  const TyBuffer* buffers;
  uint32_t buffer_count;
  const TyUniformBlock* uniforms;
  uint32_t uniform_count;
  const TyPass* passes;
  uint32_t pass_count;
  const TyDebugView* debug_views;
  uint32_t debug_view_count;
  const TyCounters* counters; /* null: none */
  const TyTunable* tunables;
  uint32_t tunable_count;
} TyLayout;

/* ------------------------------------------------------------------------------------------------- prepare ---- */

typedef struct TyView {
  uint32_t struct_size;
  uint32_t width, height;
  float view_from_world[16]; /* column-major */
  float world_from_view[16];
  float clip_from_view[16];
  float view_from_clip[16];
  float eye[3];
  float znear, zfar; /* metres along the optical axis */
  double seconds;
  uint64_t frame_index;
} TyView;

typedef struct TyLight {
  uint32_t struct_size;
  uint32_t kind;              /* TyLightKind */
  float position[3];          /* spot, point */
  float direction[3];         /* directional, spot: unit, the way the light travels */
  float radiance[3];          /* colour times intensity: lux (directional), candela (spot, point) */
  float range;                /* metres; 0: unlimited */
  float cos_inner, cos_outer; /* spot: cosines of the cone's half angles */
  uint32_t face_count;        /* 1, or 6 for a point light */
  uint32_t shadow_size;       /* texels a side */
  /* World to the clip space of each face. Stored depth is clip z: 0 nearest the light, 1 where nothing was drawn. A
   * point is lit if its clip z is <= the stored depth, or the stored depth is 1; outside the map (x, y beyond [-1, 1])
   * it is lit. */
  float shadow_clip_from_world[6][16];
  /* Convex hull, in world space, of all casters of this light: nothing outside the volume it sweeps away from the light
   * is shadowed. Corners of a box; the eight corners are equal when there is no caster. */
  float caster_corners[8][3];
  /* Since 1.1: where the light's image (TY_SOURCE_LIGHT_COOKIE) is looked up for a world point, p = cookie_from_world *
   * point. Directional and spot lights: (x, y) = p.xy / p.w go from -1 to 1 over the image, y up, so that u = 0.5 + 0.5
   * x and v = 0.5 - 0.5 y; w is 1 for a directional light, the distance along the axis for a spot light (at or below 0
   * no light goes). p.z is the distance along the light's axis in metres. Point lights: p.xyz is the vector from the
   * light in the frame of the faces. With m the largest of |x|, |y|, |z|, face and (s, t), both over m and then from -1
   * to 1, are those of Vulkan's cube maps, with u = 0.5 + 0.5 s, v = 0.5 + 0.5 t: +X (layer 0) s = -z, t = -y    -X (1)
   * s = z, t = -y    +Y (2) s = x, t = z -Y (3)       s = x,  t = -z    +Z (4) s = x, t = -y    -Z (5) s = -x, t = -y
   * cookie_repeats: bit 0: the image repeats along x, bit 1: along y (directional lights only); where it does not, the
   * border goes on (clamp u or v to half a texel from the border before looking up with a repeating sampler). Images
   * that the level mirrors are given together with their mirror image, repeating. */
  float cookie_from_world[16];
  uint32_t cookie_faces; /* 0: no image, the rest means nothing; 1; 6 for a point light */
  uint32_t cookie_repeats;
  /* Since 1.3: half angles of a spot light's cone, 0 <= inner <= outer <= pi/2, equal for a hard edge. cos_inner and
   * cos_outer say the same, but have no digits left for cones of less than a degree. Outer 0: an older host. */
  float cone_inner, cone_outer;
} TyLight;

typedef struct TyFrame {
  uint32_t struct_size;
  uint32_t reset; /* 1: a cut (new level, new size, jump): history is worthless */
  const TyView* view;
  const TyLight* lights; /* as many as in the TyStructure of the current layout, same kinds and order */
  uint32_t light_count;
  uint32_t value_count;
  const double* values; /* current parameter values, in table order (tunables: the variant in use) */
} TyFrame;

/* Where prepare() writes: block i of the layout starts at data[i]; a per-light block of light l at data[i] +
 * l*stride[i]. All of it is zero when prepare() is called. skip (since 1.1; null from an older host): prepare() sets
 * skip[pass * skip_stride + light] = 1 (pass: index into TyLayout.passes; light 0 for a pass that is not per light) for
 * a run that has nothing to do in this frame. The host records nothing for it: no dispatch, no draw, no clear. It is
 * missing from the timers. What it would have written keeps its old contents if it is history (TY_RESOURCE_HISTORY) and
 * is undefined otherwise: no shader of this frame may read that. */
typedef struct TyUniformData {
  uint32_t struct_size;
  uint32_t block_count;
  uint8_t* const* data;
  const uint32_t* stride;
  uint8_t* skip;        /* 1.1 */
  uint32_t skip_stride; /* 1.1; at least 1, and light_count */
} TyUniformData;

/* --------------------------------------------------------------------------------------------- host, plugin ---- */

typedef enum TyLogLevel { TY_LOG_DEBUG = 0, TY_LOG_INFO = 1, TY_LOG_WARNING = 2, TY_LOG_ERROR = 3 } TyLogLevel;

typedef struct TyHost {
  uint32_t struct_size;
  uint32_t abi_version;                                         /* TY_ABI_VERSION of the host */
  const char* name;                                             /* "tyndall 0.1.0" */
  void* context;                                                /* handed back to the functions below */
  void (*log)(void* context, uint32_t level, const char* line); /* [any] one line without a line feed */
  /* Optional abilities of the host by name, or null. [any] None is defined in version 1.0. */
  const void* (*get_extension)(void* context, const char* id);
} TyHost;

/* One technique: a name among the choices of the selector parameter and the parameters it reads. */
typedef struct TyTechnique {
  uint32_t struct_size;
  uint32_t read_count;
  const char* id;   /* "moments6" */
  const char* name; /* "Prefiltered moments (6)" */
  const char* doc;
  const char* const* reads; /* ids of the parameters that have an effect while this technique is chosen */
} TyTechnique;

typedef struct TyInstance TyInstance; /* opaque, the plugin's */

typedef struct TyPlugin {
  uint32_t abi_version; /* TY_ABI_VERSION that the plugin was built with: first, read before anything else */
  uint32_t struct_size;
  const char* id; /* "volumetrics": of a-z, 0-9 and _, unique; names the folder of shaders beside the library */
  const char* name;
  const char* version; /* "0.1.0" */
  const char* doc;

  /* Called once after loading, before anything else; `host` stays valid until shutdown. [main] */
  bool (*init)(const TyHost* host);
  /* Called once before unloading, after every instance is destroyed. [main] */
  void (*shutdown)(void);

  /* The parameter table; valid from init to shutdown. The function may be null: no parameter. [any] */
  const TyParameter* (*parameters)(uint32_t* count);
  /* The techniques that are built; `selector` receives the index of the enum parameter that chooses among them (by
   * name; other choices of it are refused unless the technique list has them or the choice is "none"), or TY_NONE. The
   * function may be null: no technique to choose. [any] */
  const TyTechnique* (*techniques)(uint32_t* count, uint32_t* selector);

  TyInstance* (*create)(void);  /* [main] null on failure */
  void (*destroy)(TyInstance*); /* [main] */

  /* Pure: the same device and structure give the same layout. null with a log line on failure. An empty layout (no
   * passes) means that there is nothing to do: the host then takes scatter 0 and transmittance 1. [main] */
  const TyLayout* (*layout)(TyInstance*, const TyDevice* device, const TyStructure* structure);
  /* Fills the uniform blocks of the layout last returned. False: this frame is drawn without the plugin. [main] */
  bool (*prepare)(TyInstance*, const TyFrame* frame, const TyUniformData* out);

  /* Optional abilities of the plugin by name, or null. [any] None is defined in version 1.0. */
  const void* (*get_extension)(const char* id);
} TyPlugin;

#ifdef __cplusplus
}
#endif

#endif /* TYNDALL_PLUGIN_H */
