// What a search found, as a preset with its evidence.
#include <cstdio>

#include <nlohmann/json.hpp>

#include "bench/statistics.hpp"
#include "tune_search.hpp"

namespace tyndall::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

Json limitOf(const Candidate& c) {
  const auto limit = predictionLimit(c.errors);
  return limit ? Json(*limit) : Json();
}

Json settingsOf(const Candidate& c, const params::Table& table) {
  Json settings = Json::object();
  for (const auto& [id, value] : c.settings) {
    switch (table.find(id)->type) {
      case params::Type::kEnum: settings[id] = value; break;
      case params::Type::kBool: settings[id] = table.value(id) != 0; break;
      case params::Type::kInt: settings[id] = static_cast<std::int64_t>(table.value(id)); break;
      default: settings[id] = table.value(id);
    }
  }
  return settings;
}

}  // namespace

std::string TuneSearch::cameraOptions() const {
  std::string text;
  for (const std::uint32_t camera : options_.cameras) text += " --camera " + std::to_string(camera);
  if (options_.turned > 0) text += " --turned " + std::to_string(options_.turned);
  if (!options_.lightViews) text += " --no-light-views";
  for (const std::uint32_t camera : options_.holdOut) text += " --hold-out " + std::to_string(camera);
  return text;
}

std::string TuneSearch::preset() {
  params::Table& table = stand_.session().table();
  (void)applySettings(table, best().settings);
  Json preset, evidence;
  preset["settings"] = settingsOf(best(), table);

  const std::string bound =
      goal_.maxError ? " --max-error " + number(*goal_.maxError) : " --budget-ms " + number(*goal_.budgetMs);
  const std::string candidates = options_.candidates.empty() ? "" : " --candidates " + options_.candidates.string();
  const gpu::DeviceInfo& device = stand_.session().device().info();
  evidence["command"] = "tyndall tune " + options_.level + bound + cameraOptions() + candidates + " --margin " +
                        number(options_.margin) + " --size " + std::to_string(options_.size.first) + "x" +
                        std::to_string(options_.size.second);
  evidence["device"] = device.name;
  evidence["driver"] = device.driver;
  evidence["bound"] = goal_.maxError ? Json{{"max_nrmse", *goal_.maxError}} : Json{{"budget_ms", *goal_.budgetMs}};
  evidence["margin"] = options_.margin;
  evidence["times"] = "of the plugin's passes, without the engine's shadow maps; the worst view's median";
  evidence["milliseconds"] = best().score().milliseconds;
  evidence["nrmse"] = best().worstError();
  evidence["nrmse_of_unseen_views"] = limitOf(best());
  evidence["unseen_views"] =
      "19 of 20 are to stay under this, by the spread of the views that were searched; null: too few of them";
  evidence["views"] = Json::array();
  for (std::size_t v = 0; v < views_.size(); ++v)
    evidence["views"].push_back({{"level", options_.level},
                                 {"camera", views_[v].camera},
                                 {"turned_degrees", views_[v].turn.yaw},
                                 {"raised_degrees", views_[v].turn.pitch},
                                 {"light_on_screen", views_[v].lightOnScreen},
                                 {"milliseconds", spreadOf(best().milliseconds[v]).median},
                                 {"nrmse", best().errors[v]}});
  evidence["hold_out"] = Json::array();
  for (const auto& [view, score, kindSearched] : held_)
    evidence["hold_out"].push_back({{"level", options_.level},
                                    {"camera", view.camera},
                                    {"light_on_screen", view.lightOnScreen},
                                    {"milliseconds", score.milliseconds},
                                    {"nrmse", score.error},
                                    {"met", goal_.met(score)}});
  evidence["errors"] =
      "nRMSE against the ray-traced truth; pixels where rasteriser and ray tracer end on different surfaces count as "
      "right";
  evidence["error_size"] = {field_.errorSize.first, field_.errorSize.second};
  evidence["candidates_by_round"] = counts_;
  evidence["candidates_too_dear"] = dear_;
  evidence["others_of_the_last_round"] = Json::array();
  for (std::size_t i = 1; i < candidates_.size(); ++i) {
    const Candidate& c = candidates_[i];
    evidence["others_of_the_last_round"].push_back({{"settings", c.text()},
                                                    {"milliseconds", c.timed() ? Json(c.score().milliseconds) : Json()},
                                                    {"nrmse", c.worstError()},
                                                    {"nrmse_of_unseen_views", limitOf(c)},
                                                    {"views", c.errors.size()}});
  }
  Json varied = Json::array(), left = left_;
  for (const std::string& id : varied_) varied.push_back(id);
  for (const std::string& text : notBuilt_) left.push_back(text);
  table.resetToDefaults();
  for (const std::string& id : read_)
    if (!varied_.contains(id) && !id.starts_with("medium.") && table.find(id))
      left.push_back(id + ": kept at " + params::toText(*table.find(id), table.value(id)));
  evidence["varied"] = varied;
  evidence["left_out"] = left;
  preset["evidence"] = evidence;
  return preset.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tyndall::bench
