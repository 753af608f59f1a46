/* The ABI header is C11, and a plugin's struct can be filled by name. */
#include "tyndall/plugin.h"

_Static_assert(offsetof(TyPlugin, abi_version) == 0, "read before anything else");
_Static_assert(offsetof(TyLayout, struct_size) == 0 && offsetof(TyImage, struct_size) == 0 &&
                   offsetof(TyPass, struct_size) == 0,
               "sizes come first");
_Static_assert(TY_ABI_MAJOR_OF(TY_ABI_VERSION) == TY_ABI_MAJOR && TY_ABI_MINOR_OF(TY_ABI_VERSION) == TY_ABI_MINOR,
               "both halves");

/* Compared with the C++ side by structs_test. */
const size_t abiSizesInC[] = {sizeof(TyParameter),   sizeof(TyDevice),       sizeof(TyStructure), sizeof(TyImage),
                              sizeof(TyBuffer),      sizeof(TyUniformBlock), sizeof(TyBinding),   sizeof(TyTarget),
                              sizeof(TyPass),        sizeof(TyDebugView),    sizeof(TyCounters),  sizeof(TyTunable),
                              sizeof(TyLayout),      sizeof(TyView),         sizeof(TyLight),     sizeof(TyFrame),
                              sizeof(TyUniformData), sizeof(TyHost),         sizeof(TyTechnique), sizeof(TyPlugin)};
const size_t abiSizeCountInC = sizeof abiSizesInC / sizeof *abiSizesInC;
