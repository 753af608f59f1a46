#include "base/file_set.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tyndall {
namespace fs = std::filesystem;
namespace {

/// 0 or errno.
int code(int result) { return result == 0 ? 0 : errno; }

int renamed(const fs::path& from, const fs::path& to, unsigned flags) {
  return code(::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), flags));
}

/// The kernel or the file system does not know the flags of renameat2.
bool unknown(int reason) { return reason == EINVAL || reason == ENOSYS || reason == ENOTSUP; }

}  // namespace

Result<fs::path> followLinks(const fs::path& path) {
  constexpr int kMostLinks = 40;  // as many as the kernel follows
  fs::path at = path;
  for (int i = 0; i <= kMostLinks; ++i) {
    std::error_code none;
    const fs::path next = fs::read_symlink(at, none);
    if (none) return at;
    at = at.parent_path() / next;  // an absolute one replaces all
  }
  return failed(path.string() + ": is a symbolic link that leads in a circle; name another file");
}

Result<fs::path> FileSet::stage(const fs::path& path, const std::string& subject) {
  auto target = followLinks(path);
  if (!target) return target;
  return files_.emplace_back(subject, target.take()).temporary.path();
}

int FileSet::placeOne(Staged& file) {
  const fs::path& temporary = file.temporary.path();
  for (int attempt = 0; attempt < 2; ++attempt) {  // a second time where somebody made or removed the target meanwhile
    struct stat old {};
    if (::lstat(file.target.c_str(), &old) != 0) {
      int reason = renamed(temporary, file.target, RENAME_NOREPLACE);
      if (unknown(reason)) reason = code(std::rename(temporary.c_str(), file.target.c_str()));
      if (reason == EEXIST) continue;
      if (reason == 0) file.state = State::kMade;
      return reason;
    }
    if (S_ISDIR(old.st_mode)) return EISDIR;
    (void)::chmod(temporary.c_str(), old.st_mode & 0777);
    int reason = renamed(temporary, file.target, RENAME_EXCHANGE);
    if (reason == ENOENT) continue;
    if (reason == 0) {
      file.state = State::kExchanged;
      struct stat replaced {};  // exchanging takes folders too
      if (::lstat(temporary.c_str(), &replaced) != 0 || !S_ISDIR(replaced.st_mode)) return 0;
      (void)takeBackOne(file);
      return EISDIR;
    }
    if (!unknown(reason)) return reason;
    reason = code(std::rename(file.target.c_str(), file.aside.path().c_str()));
    if (reason != 0) return reason;
    reason = code(std::rename(temporary.c_str(), file.target.c_str()));
    if (reason == 0)
      file.state = State::kMovedAside;
    else
      (void)std::rename(file.aside.path().c_str(), file.target.c_str());
    return reason;
  }
  return EBUSY;
}

int FileSet::takeBackOne(Staged& file) {
  int reason = 0;
  switch (file.state) {
    case State::kStaged: return 0;
    case State::kMade: reason = code(::unlink(file.target.c_str())); break;
    case State::kExchanged: reason = renamed(file.temporary.path(), file.target, RENAME_EXCHANGE); break;
    case State::kMovedAside: reason = code(std::rename(file.aside.path().c_str(), file.target.c_str())); break;
  }
  if (reason == 0) file.state = State::kStaged;
  return reason;
}

Result<void> FileSet::place() {
  const SignalsWait wait;
  for (Staged& file : files_) {
    const int reason = placeOne(file);
    if (reason == 0) continue;
    std::string message = file.subject + ": cannot be put in place: " + std::strerror(reason);
    if (auto back = takeBack(); !back) message += "; " + back.error().message;
    return failed(std::move(message));
  }
  return {};
}

Result<void> FileSet::takeBack() {
  const SignalsWait wait;
  Result<void> done;
  for (auto file = files_.rbegin(); file != files_.rend(); ++file) {
    const int reason = takeBackOne(*file);
    if (reason == 0) continue;
    // What was there is not thrown away: it stays under the name that it has.
    std::string message = file->subject + ": what was there before cannot be put back: " + std::strerror(reason);
    TemporaryFile* const kept = file->state == State::kExchanged    ? &file->temporary
                                : file->state == State::kMovedAside ? &file->aside
                                                                    : nullptr;
    if (kept != nullptr) {
      message += "; it is now " + kept->path().string();
      kept->forget();
    }
    done = failed(std::move(message));
  }
  return done;
}

}  // namespace tyndall
