// Presets as JSON. Read event by event instead of into a tree: repeated keys are seen, and a file of a million opening
// brackets costs nothing.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

#include "message.hpp"
#include "params/params.hpp"

namespace tyndall::params {
namespace {

using Json = nlohmann::json;

struct Entry {
  std::string id;
  enum class Kind { kBool, kNumber, kText } kind = Kind::kText;
  double number = 0;
  std::string text;
};

/// Collects the entries of a preset; false stops the parser, `error` then says why.
class Reader : public nlohmann::json_sax<Json> {
 public:
  Reader(std::string_view json, std::string_view source) : json_(json), source_(source) {}
  std::vector<Entry> entries;
  std::optional<Error> error;

  bool null() override { return skipped_ > 0 || wrongValue("null"); }
  bool boolean(bool value) override { return entry({key_, Entry::Kind::kBool, value ? 1.0 : 0.0, ""}); }
  bool number_integer(number_integer_t value) override { return numberEntry(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return numberEntry(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return numberEntry(value); }
  bool string(string_t& value) override { return entry({key_, Entry::Kind::kText, 0, value}); }
  bool binary(binary_t&) override { return wrongValue("binary data"); }
  bool start_array(std::size_t) override {
    if (skipped_ == 0) return wrongValue("a list");
    ++skipped_;
    return true;
  }
  bool end_array() override { return endSkipped(); }

  bool start_object(std::size_t) override {
    if (skipped_ > 0 || (depth_ == 1 && key_ == "evidence")) {
      ++skipped_;
      return true;
    }
    if (depth_ == 0 || (depth_ == 1 && key_ == "settings")) {
      ++depth_;
      key_.clear();
      return true;
    }
    return wrongValue("an object");
  }
  bool end_object() override {
    if (skipped_ > 0) return endSkipped();
    --depth_;
    key_.clear();
    return true;
  }
  bool key(string_t& value) override {
    if (skipped_ > 0) return true;
    key_ = value;
    if (key_ == "settings" && depth_ == 1) return seenSettings_ ? repeated() : (seenSettings_ = true);
    return seen_.insert(key_).second || repeated();
  }
  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception&) override {
    const auto before = json_.substr(0, std::min(position, json_.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    error = failed(std::string(source_) + ": is not valid JSON, line " + std::to_string(line) + " near " +
                   quote(token) + "; a preset looks like {\"view.exposure\": 2}");
    return false;
  }

 private:
  bool endSkipped() {
    if (--skipped_ == 0) key_.clear();
    return true;
  }
  bool repeated() {
    error = badCall(std::string(source_) + ": " + quote(key_) + " is given twice; give it once");
    return false;
  }
  bool wrongValue(const char* what) {
    error =
        depth_ == 0
            ? failed(std::string(source_) + ": holds " + what + "; a preset is an object like {\"view.exposure\": 2}")
            : badCall(std::string(source_) + ": " + quote(key_) + " is " + what +
                      "; values are numbers, true, false or strings");
    return false;
  }
  bool entry(Entry e) {
    if (skipped_ > 0) return true;
    if (depth_ == 0) return wrongValue("a single value");
    if (depth_ == 1 && key_ == "settings") return wrongValue("a single value instead of an object");
    entries.push_back(std::move(e));
    return true;
  }
  bool numberEntry(double value) { return entry({key_, Entry::Kind::kNumber, value, ""}); }

  std::string_view json_, source_;
  std::string key_;
  std::set<std::string> seen_;
  bool seenSettings_ = false;
  int depth_ = 0;
  int skipped_ = 0;  ///< brackets open inside "evidence"
};

Result<double> valueOf(const Parameter& p, const Entry& e) {
  switch (e.kind) {
    case Entry::Kind::kText: return fromText(p, e.text);
    case Entry::Kind::kBool:
      if (p.type != Type::kBool) return fromText(p, e.number != 0 ? "true" : "false");
      return check(p, e.number);
    case Entry::Kind::kNumber: break;
  }
  if (p.type == Type::kInt || p.type == Type::kFloat) return check(p, e.number);
  // A choice that looks like a number ("64") may be written as one; anything else is refused with its own text.
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, e.number);
  return fromText(p, std::string_view(text, static_cast<std::size_t>(end.ptr - text)));
}

}  // namespace

Result<void> Table::readPreset(std::string_view json, std::string_view source) {
  Reader reader(json, source);
  const bool parsed = Json::sax_parse(json.begin(), json.end(), &reader);
  if (reader.error) return *reader.error;
  if (!parsed) return failed(std::string(source) + ": is not valid JSON; a preset looks like {\"view.exposure\": 2}");

  std::vector<std::pair<std::size_t, double>> changes;
  for (const Entry& e : reader.entries) {
    const auto i = indexOf(e.id);
    if (!i) return badCall(std::string(source) + ": " + unknownId(e.id).message);
    auto value = valueOf(parameters_[*i], e);
    if (!value) return badCall(std::string(source) + ": " + value.error().message);
    changes.emplace_back(*i, *value);
  }
  for (const auto& [i, value] : changes) {
    values_[i] = value;
    assigned_[i] = true;
  }
  return {};
}

std::string Table::writePreset(bool changedOnly) const {
  nlohmann::ordered_json settings = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const Parameter& p = parameters_[i];
    if (changedOnly && values_[i] == p.defaultValue) continue;
    if (p.type == Type::kBool)
      settings[p.id] = values_[i] != 0;
    else if (p.type == Type::kEnum)
      settings[p.id] = toText(p, values_[i]);
    else if (p.type == Type::kInt)
      settings[p.id] = static_cast<long long>(values_[i]);
    else
      settings[p.id] = values_[i];
  }
  nlohmann::ordered_json root;
  root["settings"] = std::move(settings);
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tyndall::params
