#include "library.hpp"

#include <cerrno>
#include <cstring>
#include <span>
#include <system_error>
#include <vector>

#include <dlfcn.h>
#include <elf.h>
#include <sys/stat.h>

#include "base/file.hpp"
#include "base/log.hpp"
#include "call_watch.hpp"

namespace tyndall::host {
namespace fs = std::filesystem;
namespace {

/// The loader maps a truncated library and dies of SIGBUS while relocating it; so every part that the headers promise
/// must be there. What else is wrong with a file, dlopen itself reports.
bool wholeLibrary(std::span<const std::byte> file) {
  Elf64_Ehdr header;
  if (file.size() < sizeof header) return false;
  std::memcpy(&header, file.data(), sizeof header);
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_ident[EI_CLASS] != ELFCLASS64 ||
      header.e_type != ET_DYN)
    return false;
  const auto inside = [&](std::uint64_t offset, std::uint64_t size) {
    return offset <= file.size() && size <= file.size() - offset;
  };
  if (header.e_phentsize != sizeof(Elf64_Phdr)) return false;
  if (!inside(header.e_phoff, std::uint64_t{header.e_phnum} * sizeof(Elf64_Phdr))) return false;
  if (!inside(header.e_shoff, std::uint64_t{header.e_shnum} * header.e_shentsize)) return false;
  for (std::size_t i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr part;
    std::memcpy(&part, file.data() + header.e_phoff + i * sizeof part, sizeof part);
    if (!inside(part.p_offset, part.p_filesz)) return false;
  }
  return true;
}

}  // namespace

Result<FileIdentity> fileIdentity(const fs::path& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return failed(path.string() + ": cannot be opened: " + std::strerror(errno));
  return FileIdentity{info.st_dev, info.st_ino, static_cast<std::uint64_t>(info.st_size),
                      std::int64_t{info.st_mtim.tv_sec} * 1000000000 + info.st_mtim.tv_nsec};
}

Result<std::unique_ptr<Library>> Library::open(const fs::path& original) {
  auto identity = fileIdentity(original);
  if (!identity) return identity.error();
  auto bytes = readFile(original);
  if (!bytes) return bytes.error();
  if (!wholeLibrary(*bytes))
    return failed(original.string() + ": is not a whole shared library; a plugin is a 64-bit ELF .so file");

  std::unique_ptr<Library> library(new Library);
  library->identity_ = *identity;
  const PluginCall call("plugin '" + original.filename().string() + "'", "loading (constructors of static objects)");
  std::string reasons;
  /// True: there is nothing more to try.
  const auto taken = [&](std::variant<LoadedCopy, NoCopy> tried) {
    if (auto* loaded = std::get_if<LoadedCopy>(&tried)) {
      library->copy_.emplace(std::move(*loaded));
      return true;
    }
    const auto& failure = std::get<NoCopy>(tried);
    if (failure.place)
      reasons += (reasons.empty() ? "" : ", ") + failure.reason;
    else
      reasons = "cannot be loaded: " + failure.reason;
    return !failure.place;
  };
  std::error_code none;
  const bool done = taken(loadFromMemory(original, *bytes)) ||
                    taken(loadFromFolder(fs::temp_directory_path(none), original, *bytes)) ||
                    taken(loadFromFolder(cacheFolder(), original, *bytes));
  if (!done) {
    log::warning(
        original.string() + ": is loaded in place, since no copy can be made (" + reasons +
        "); it cannot be reloaded while this program runs; TMPDIR names a folder with room, not mounted noexec");
    reasons.clear();
    (void)taken(loadInPlace(original));
  }
  if (!library->copy_) return failed(original.string() + ": " + reasons);
  return library;
}

void* Library::symbol(const char* name) const { return ::dlsym(copy_->handle, name); }

}  // namespace tyndall::host
