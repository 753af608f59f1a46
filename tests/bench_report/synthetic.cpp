#include "synthetic.hpp"

#include <cmath>

namespace tyndall::bench::test {
namespace {

using Json = nlohmann::json;

Json spread(double median, double n = 15) {
  return {{"median", median}, {"low", 0.98 * median}, {"high", 1.03 * median}, {"n", n}};
}

Json region(double nrmse, double pixels) {
  return {{"nrmse", nrmse}, {"p99", 4.5 * nrmse}, {"maximum", 20 * nrmse}, {"bias", -0.1 * nrmse}, {"pixels", pixels}};
}

Json full(const std::string& level, const std::string& series, const std::string& technique, double knob, double ms,
          double nrmse, int width = 1280, int height = 720) {
  Json p = point(series, technique, "K = " + std::to_string(static_cast<int>(knob)), ms, nrmse);
  p["level"] = level;
  p["size"] = {width, height};
  p["key"] = level + "/" + series + "/" + std::to_string(knob) + "/" + std::to_string(width);
  p["knob"] = {{"id", "volumetrics.knob"}, {"value", knob}};
  p["settings"] = {{"volumetrics.knob", knob}, {"volumetrics.placement", "pixel"}, {"volumetrics.jitter", true}};
  p["gpu_ms"] = spread(ms + 200);
  p["shadow_ms"] = spread(80);
  p["passes"] = {{{"name", "gbuffer"}, {"owner", "engine"}, {"ms", 120}},
                 {{"name", "rectify"}, {"owner", "volumetrics"}, {"ms", 0.3 * ms}},
                 {{"name", "evaluate"}, {"owner", "volumetrics"}, {"ms", 0.69 * ms}}};
  p["memory_bytes"] = 24e6;
  p["floor_bytes"] = 0.2 * ms * 1e-3 * 10e9;  // a fifth of the time at 10 GB/s
  const double pixels = width * height;
  p["error"]["truth"] = {{"all", region(nrmse, pixels)},
                         {"silhouettes", region(3 * nrmse, 0.05 * pixels)},
                         {"interior", region(0.7 * nrmse, 0.95 * pixels)},
                         {"light", nullptr}};
  p["error"]["march"] = {
      {"all", region(0.8 * nrmse, pixels)}, {"silhouettes", nullptr}, {"interior", nullptr}, {"light", nullptr}};
  return p;
}

}  // namespace

Json point(const std::string& series, const std::string& technique, const std::string& label, double ms, double nrmse) {
  return {{"key", series + "/" + label},
          {"level", "hall"},
          {"camera", 0},
          {"seconds", 0},
          {"size", {1280, 720}},
          {"series", series},
          {"technique", technique},
          {"label", label},
          {"plot", {"error_time"}},
          {"volumetrics_ms", spread(ms)},
          {"error", {{"truth", {{"all", region(nrmse, 921600)}}}}}};
}

Json results() {
  Json r = {{"format", "tyndall-bench"}, {"version", 1},
            {"device", "llvmpipe"},      {"driver", "Mesa"},
            {"sweep", "quick"},          {"started", "2026-11-26T14:00:00Z"},
            {"copy_gb_s", 10.0},         {"settings", {{"medium.sigma_t", 0.03}, {"medium.g", 0.5}}},
            {"levels", Json::array()},   {"points", Json::array()}};
  r["levels"].push_back({{"name", "hall"},
                         {"camera", 0},
                         {"triangles", 100000},
                         {"lights", 1},
                         {"light_in_view", false},
                         {"truth_samples", 2048},
                         {"truth_self_nrmse", 0.004}});
  r["levels"].push_back({{"name", "vault"},
                         {"camera", 0},
                         {"triangles", 250000},
                         {"lights", 4},
                         {"light_in_view", true},
                         {"truth_samples", 1024},
                         {"truth_self_nrmse", nullptr}});
  Json& points = r["points"];
  for (const char* level : {"hall", "vault"}) {
    // error · time = constant for the march; the others fall faster and end.
    for (const double n : {16, 64, 256, 1024})
      points.push_back(full(level, "ray_march", "ray_march", n, 3 * n, 2.0 / n));
    for (const double n : {1, 2, 3, 6})
      points.push_back(full(level, "exact", "exact", n, 100 + 30 * n, 0.3 / (n * n * n)));
    for (const double n : {8, 16, 32, 64})
      points.push_back(full(level, "fourier", "fourier", n, 60 + 2 * n, 0.5 / std::sqrt(n)));
  }
  for (Json& p : points) p["plot"] = {"error_time", "knob"};
  const auto add = [&](Json p, const char* plot) {
    p["plot"] = {plot};
    p["key"] = std::string(plot) + "/" + p["key"].get<std::string>();
    points.push_back(std::move(p));
  };
  for (const auto& [w, h] : {std::pair{640, 360}, {1280, 720}, {2560, 1440}})
    add(full("hall", "exact", "exact", 3, 1e-4 * w * h, 0.01, w, h), "resolution");
  for (const double n : {256, 512, 1024}) add(full("hall", "exact", "exact", n, n / 8, 10 / n), "map");
  for (const char* level : {"hall", "vault"})
    add(full(level, "exact", "exact", 3, level[0] == 'h' ? 100 : 350, 0.01), "lights");
  for (const char* level : {"hall", "vault"}) add(full(level, "fourier", "fourier", 32, 120, 0.02), "triangles");
  Json motion = full("hall", "exact", "exact", 3, 190, 0.02);
  motion["temporal"] = {{"nrmse_mean", 0.021}, {"flicker", 0.0031}};
  add(motion, "motion");
  Json paper = full("hall", "fourier", "fourier", 16, 96, 0.1);
  paper["paper"] = {{"paper", "Klehm et al. 2014"},
                    {"table", "Table 1"},
                    {"row", "Sponza"},
                    {"figure_ms", 2.1},
                    {"figure_ratio", 0.25},
                    {"baseline_key", "hall/ray_march/64.000000/1280"}};
  add(paper, "papers");
  Json failed = full("vault", "min_max", "min_max", 1, 1, 1);
  for (const char* field : {"gpu_ms", "volumetrics_ms", "shadow_ms", "passes", "error", "memory_bytes", "floor_bytes"})
    failed[field] = nullptr;
  failed["failed"] = "min_max sees suns only";
  add(failed, "error_time");
  return r;
}

}  // namespace tyndall::bench::test
