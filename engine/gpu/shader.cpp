#include "gpu/shader.hpp"

#include <algorithm>
#include <cstring>

#include "base/file.hpp"
#include "shader_sources.hpp"

namespace tyndall::gpu {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kSpirvMagic = 0x07230203;  // SPIR-V specification 2.3, "Physical Layout"
constexpr std::size_t kSpirvHeaderWords = 5;

Result<std::vector<std::uint32_t>> readSpirv(const fs::path& file) {
  constexpr std::uint64_t kMostBytes = 64ull << 20;
  const auto bytes = readFile(file, kMostBytes);
  if (!bytes) return bytes.error();
  std::vector<std::uint32_t> code(bytes->size() / sizeof(std::uint32_t));
  if (bytes->size() % sizeof(std::uint32_t) != 0 || code.size() < kSpirvHeaderWords)
    return failed(file.string() + ": not SPIR-V (its size)");
  std::memcpy(code.data(), bytes->data(), bytes->size());
  if (code[0] != kSpirvMagic) return failed(file.string() + ": not SPIR-V (its first word)");
  return code;
}

}  // namespace

struct ShaderFolder::Entry {
  std::shared_ptr<const Shader> shader;
  std::optional<ShaderSource> source;
  std::vector<fs::path> files;    ///< that the code was made from
  std::uint64_t fingerprint = 0;  ///< of the files when the code was made; 0: the files are newer than it
};

ShaderFolder::ShaderFolder(fs::path folder) : folder_(std::move(folder)) {}

Result<std::shared_ptr<const Shader>> ShaderFolder::get(const std::string& name) {
  for (const auto& entry : entries_)
    if (entry->shader->name == name) return entry->shader;
  const fs::path file = folder_ / (name + ".spv");
  auto code = readSpirv(file);
  if (!code) return code.error();
  auto entry = std::make_shared<Entry>();
  entry->shader = std::make_shared<Shader>(Shader{name, code.take(), 1});
  entry->source = readShaderSource(folder_ / (name + ".spv.json"));
  if (entry->source) {
    entry->files = sourceFiles(*entry->source);
    entry->fingerprint = anyNewer(entry->files, file) ? 0 : fingerprint(entry->files);
  }
  entries_.push_back(entry);
  return entry->shader;
}

ShaderFolder::Reload ShaderFolder::reloadChanged() {
  Reload report;
  std::error_code none;
  for (const auto& entry : entries_) {
    if (!entry->source || !fs::is_regular_file(entry->source->source, none)) continue;
    if (fingerprint(entry->files) == entry->fingerprint) continue;
    entry->files = sourceFiles(*entry->source);
    entry->fingerprint = fingerprint(entry->files);  // also after an error, which is then reported once per change
    auto code = compileGlsl(entry->source->source, entry->source->stage, entry->source->includes);
    if (!code) {
      report.errors.push_back(code.error());
    } else if (*code != entry->shader->code) {
      entry->shader = std::make_shared<Shader>(Shader{entry->shader->name, code.take(), entry->shader->version + 1});
      report.changed.push_back(entry->shader->name);
    }
  }
  return report;
}

}  // namespace tyndall::gpu
