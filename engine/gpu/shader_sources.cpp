#include "shader_sources.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/json_shape.hpp"

namespace tyndall::gpu {
namespace {

namespace fs = std::filesystem;

/// Names in `#include "x"` and `#include <x>` lines.
std::vector<std::string> includedNames(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::size_t i = text.find_first_not_of(" \t", at);
    if (i < end && text[i] == '#') {
      i = text.find_first_not_of(" \t", i + 1);
      if (i < end && text.compare(i, 7, "include") == 0) {
        const std::size_t open = text.find_first_of("\"<", i);
        const std::size_t close = open < end ? text.find_first_of("\">", open + 1) : std::string::npos;
        if (close < end) names.push_back(text.substr(open + 1, close - open - 1));
      }
    }
    at = end + 1;
  }
  return names;
}

}  // namespace

std::optional<ShaderSource> readShaderSource(const fs::path& json) {
  std::error_code none;
  if (!fs::is_regular_file(json, none)) return std::nullopt;
  const auto text = readText(json);
  if (!text || !jsonShapeProblem(*text).empty()) return std::nullopt;
  const auto parsed = nlohmann::json::parse(*text, nullptr, false);
  if (!parsed.is_object()) return std::nullopt;
  const auto string = [](const nlohmann::json& value) {
    return value.is_string() ? value.get<std::string>() : std::string();
  };
  ShaderSource source{
      string(parsed.value("source", nlohmann::json())), string(parsed.value("stage", nlohmann::json())), {}};
  for (const auto& folder : parsed.value("includes", nlohmann::json::array()))
    if (folder.is_string()) source.includes.emplace_back(folder.get<std::string>());
  if (!fs::is_regular_file(source.source, none)) return std::nullopt;
  return source;
}

std::vector<fs::path> sourceFiles(const ShaderSource& source) {
  std::vector<fs::path> files{source.source.lexically_normal()};
  std::error_code none;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto text = readText(files[i]);
    if (!text) continue;  // it is being written; the compiler says what is wrong
    for (const std::string& name : includedNames(*text)) {
      std::vector<fs::path> folders{files[i].parent_path()};
      folders.insert(folders.end(), source.includes.begin(), source.includes.end());
      for (const fs::path& folder : folders) {
        const fs::path file = (folder / name).lexically_normal();
        if (!fs::is_regular_file(file, none)) continue;
        if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
        break;
      }
    }
  }
  return files;
}

std::uint64_t fingerprint(const std::vector<fs::path>& files) {
  Hash hash;
  for (const fs::path& file : files) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error).time_since_epoch().count();
    hash.add(error ? 0 : static_cast<std::uint64_t>(time));
    const auto size = fs::file_size(file, error);
    hash.add(error ? 0 : static_cast<std::uint64_t>(size));
  }
  return hash.value();
}

bool anyNewer(const std::vector<fs::path>& files, const fs::path& file) {
  std::error_code error;
  const auto built = fs::last_write_time(file, error);
  if (error) return false;
  return std::any_of(files.begin(), files.end(), [&](const fs::path& source) {
    const auto written = fs::last_write_time(source, error);
    return !error && written > built;
  });
}

}  // namespace tyndall::gpu
