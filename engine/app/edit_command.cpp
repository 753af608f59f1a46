#include <cerrno>
#include <cstring>

#include <unistd.h>

#include "base/file.hpp"
#include "commands.hpp"

namespace tyndall::app {

Result<void> runEdit(const EditOptions& options) {
  const std::filesystem::path editor = executableFolder() / "tyndall-editor";
  std::error_code missing;
  if (!std::filesystem::exists(editor, missing))
    return failed("edit: " + editor.string() + " is not built; configure with TYNDALL_BUILD_EDITOR=ON and build");
  std::string program = editor.string();
  std::vector<std::string> arguments = options.arguments;
  std::vector<char*> pointers{program.data()};
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  ::execv(program.c_str(), pointers.data());
  return failed("edit: " + program + " cannot be started: " + std::strerror(errno));
}

}  // namespace tyndall::app
