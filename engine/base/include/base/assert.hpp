// TY_ASSERT: for our own bugs, in every build type. Prints expression, place and message, then aborts.
#pragma once

#include <string>

namespace tyndall {
[[noreturn]] void assertFailed(const char* expression, const char* file, int line, const std::string& message);
}  // namespace tyndall

/// `message` is any std::string expression; put the values there. Evaluated only when the assertion fails.
#define TY_ASSERT(expression, message)                                                    \
  do {                                                                                    \
    if (!(expression)) ::tyndall::assertFailed(#expression, __FILE__, __LINE__, message); \
  } while (false)
