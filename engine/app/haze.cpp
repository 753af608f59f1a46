#include "app/haze.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace tyndall::app {
namespace {

// Less than this of the surfaces' light arrives: a surface of a display's full white is then darker than its darkest
// tenth, and the light that the air scatters is laid over it.
constexpr float kHidden = 0.05f;
// A picture that is nearly all sky hides nothing.
constexpr float kFewSurfaces = 0.002f;

std::string shortText(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

}  // namespace

std::optional<Haze> hidingHaze(Session& session) {
  const auto& metered = session.metered();
  const params::Parameter* extinction = session.table().find("medium.sigma_t");
  if (!metered || !extinction || metered->surfaces < kFewSurfaces || metered->transmittance > kHidden) return {};
  // Two digits, as the line says it: what is shown is what is set.
  const std::string text = shortText(
      std::clamp(std::numbers::ln2 / std::max(metered->distance, 1e-6f), extinction->min, extinction->max), 2);
  const double sigma_t = std::stod(text);
  if (sigma_t >= session.table().value(extinction->id)) return {};  // not the air's doing
  char line[256];
  std::snprintf(line, sizeof line,
                "the air hides the level: %.1f %% of the surfaces' light arrives, from %s m away; medium.sigma_t=%s "
                "would show it",
                100.0 * metered->transmittance, shortText(metered->distance, 3).c_str(), text.c_str());
  return Haze{sigma_t, line};
}

}  // namespace tyndall::app
