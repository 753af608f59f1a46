// results.csv and the comparison of two results.
#include "bench/results.hpp"

#include <cmath>
#include <cstdio>

namespace tyndall::bench {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string settingsText(const Assignments& settings) {
  std::string text;
  for (const auto& [id, value] : settings) text += (text.empty() ? "" : " ") + id + "=" + value;
  return text;
}

std::string errorColumns(const std::optional<SplitErrors>& e) {
  std::string text;
  for (const auto part : {&SplitErrors::all, &SplitErrors::silhouettes, &SplitErrors::interior, &SplitErrors::light}) {
    const std::optional<Errors> errors = e ? (*e).*part : std::nullopt;
    text += errors ? "," + number(errors->nrmse) + "," + number(errors->p99) + "," + number(errors->maximum) + "," +
                         number(errors->bias)
                   : ",,,,";
  }
  return text;
}

}  // namespace

const PointFigures* Results::find(const std::string& key) const {
  for (const PointFigures& p : points)
    if (p.key == key) return &p;
  return nullptr;
}

std::string resultsCsv(const Results& results) {
  std::string csv =
      "level,camera,width,height,series,technique,label,settings,gpu_ms,volumetrics_ms,volumetrics_ms_low,volumetrics_"
      "ms_high,shadow_ms,memory_bytes,floor_bytes";
  for (const char* reference : {"truth", "march"})
    for (const char* part : {"all", "silhouettes", "interior", "light"})
      for (const char* figure : {"nrmse", "p99", "maximum", "bias"})
        csv += std::string(",") + reference + "_" + part + "_" + figure;
  csv += ",motion_nrmse,flicker,failed\n";
  for (const PointFigures& p : results.points) {
    csv += quoted(p.level) + "," + std::to_string(p.camera) + "," + std::to_string(p.size.first) + "," +
           std::to_string(p.size.second) + "," + quoted(p.series) + "," + quoted(p.technique) + "," + quoted(p.label) +
           "," + quoted(settingsText(p.settings)) + ",";
    if (p.failure.empty())
      csv += number(p.gpu.median) + "," + number(p.volumetrics.median) + "," + number(p.volumetrics.low) + "," +
             number(p.volumetrics.high) + "," + number(p.shadows.median) + "," + std::to_string(p.memoryBytes) + "," +
             (p.movedBytes ? std::to_string(*p.movedBytes) : "");
    else
      csv += ",,,,,,";
    csv += errorColumns(p.truth) + errorColumns(p.march) + "," + (p.motionError ? number(*p.motionError) : "") + "," +
           (p.flicker ? number(*p.flicker) : "") + "," + quoted(p.failure) + "\n";
  }
  return csv;
}

std::string compareResults(const Results& a, const Results& b) {
  std::string text;
  char line[512];
  std::snprintf(line, sizeof line, "%-58s %10s %10s %7s %9s %9s %7s\n", "point", "a ms", "b ms", "b/a", "a nRMSE",
                "b nRMSE", "b/a");
  text += line;
  std::vector<double> times, errors;
  std::size_t missing = 0;
  for (const PointFigures& p : a.points) {
    const PointFigures* q = b.find(p.key);
    if (!q || !p.failure.empty() || !q->failure.empty()) {
      ++missing;
      continue;
    }
    const double time = p.volumetrics.median > 0 ? q->volumetrics.median / p.volumetrics.median : NAN;
    const auto error = [](const PointFigures& f) { return f.truth && f.truth->all ? f.truth->all->nrmse : NAN; };
    const double ratio = error(*q) / error(p);
    if (std::isfinite(time)) times.push_back(time);
    if (std::isfinite(ratio)) errors.push_back(ratio);
    const std::string name = p.level + " " + std::to_string(p.camera) + " " + std::to_string(p.size.first) + "x" +
                             std::to_string(p.size.second) + " " + p.series + ", " + p.label;
    std::snprintf(line, sizeof line, "%-58.58s %10.4g %10.4g %7.3f %9.4g %9.4g %7.3f\n", name.c_str(),
                  p.volumetrics.median, q->volumetrics.median, time, error(p), error(*q), ratio);
    text += line;
  }
  for (const PointFigures& q : b.points) missing += a.find(q.key) == nullptr ? 1 : 0;
  std::snprintf(line, sizeof line,
                "median of %zu points: time %.3f, error %.3f; %zu points stand in one of the two only, or failed\n",
                times.size(), spreadOf(times).median, spreadOf(errors).median, missing);
  return text + line;
}

}  // namespace tyndall::bench
