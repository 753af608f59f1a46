#include "library.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <span>
#include <system_error>
#include <vector>

#include <dlfcn.h>
#include <elf.h>
#include <sys/stat.h>

#include "base/file.hpp"

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

/// A new folder that only this user can enter; empty if there is no place for one.
fs::path privateFolder() {
  std::error_code none;
  for (const fs::path& parent : {fs::temp_directory_path(none), cacheFolder()}) {
    if (parent.empty()) continue;
    std::string name = (parent / "tyndall-plugin-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) return name;
  }
  return {};
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
  library->folder_ = privateFolder();
  if (library->folder_.empty())
    return failed(original.string() + ": no temporary folder for the plugin's copy can be made; set TMPDIR to one");
  const fs::path copy = library->folder_ / original.filename();
  if (auto written = writeFileAtomically(copy, *bytes); !written) return written.error();
  // RTLD_LOCAL: two plugins that share symbol names do not see each other's.
  library->handle_ = ::dlopen(copy.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library->handle_ == nullptr) {
    const char* reason = ::dlerror();
    std::string text = reason ? reason : "unknown reason";
    // The loader names the copy; people know the original.
    if (const auto at = text.find(copy.string()); at != std::string::npos)
      text.replace(at, copy.string().size(), original.filename().string());
    return failed(original.string() + ": cannot be loaded: " + text);
  }
  return library;
}

Library::~Library() {
  if (handle_ != nullptr) ::dlclose(handle_);
  std::error_code none;
  if (!folder_.empty()) fs::remove_all(folder_, none);
}

void* Library::symbol(const char* name) const { return ::dlsym(handle_, name); }

}  // namespace tyndall::host
