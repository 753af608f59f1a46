// The table of all parameters with their values.
#include <algorithm>
#include <set>

#include "base/assert.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "message.hpp"
#include "params/params.hpp"

namespace tyndall::params {

std::optional<std::size_t> Table::indexOf(std::string_view id) const {
  const auto found = index_.find(id);
  if (found == index_.end()) return std::nullopt;
  return found->second;
}

Error Table::unknownId(std::string_view id) const {
  std::vector<std::string> ids;
  for (const Parameter& p : parameters_) ids.push_back(p.id);
  const std::string near = nearestName(id, ids);
  return badCall(quote(id) + ": there is no such parameter; " +
                 (near.empty() ? "'tyndall describe' lists them" : "the nearest name is " + quote(near)));
}

Result<void> Table::add(std::vector<Parameter> parameters) {
  std::set<std::string_view> fresh;
  for (const Parameter& p : parameters) {
    if (p.id.empty()) return failed("a parameter of " + quote(p.owner) + " has no id; every parameter needs one");
    if (const Parameter* other = find(p.id))
      return failed(p.id + ": is already a parameter of " + quote(other->owner) + "; " + quote(p.owner) +
                    " must use another id");
    if (!fresh.insert(p.id).second)
      return failed(p.id + ": appears twice in the table of " + quote(p.owner) + "; ids are unique");
  }
  for (Parameter& p : parameters) {
    double value = p.defaultValue;
    bool assigned = false;
    if (const auto kept = remembered_.find(p.id); kept != remembered_.end()) {
      if (auto read = fromText(p, kept->second.text)) {
        value = *read;
        assigned = kept->second.assigned;
      } else {
        log::warning("the former value of a parameter is replaced by its default: " + read.error().message);
      }
      remembered_.erase(kept);
    }
    index_.emplace(p.id, parameters_.size());
    parameters_.push_back(std::move(p));
    values_.push_back(value);
    assigned_.push_back(assigned);
  }
  return {};
}

void Table::remove(std::string_view owner) {
  std::vector<Parameter> parameters;
  std::vector<double> values;
  std::vector<bool> assigned;
  index_.clear();
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    Parameter& p = parameters_[i];
    if (p.owner == owner) {
      if (assigned_[i] || values_[i] != p.defaultValue) remembered_[p.id] = {toText(p, values_[i]), assigned_[i]};
      continue;
    }
    index_.emplace(p.id, parameters.size());
    parameters.push_back(std::move(p));
    values.push_back(values_[i]);
    assigned.push_back(assigned_[i]);
  }
  parameters_ = std::move(parameters);
  values_ = std::move(values);
  assigned_ = std::move(assigned);
}

const Parameter* Table::find(std::string_view id) const {
  const auto i = indexOf(id);
  return i ? &parameters_[*i] : nullptr;
}

double Table::value(std::string_view id) const {
  const auto i = indexOf(id);
  TY_ASSERT(i.has_value(), "no parameter " + std::string(id));
  return values_[*i];
}

bool Table::changed(std::string_view id) const {
  const auto i = indexOf(id);
  TY_ASSERT(i.has_value(), "no parameter " + std::string(id));
  return values_[*i] != parameters_[*i].defaultValue;
}

bool Table::isAssigned(std::string_view id) const {
  const auto i = indexOf(id);
  TY_ASSERT(i.has_value(), "no parameter " + std::string(id));
  return assigned_[*i];
}

void Table::reset(std::string_view id) {
  const auto i = indexOf(id);
  TY_ASSERT(i.has_value(), "no parameter " + std::string(id));
  values_[*i] = parameters_[*i].defaultValue;
  assigned_[*i] = false;
}

Result<void> Table::set(std::string_view id, double value) {
  const auto i = indexOf(id);
  if (!i) return unknownId(id);
  auto checked = check(parameters_[*i], value);
  if (!checked) return checked.error();
  values_[*i] = *checked;
  assigned_[*i] = true;
  return {};
}

Result<void> Table::setText(std::string_view id, std::string_view text) {
  const auto i = indexOf(id);
  if (!i) return unknownId(id);
  auto value = fromText(parameters_[*i], text);
  if (!value) return value.error();
  values_[*i] = *value;
  assigned_[*i] = true;
  return {};
}

Result<void> Table::setAssignment(std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos)
    return badCall(quote(assignment) + ": is no assignment; write it as id=value, for example view.exposure=2");
  return setText(assignment.substr(0, equals), assignment.substr(equals + 1));
}

void Table::resetToDefaults() {
  for (std::size_t i = 0; i < parameters_.size(); ++i) values_[i] = parameters_[i].defaultValue;
  std::fill(assigned_.begin(), assigned_.end(), false);
}

std::vector<std::string> Table::assigned() const {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    if (assigned_[i]) ids.push_back(parameters_[i].id);
  return ids;
}

}  // namespace tyndall::params
