// Logging by spdlog, kept out of headers (spdlog costs 6 s a file). Everything goes to stderr; stdout belongs to
// results.
#pragma once

#include <string_view>

namespace tyndall::log {

enum class Level { kDebug, kInfo, kWarning, kError };

/// Lines below `level` are dropped. Default: kInfo; the environment variable TYNDALL_LOG (debug, info, warning, error)
/// overrides it.
void setLevel(Level level);
void debug(std::string_view line);
void info(std::string_view line);
void warning(std::string_view line);
void error(std::string_view line);

}  // namespace tyndall::log
