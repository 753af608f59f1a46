#include "app/outputs.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <unistd.h>

namespace tyndall::app {
namespace fs = std::filesystem;

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Whether both lead to one file: the same that is there, or the same name in one folder.
bool samePlace(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  if (fs::equivalent(a, b, ignored)) return true;
  const auto place = [&ignored](const fs::path& path) {
    const auto end = followLinks(path);
    // Of a path that does not exist, only an absolute one becomes canonical in full.
    return fs::weakly_canonical(fs::absolute(end ? end.value() : path, ignored), ignored);
  };
  return place(a) == place(b);
}

}  // namespace

Result<void> Outputs::add(const std::string& option, const fs::path& path, const std::string& extension) {
  const std::string subject = option + " " + path.string() + ": ";
  if (path.empty()) return badCall(option + ": the file name is empty; a name ending in " + extension + " is needed");
  if (lower(path.extension().string()) != extension) return badCall(subject + "must end in " + extension);
  const auto target = followLinks(path);
  if (!target) return Error{option + " " + target.error().message, target.error().kind};
  std::error_code failedCode;
  const fs::file_status status = fs::status(*target, failedCode);
  if (status.type() == fs::file_type::none) return failed(subject + failedCode.message() + "; name another file");
  if (fs::is_directory(status)) return failed(subject + "is a folder; a file name is needed");
  if (fs::exists(status) && !fs::is_regular_file(status))
    return failed(subject + "is not a regular file; name another");
  const fs::path folder = target->has_parent_path() ? target->parent_path() : fs::path(".");
  if (!fs::is_directory(folder, failedCode))
    return failed(subject + "the folder " + folder.string() + " does not exist; make it first");
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return failed(subject + "the folder " + folder.string() + " cannot be written to (" + std::strerror(errno) +
                  "); choose another");
  // A file that its owner may not write to is replaced all the same; one that nobody may (immutable) is not.
  if (fs::exists(status) && ::access(target->c_str(), W_OK) != 0 && errno != EACCES)
    return failed(subject + "cannot be replaced (" + std::strerror(errno) + "); name another file");
  for (const Output& other : outputs_)
    if (samePlace(other.path, path))
      return badCall(subject + "is also the file of " + other.option + "; each needs its own");
  for (const fs::path& input : inputs_)
    if (samePlace(input, path)) return badCall(subject + "is an input of this call; name another file");
  outputs_.push_back({option, path});
  return {};
}

Result<void> Outputs::write(const std::string& option, const Write& write) {
  for (const Output& output : outputs_) {
    if (output.option != option) continue;
    // Beside its final place, so that placing it is a rename within one file system.
    const auto temporary = files_.stage(output.path, output.subject());
    if (!temporary) return Error{option + " " + temporary.error().message, temporary.error().kind};
    auto done = write(*temporary);
    if (!done) {
      std::string message = done.error().message;
      // The user knows the name asked for, not the temporary one.
      if (const auto at = message.find(temporary->string()); at != std::string::npos)
        message.replace(at, temporary->string().size(), output.path.string());
      return Error{option + " " + message, done.error().kind};
    }
  }
  return {};
}

Result<void> Outputs::commit(const std::function<Result<void>()>& tell) {
  if (auto placed = files_.place(); !placed) return placed;
  if (!tell) return {};
  auto told = tell();
  if (told) return told;
  if (auto back = files_.takeBack(); !back) return Error{told.error().message + "; " + back.error().message};
  return told;
}

std::vector<fs::path> Outputs::paths() const {
  std::vector<fs::path> all;
  for (const Output& output : outputs_) all.push_back(output.path);
  return all;
}

}  // namespace tyndall::app
