#include <tyndall/plugin.h>

/* Nothing but the version may be read of it. */
TY_EXPORT const TyPlugin tyndall_plugin = {.abi_version = (TY_ABI_MAJOR + 1u) << 16, .struct_size = sizeof(TyPlugin)};
