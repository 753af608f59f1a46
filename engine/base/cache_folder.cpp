// Where what can be made again is kept from one run to the next.
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <vector>

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file.hpp"
#include "base/log.hpp"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

fs::path variable(const char* name) {
  const char* const value = std::getenv(name);
  // A relative one would mean another folder in each working folder; the XDG specification has it ignored.
  return value != nullptr && *value == '/' ? fs::path(value) : fs::path();
}

fs::path homeOfUser() {
  std::vector<char> text(16384);
  passwd entry{}, *found = nullptr;
  if (::getpwuid_r(::geteuid(), &entry, text.data(), text.size(), &found) != 0 || found == nullptr) return {};
  return found->pw_dir != nullptr && *found->pw_dir == '/' ? fs::path(found->pw_dir) : fs::path();
}

bool usable(const fs::path& folder) {
  std::error_code bad;
  fs::create_directories(folder, bad);
  return !bad && ::access(folder.c_str(), R_OK | W_OK | X_OK) == 0;
}

/// A folder of this user alone where everybody may make folders: somebody else's of that name is not taken.
bool ownFolder(const fs::path& folder) {
  if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return false;
  struct stat info {};
  return ::lstat(folder.c_str(), &info) == 0 && S_ISDIR(info.st_mode) && info.st_uid == ::geteuid() &&
         (info.st_mode & 0077) == 0;
}

}  // namespace

fs::path cacheFolder() {
  if (const fs::path xdg = variable("XDG_CACHE_HOME"); !xdg.empty() && usable(xdg / "tyndall")) return xdg / "tyndall";
  for (const fs::path& home : {variable("HOME"), homeOfUser()})
    if (!home.empty() && usable(home / ".cache" / "tyndall")) return home / ".cache" / "tyndall";
  std::error_code none;
  const fs::path temporary = fs::temp_directory_path(none);
  if (!none) {
    const fs::path folder = temporary / ("tyndall-" + std::to_string(::geteuid()));
    if (ownFolder(folder) && usable(folder)) return folder;
  }
  static const bool told = [] {
    log::warning("nothing is kept for the next run: no cache folder can be made; set XDG_CACHE_HOME to one");
    return true;
  }();
  (void)told;
  return {};
}

}  // namespace tyndall
