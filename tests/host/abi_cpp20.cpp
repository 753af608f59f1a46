// The ABI header is C++20, twice included.
#include "tyndall/plugin.h"

static_assert(offsetof(TyPlugin, abi_version) == 0);
TY_EXPORT extern const TyImage abiImageInCpp;
const TyImage abiImageInCpp = {.struct_size = sizeof(TyImage),
                               .kind = TY_IMAGE_2D,
                               .name = "x",
                               .format = TY_FORMAT_R8_UNORM,
                               .width = 1,
                               .height = 1,
                               .depth = 1,
                               .mips = 1,
                               .flags = TY_RESOURCE_HISTORY};
