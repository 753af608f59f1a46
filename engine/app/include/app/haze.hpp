// Air that hides the level: a level in other units, or a camera far away, is blank with a medium made for rooms.
#pragma once

#include <optional>
#include <string>

#include "app/session.hpp"

namespace tyndall::app {

struct Haze {
  double sigma_t;    ///< extinction (1/m) through which half of the light of the median surface comes
  std::string line;  ///< what is wrong and what would be right, for people
};

/// Of the newest measured frame (Session::metered()): nothing where surfaces are seen, where there are none, or where
/// the effect is off.
std::optional<Haze> hidingHaze(Session& session);

}  // namespace tyndall::app
