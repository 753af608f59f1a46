#include "base/file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file_set.hpp"
#include "base/process.hpp"

namespace tyndall {
namespace fs = std::filesystem;

namespace {

/// A file descriptor that closes itself.
struct Descriptor {
  int fd = -1;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

std::string reason() { return std::strerror(errno); }

}  // namespace

Result<std::vector<std::byte>> readFile(const fs::path& path, std::uint64_t maxBytes) {
  // O_NONBLOCK: opening a pipe that nobody writes to must not hang; the regular-file test below then refuses it.
  Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  if (file.fd < 0) return failed(path.string() + ": cannot be opened: " + reason());
  struct stat info {};
  if (::fstat(file.fd, &info) != 0) return failed(path.string() + ": cannot be examined: " + reason());
  if (!S_ISREG(info.st_mode)) return failed(path.string() + ": is not a regular file");
  const auto size = static_cast<std::uint64_t>(info.st_size);
  if (size > maxBytes)
    return failed(path.string() + ": is " + std::to_string(size) + " bytes long; at most " + std::to_string(maxBytes) +
                  " are read");
  std::vector<std::byte> bytes(size);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::read(file.fd, bytes.data() + done, bytes.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return failed(path.string() + ": cannot be read: " + reason());
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

Result<std::string> readText(const fs::path& path, std::uint64_t maxBytes) {
  auto bytes = readFile(path, maxBytes);
  if (!bytes) return bytes.error();
  return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
}

Result<void> writeFileAtomically(const fs::path& path, std::span<const std::byte> bytes) {
  auto target = followLinks(path);
  if (!target) return target.error();
  struct stat old {};
  const bool replaces = ::stat(target->c_str(), &old) == 0;
  if (replaces && S_ISDIR(old.st_mode)) return failed(path.string() + ": is a folder; a file name is needed");
  // A device or a pipe would be replaced by a file, not written to.
  if (replaces && !S_ISREG(old.st_mode)) return failed(path.string() + ": is not a regular file; name another");

  TemporaryFile temporary(target->parent_path());
  Descriptor file{::open(temporary.path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)};
  if (file.fd < 0) return failed(path.string() + ": cannot be written: " + reason());
  const auto fail = [&](const char* what) { return failed(path.string() + ": " + what + ": " + reason()); };
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t put = ::write(file.fd, bytes.data() + done, bytes.size() - done);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return fail("cannot be written");
    done += static_cast<std::size_t>(put);
  }
  if (replaces && ::fchmod(file.fd, old.st_mode & 0777) != 0) return fail("cannot be written");
  if (::fsync(file.fd) != 0 && errno != EINVAL) return fail("cannot be written");
  const SignalsWait wait;
  if (::rename(temporary.path().c_str(), target->c_str()) != 0) return fail("cannot be put in place");
  temporary.forget();
  return {};
}

Result<void> writeTextAtomically(const fs::path& path, std::string_view text) {
  return writeFileAtomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

fs::path executableFolder() {
  std::error_code failedCode;
  const fs::path self = fs::read_symlink("/proc/self/exe", failedCode);
  return failedCode ? fs::current_path(failedCode) : self.parent_path();
}

std::string nearestName(std::string_view text, std::span<const std::string> candidates) {
  std::string best;
  std::size_t bestDistance = std::max<std::size_t>(2, text.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    // Levenshtein distance with one row of memory.
    std::vector<std::size_t> row(candidate.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= text.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= candidate.size(); ++j) {
        const std::size_t substituted = diagonal + (text[i - 1] == candidate[j - 1] ? 0 : 1);
        diagonal = row[j];
        row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
      }
    }
    if (row.back() < bestDistance) {
      bestDistance = row.back();
      best = candidate;
    }
  }
  return best;
}

}  // namespace tyndall
