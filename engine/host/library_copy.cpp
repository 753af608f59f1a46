#include "library_copy.hpp"

#include <cerrno>
#include <cstring>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "base/process.hpp"

namespace tyndall::host {
namespace fs = std::filesystem;
namespace {

#ifndef MFD_EXEC
constexpr unsigned MFD_EXEC = 0x10u;  // Linux 6.3: where the system makes such files noexec unless asked
#endif

std::string reasonOf(int code) { return std::strerror(code); }

bool writeAll(int fd, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(fd, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(put));
  }
  return true;
}

/// Whether code can be mapped from the file: not where its file system is mounted noexec.
bool executable(int fd) {
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  void* const mapped = ::mmap(nullptr, page, PROT_READ | PROT_EXEC, MAP_PRIVATE, fd, 0);
  if (mapped == MAP_FAILED) return false;
  ::munmap(mapped, page);
  return true;
}

std::variant<LoadedCopy, NoCopy> load(const fs::path& name, const fs::path& original) {
  LoadedCopy loaded;
  // RTLD_LOCAL: two plugins that share symbol names do not see each other's.
  loaded.handle = ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (loaded.handle != nullptr) return loaded;
  const char* const reason = ::dlerror();
  std::string text = reason ? reason : "unknown reason";
  // The loader names the copy; people know the original.
  if (const auto at = text.find(name.string()); at != std::string::npos)
    text.replace(at, name.string().size(), original.filename().string());
  return NoCopy{text, false};
}

/// Fills an open file that has no name of its own and loads it.
std::variant<LoadedCopy, NoCopy> loadNameless(int file, const std::string& place, const fs::path& original,
                                              std::span<const std::byte> bytes) {
  LoadedCopy holder;
  holder.file = file;
  if (file < 0 || !writeAll(file, bytes)) return NoCopy{place + ": " + reasonOf(errno)};
  // Nobody changes mapped code; where the kernel cannot promise it, only this process has the file.
  (void)::fcntl(file, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL);
  if (!executable(file)) return NoCopy{place + ": code cannot be mapped: " + reasonOf(errno)};
  // With the process's number, so that debuggers and symbolizers, which are other processes, find the file.
  const fs::path name = "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(file);
  if (::access(name.c_str(), R_OK) != 0) return NoCopy{name.string() + ": " + reasonOf(errno)};
  auto loaded = load(name, original);
  if (auto* success = std::get_if<LoadedCopy>(&loaded)) success->file = std::exchange(holder.file, -1);
  return loaded;
}

}  // namespace

LoadedCopy::~LoadedCopy() {
  if (handle != nullptr) ::dlclose(handle);
  if (file >= 0) ::close(file);
}

std::variant<LoadedCopy, NoCopy> loadFromMemory(const fs::path& original, std::span<const std::byte> bytes) {
  const std::string name =
      ("tyndall-plugin-" + original.filename().string()).substr(0, 200);  // the kernel takes 249 bytes
  int file = ::memfd_create(name.c_str(), MFD_CLOEXEC | MFD_ALLOW_SEALING | MFD_EXEC);
  if (file < 0 && errno == EINVAL) file = ::memfd_create(name.c_str(), MFD_CLOEXEC | MFD_ALLOW_SEALING);
  return loadNameless(file, "memory", original, bytes);
}

std::variant<LoadedCopy, NoCopy> loadFromFolder(const fs::path& folder, const fs::path& original,
                                                std::span<const std::byte> bytes) {
  if (folder.empty()) return NoCopy{"no cache folder"};
  int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file < 0 && (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL)) {  // not on this file system
    const TemporaryFile temporary(folder);
    file = ::open(temporary.path().c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  }
  return loadNameless(file, folder.string(), original, bytes);
}

std::variant<LoadedCopy, NoCopy> loadInPlace(const fs::path& original) {
  std::error_code none;
  const fs::path whole = fs::absolute(original, none);  // dlopen looks for a name without a slash elsewhere
  if (void* const same = ::dlopen(whole.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD)) {
    ::dlclose(same);
    return NoCopy{"it is loaded already, and no copy can be made"};
  }
  auto loaded = load(whole, original);
  if (auto* success = std::get_if<LoadedCopy>(&loaded)) success->inPlace = true;
  return loaded;
}

}  // namespace tyndall::host
