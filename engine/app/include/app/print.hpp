// Results go to standard output.
#pragma once

#include <string>

#include "base/result.hpp"

namespace tyndall::app {

/// Writes a result to standard output, to its last byte. Errors: it takes no more; its reader has gone
/// (ErrorKind::kUnread).
Result<void> print(const std::string& text);

}  // namespace tyndall::app
