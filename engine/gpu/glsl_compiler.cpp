#include <algorithm>
#include <cstring>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include "base/file.hpp"
#include "gpu/shader.hpp"

namespace tyndall::gpu {
namespace {

namespace fs = std::filesystem;

/// #include "x": beside the including file, then in the include folders; #include <x>: in the include folders.
class Includer : public glslang::TShader::Includer {
 public:
  Includer(fs::path source, const std::vector<fs::path>& folders) : source_(std::move(source)), folders_(folders) {}

  IncludeResult* includeLocal(const char* header, const char* from, std::size_t depth) override {
    // The first file is named to glslang by its path, an included one by the path that was resolved here.
    const fs::path folder = (from && *from ? fs::path(from) : source_).parent_path();
    if (IncludeResult* found = open(folder / header)) return found;
    return includeSystem(header, from, depth);
  }
  IncludeResult* includeSystem(const char* header, const char*, std::size_t) override {
    for (const fs::path& folder : folders_)
      if (IncludeResult* found = open(folder / header)) return found;
    return nullptr;
  }
  void releaseInclude(IncludeResult* result) override {
    if (!result) return;
    delete static_cast<std::string*>(result->userData);
    delete result;
  }

 private:
  static IncludeResult* open(const fs::path& path) {
    std::error_code none;
    if (!fs::is_regular_file(path, none)) return nullptr;
    auto text = readText(path);
    if (!text) return nullptr;
    auto* kept = new std::string(text.take());
    return new IncludeResult(path.lexically_normal().string(), kept->data(), kept->size(), kept);
  }
  fs::path source_;
  const std::vector<fs::path>& folders_;
};

/// The first complaints of glslang's log, as one line.
std::string complaints(const fs::path& source, const std::string& log) {
  constexpr int kMost = 3;
  std::string line, joined;
  int count = 0;
  for (std::size_t at = 0; at < log.size() && count < kMost; at += line.size() + 1) {
    line = log.substr(at, log.find('\n', at) - at);
    const std::string marker = "ERROR: ";
    const std::size_t found = line.find(marker);
    if (found == std::string::npos || line.find("compilation errors") != std::string::npos) continue;
    joined += (count++ ? " | " : "") + line.substr(found + marker.size());
  }
  while (!joined.empty() && std::isspace(static_cast<unsigned char>(joined.back()))) joined.pop_back();
  return source.string() + ": " + (joined.empty() ? "glslang refuses it without a reason" : joined);
}

}  // namespace

Result<std::vector<std::uint32_t>> compileGlsl(const fs::path& source, const std::string& stage,
                                               const std::vector<fs::path>& includes) {
  struct Stage {
    const char* name;
    EShLanguage language;
  };
  constexpr Stage kStages[] = {
      {"comp", EShLangCompute}, {"vert", EShLangVertex}, {"frag", EShLangFragment}, {"geom", EShLangGeometry}};
  const auto* known =
      std::find_if(std::begin(kStages), std::end(kStages), [&](const Stage& s) { return stage == s.name; });
  if (known == std::end(kStages))
    return failed(source.string() + ": no shader stage is called '" + stage + "'; comp, vert, frag or geom");
  const auto text = readText(source);
  if (!text) return text.error();

  static const bool initialized = glslang::InitializeProcess();
  if (!initialized) return failed(source.string() + ": glslang does not start");
  glslang::TShader shader(known->language);
  const std::string name = source.string();
  const char* const strings[] = {text->c_str()};
  const int lengths[] = {static_cast<int>(text->size())};
  const char* const names[] = {name.c_str()};
  shader.setStringsWithLengthsAndNames(strings, lengths, names, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, known->language, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
  constexpr auto kRules = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
  Includer includer(source, includes);
  if (!shader.parse(GetDefaultResources(), 100, false, kRules, includer))
    return failed(complaints(source, shader.getInfoLog()));
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(kRules)) return failed(complaints(source, program.getInfoLog()));
  std::vector<std::uint32_t> code;
  glslang::GlslangToSpv(*program.getIntermediate(known->language), code);
  if (code.empty()) return failed(source.string() + ": glslang made no code");
  return code;
}

}  // namespace tyndall::gpu
