#include "sanitizer.hpp"

#ifdef __SANITIZE_ADDRESS__

#include <cstring>

#include <dlfcn.h>
#include <link.h>

// Leaks of others: the validation layer keeps what it learned of shaders and queues; LLVM, by which lavapipe compiles.
extern "C" __attribute__((visibility("default"))) const char* __lsan_default_suppressions() {
  return "leak:libVkLayer_\nleak:libvulkan\nleak:libLLVM\n";
}

// Without a list of what was suppressed: a failure of the program stays one line on stderr.
extern "C" __attribute__((visibility("default"))) const char* __lsan_default_options() {
  return "print_suppressions=0";
}

namespace tyndall::gpu {

void keepDriversLoaded() {
  const auto keep = [](dl_phdr_info* module, std::size_t, void*) {
    if (std::strstr(module->dlpi_name, "libvulkan") || std::strstr(module->dlpi_name, "libVkLayer"))
      dlopen(module->dlpi_name, RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
    return 0;
  };
  dl_iterate_phdr(keep, nullptr);
}

}  // namespace tyndall::gpu

#else

namespace tyndall::gpu {
void keepDriversLoaded() {}
}  // namespace tyndall::gpu

#endif
