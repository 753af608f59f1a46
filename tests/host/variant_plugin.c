/* A plugin that does nothing, well or in one of many wrong ways: which one is chosen by a compile definition. */
#include <math.h>
#include <stdlib.h>

#include "tyndall/plugin.h"

#ifdef UNRESOLVED
int tyndall_test_function_that_nobody_defines(void);
#endif

struct TyInstance {
  int unused;
};

static const char* const kModes[] = {"none", "plain", "fancy"};
#ifdef REBUILT /* the same plugin after its author went on: another order, range, default and version */
#define VERSION "2.0.0"
static const TyParameter kParameters[] = {
    {.struct_size = sizeof(TyParameter),
     .type = TY_PARAMETER_FLOAT,
     .id = "variant.untouched",
     .name = "",
     .unit = "",
     .doc = "",
     .default_value = 3,
     .max_value = 10},
    {.struct_size = sizeof(TyParameter),
     .type = TY_PARAMETER_INT,
     .id = "variant.far",
     .name = "",
     .unit = "",
     .doc = "",
     .default_value = 1,
     .max_value = 5},
    {.struct_size = sizeof(TyParameter),
     .type = TY_PARAMETER_FLOAT,
     .id = "variant.kept",
     .name = "",
     .unit = "",
     .doc = "",
     .default_value = 1,
     .max_value = 10},
    {.struct_size = sizeof(TyParameter),
     .type = TY_PARAMETER_ENUM,
     .id = "variant.mode",
     .name = "",
     .unit = "",
     .doc = "",
     .choices = kModes,
     .choice_count = 3},
};
#define SELECTOR 3u
#else
#define VERSION "1.0.0"
static const TyParameter kParameters[] = {
    {.struct_size = sizeof(TyParameter),
     .type = TY_PARAMETER_FLOAT,
     .id = "variant.kept",
     .name = "",
     .unit = "",
     .doc = "",
     .default_value = 1,
     .max_value = 10},
    {.struct_size = sizeof(TyParameter),
     .type = TY_PARAMETER_INT,
     .id = "variant.far",
     .name = "",
     .unit = "",
     .doc = "",
     .default_value = 1,
     .max_value = 10},
    {.struct_size = sizeof(TyParameter),
     .type = TY_PARAMETER_ENUM,
     .id = "variant.mode",
     .name = "",
     .unit = "",
     .doc = "",
     .choices = kModes,
     .choice_count = 3,
     .default_value =
#ifdef DEFAULT_NOT_BUILT
         2
#else
         0
#endif
    },
#ifdef DUPLICATE_ID
    {.struct_size = sizeof(TyParameter),
     .type = TY_PARAMETER_BOOL,
     .id = "variant.kept",
     .name = "",
     .unit = "",
     .doc = ""},
#elif defined(UNSIZED_ROW)
    {.struct_size = 0, .type = TY_PARAMETER_BOOL, .id = "variant.unsized", .name = "", .unit = "", .doc = ""},
#elif defined(NAN_DEFAULT)
    {.struct_size = sizeof(TyParameter),
     .type = TY_PARAMETER_FLOAT,
     .id = "variant.nan",
     .name = "",
     .unit = "",
     .doc = "",
     .default_value = NAN,
     .max_value = 1},
#else
    {.struct_size = sizeof(TyParameter),
     .type = TY_PARAMETER_FLOAT,
     .id = "variant.untouched",
     .name = "",
     .unit = "",
     .doc = "",
     .default_value = 2,
     .max_value = 10},
#endif
};
#define SELECTOR 2u
#endif

static const TyHost* g_host;
#ifdef EXITS_WHEN_LOADED
__attribute__((constructor)) static void early(void) { exit(0); }
#endif
#ifdef ENDLESS_STACK
static int deeper(volatile int* from) {
  volatile int here[1024] = {*from};
  if (*from > 1000000000) return 0;
  return deeper(here) + here[1];
}
#endif
static bool init(const TyHost* host) {
  g_host = host;
#ifdef INIT_FAILS
  host->log(host->context, TY_LOG_WARNING, "I do not\nwant to");
  host->log(host->context, TY_LOG_ERROR, "not today");
  return false;
#elif defined(EXITS)
  host->log(host->context, TY_LOG_ERROR, "my data is missing");
  exit(0);
#elif defined(ABORTS)
  abort();
#elif defined(LOOPS)
  volatile bool again = true;
  while (again) {
  }
  return true;
#elif defined(ENDLESS_STACK)
  volatile int start = 0;
  return deeper(&start) == 0;
#else
  return host->struct_size >= sizeof(TyHost) && host->abi_version == TY_ABI_VERSION &&
         host->get_extension(host->context, "none") == NULL;
#endif
}
static void shutdown(void) {}

static const TyParameter* parameters(uint32_t* count) {
#ifdef NULL_TABLE
  *count = sizeof kParameters / sizeof *kParameters;
  return NULL;
#elif defined(ENDLESS_TABLE)
  *count = 0xffffffffu;
  return kParameters;
#else
  *count = sizeof kParameters / sizeof *kParameters;
  return kParameters;
#endif
}

static const TyTechnique* techniques(uint32_t* count, uint32_t* selector) {
  static const char* const reads[] = {"variant.kept"};
  static const TyTechnique plain = {.struct_size = sizeof(TyTechnique),
                                    .read_count = 1,
                                    .id = "plain",
                                    .name = "Plain",
                                    .doc = "Nothing.",
                                    .reads = reads};
  *count = 1;
#ifdef BAD_SELECTOR
  *selector = 99;
#else
  *selector = SELECTOR;
#endif
  return &plain;
}

static TyInstance* create(void) {
#ifdef CREATE_FAILS
  return NULL;
#else
  return calloc(1, sizeof(TyInstance));
#endif
}
static void destroy(TyInstance* instance) { free(instance); }

#ifndef NO_LAYOUT
static const TyLayout* layout(TyInstance* self, const TyDevice* device, const TyStructure* structure) {
  static const TyLayout empty = {.struct_size = sizeof(TyLayout)};
  (void)self, (void)device, (void)structure;
  return &empty;
}
#endif
static bool prepare(TyInstance* self, const TyFrame* frame, const TyUniformData* out) {
  (void)self, (void)frame, (void)out;
#ifdef UNRESOLVED
  return tyndall_test_function_that_nobody_defines() != 0;
#else
  return true;
#endif
}

#ifdef NO_SYMBOL
#define ENTRY another_name
#else
#define ENTRY tyndall_plugin
#endif
TY_EXPORT extern const TyPlugin ENTRY;
const TyPlugin ENTRY = {
#ifdef NEWER_MAJOR
    .abi_version = (TY_ABI_MAJOR + 1) << 16,
#elif defined(NEWER_MINOR)
    .abi_version = TY_ABI_VERSION + 1,
#else
    .abi_version = TY_ABI_VERSION,
#endif
#ifdef SHORT_STRUCT /* as if get_extension had not existed yet: the pointer behind it must not be read */
    .struct_size = offsetof(TyPlugin, get_extension),
    .get_extension = (const void* (*)(const char*))(size_t)1,
#elif defined(ZERO_STRUCT)
    .struct_size = 0,
#else
    .struct_size = sizeof(TyPlugin),
#endif
#ifdef BAD_ID
    .id = "../variant",
#else
    .id = "variant",
#endif
#ifdef NULL_NAME
    .name = NULL,
#else
    .name = "Variant",
#endif
    .version = VERSION,
    .doc = "For tests.",
    .init = init,
    .shutdown = shutdown,
    .parameters = parameters,
    .techniques = techniques,
    .create = create,
    .destroy = destroy,
#ifdef NO_LAYOUT
    .layout = NULL,
#else
    .layout = layout,
#endif
    .prepare = prepare,
};
