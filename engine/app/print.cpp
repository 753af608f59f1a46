#include "app/print.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace tyndall::app {

Result<void> print(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return {};
  const ErrorKind kind = errno == EPIPE ? ErrorKind::kUnread : ErrorKind::kFailed;
  return Error{std::string("standard output: cannot be written: ") + std::strerror(errno) +
                   "; something that takes the results is needed",
               kind};
}

}  // namespace tyndall::app
