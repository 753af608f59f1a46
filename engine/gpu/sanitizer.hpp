// What AddressSanitizer builds need to know of drivers; does nothing in others.
#pragma once

namespace tyndall::gpu {

/// Keeps the drivers and layers that are loaded now until the program ends. A driver that is unloaded takes with it the
/// pointers to what it still holds, and all that would be reported as leaks of places without a name.
void keepDriversLoaded();

}  // namespace tyndall::gpu
