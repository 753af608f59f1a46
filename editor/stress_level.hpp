// A level made up by chance, as small as a level can be.
#pragma once

#include <random>

#include "app/level.hpp"

namespace tyndall::editor {

/// A floor, one to four blocks (some alpha-blended, some animated), up to five lights of any kind, some with cookies.
app::Level stressLevel(std::mt19937_64& random);

}  // namespace tyndall::editor
