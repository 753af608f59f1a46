// SPIR-V from disk and its recompilation while running.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace tyndall::gpu {

/// SPIR-V of one shader stage. `version` changes when the code does.
struct Shader {
  std::string name;  ///< "moments_evaluate.comp"
  std::vector<std::uint32_t> code;
  std::uint64_t version = 0;
};

/// Finds <name>.spv in its folders; the engine has one for shaders/, the host one for each plugin.
class ShaderFolder {
 public:
  explicit ShaderFolder(std::filesystem::path folder);
  /// The shader's code; loaded at the first call. Errors name the file.
  Result<std::shared_ptr<const Shader>> get(const std::string& name);

  struct Reload {
    std::vector<std::string> changed;
    std::vector<Error> errors;
  };
  /// Looks at the sources that the loaded shaders were built from (the .spv.json beside each names source and include
  /// folders; includes are followed) and recompiles those whose newest file changed since. A shader that does not
  /// compile keeps its last good code and is reported in `errors` with the compiler's message.
  Reload reloadChanged();

 private:
  struct Entry;
  std::filesystem::path folder_;
  std::vector<std::shared_ptr<Entry>> entries_;
};

/// Compiles GLSL (glslang library, target Vulkan 1.3) to SPIR-V. `stage` is "comp", "vert", "frag" or "geom".
Result<std::vector<std::uint32_t>> compileGlsl(const std::filesystem::path& source, const std::string& stage,
                                               const std::vector<std::filesystem::path>& includes);

}  // namespace tyndall::gpu
