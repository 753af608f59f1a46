#include "tuner.hpp"

#include <algorithm>
#include <bit>

namespace tyndall::host {
namespace {

double medianWithoutWarmUp(std::vector<double> times) {
  times.erase(times.begin());
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

}  // namespace

Tuner::Choice Tuner::current(const std::string& key, const std::vector<double>& variants) {
  Entry& entry = entries_[key];
  if (entry.variants == variants) return entry.choice;
  entry = {variants, std::vector<std::vector<double>>(variants.size()), {}, {}};
  if (variants.size() == 1) entry.choice.settled = true;
  if (const double* known = store_.find(key)) {
    const auto at = std::find(variants.begin(), variants.end(), *known);
    if (at != variants.end()) entry.choice = {static_cast<std::size_t>(at - variants.begin()), true};
  }
  return entry.choice;
}

void Tuner::add(const std::string& key, std::size_t variant, double milliseconds,
                const std::set<std::uint32_t>& lights) {
  const auto found = entries_.find(key);
  if (found == entries_.end()) return;
  Entry& entry = found->second;
  if (entry.choice.settled || variant != entry.choice.variant) return;
  if (lights != entry.lights) {
    const bool begun = !entry.times.front().empty();
    entry.lights = lights;
    if (begun) {
      entry.times.assign(entry.variants.size(), {});
      entry.choice.variant = 0;
      return;
    }
  }
  entry.times[variant].push_back(milliseconds);
  // Two frames after the warm-up tell of a variant that is out of the question; a single one may have stuttered.
  const std::vector<double>& own = entry.times[variant];
  const auto beats = [&](const std::vector<double>& times) {
    return medianWithoutWarmUp(times) * kClearly < *std::min_element(own.begin() + 1, own.end());
  };
  const bool beaten = own.size() > 2 && std::any_of(entry.times.begin(),
                                                    entry.times.begin() + static_cast<std::ptrdiff_t>(variant), beats);
  if (entry.times[variant].size() < kFrames && !beaten) return;
  if (++entry.choice.variant < entry.variants.size()) return;
  std::size_t best = 0;
  for (std::size_t i = 1; i < entry.times.size(); ++i)
    if (medianWithoutWarmUp(entry.times[i]) < medianWithoutWarmUp(entry.times[best])) best = i;
  entry.choice = {best, true};
  store_.remember(key, entry.variants[best]);
}

std::string tunableKey(const std::string& plugin, const std::string& device, const std::string& parameter,
                       const LayoutTunable& tunable, const Layout& layout) {
  std::string key = plugin + '|' + device + '|' + parameter + '|';
  for (const LayoutPass& pass : layout.passes) {
    if (std::find(tunable.passes.begin(), tunable.passes.end(), pass.name) == tunable.passes.end()) continue;
    key += pass.name + '/' + pass.shader;
    for (const std::uint32_t groups : pass.d.groups) key += ':' + std::to_string(std::bit_width(groups));
    for (const TySpecialization& s : pass.specializations)
      key += ',' + std::to_string(s.id) + '=' + std::to_string(s.value);
    for (const TyBinding& b : pass.bindings) {
      if (b.source != TY_SOURCE_IMAGE) continue;
      const TyImage& image = layout.images[b.index].d;
      key += ',' + std::to_string(image.format);
      for (const std::uint32_t side : {image.width, image.height, image.depth})
        key += 'x' + std::to_string(std::bit_width(side));
    }
    key += ' ';
  }
  return key;
}

}  // namespace tyndall::host
