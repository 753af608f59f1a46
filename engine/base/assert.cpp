#include "base/assert.hpp"

#include <cstdio>
#include <cstdlib>

namespace tyndall {

void assertFailed(const char* expression, const char* file, int line, const std::string& message) {
  std::fprintf(stderr, "tyndall: bug: %s:%d: '%s' does not hold: %s\n", file, line, expression, message.c_str());
  std::fflush(stderr);
  std::abort();
}

}  // namespace tyndall
