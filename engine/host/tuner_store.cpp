#include <cmath>

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/json_shape.hpp"
#include "base/log.hpp"
#include "tuner.hpp"

namespace tyndall::host {
namespace {

std::map<std::string, double> read(const std::filesystem::path& file) {
  std::map<std::string, double> known;
  const auto text = tyndall::readText(file, 1u << 20);
  if (!text) return known;  // not there yet
  const auto json = jsonShapeProblem(*text).empty() ? nlohmann::json::parse(*text, nullptr, false) : nlohmann::json();
  if (!json.is_object()) {
    log::debug(file.string() + ": is damaged; speed variants are timed anew");
    return known;
  }
  for (const auto& [key, value] : json.items())
    if (value.is_number()) known[key] = value.get<double>();
  return known;
}

}  // namespace

TunerStore::TunerStore(std::filesystem::path file) : file_(std::move(file)) {
  if (!file_.empty()) known_ = read(file_);
}

const double* TunerStore::find(const std::string& key) const {
  const auto found = known_.find(key);
  return found == known_.end() ? nullptr : &found->second;
}

void TunerStore::remember(const std::string& key, double variant) {
  if (file_.empty()) return;
  known_ = read(file_);
  known_[key] = variant;
  const auto text = nlohmann::json(known_).dump(1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (auto written = writeTextAtomically(file_, text); !written)
    log::debug("speed variants are not remembered: " + written.error().message);
}

}  // namespace tyndall::host
