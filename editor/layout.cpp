#include "layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tyndall::editor {
namespace {

constexpr std::array kTextScales{0.75f, 1.0f, 1.25f, 1.5f, 1.75f, 2.0f, 2.5f, 3.0f};

}  // namespace

float Layout::sizeOf(float kept, float automatic, float least, float most) {
  return std::floor(std::max(std::min(kept > 0 ? std::max(kept, least) : automatic, most), 1.0f));
}

float Layout::largerText(float scale) {
  const auto next = std::find_if(kTextScales.begin(), kTextScales.end(), [&](float s) { return s > scale + 0.01f; });
  return next == kTextScales.end() ? kTextScales.back() : *next;
}

float Layout::smallerText(float scale) {
  const auto next = std::find_if(kTextScales.rbegin(), kTextScales.rend(), [&](float s) { return s < scale - 0.01f; });
  return next == kTextScales.rend() ? kTextScales.front() : *next;
}

bool isSound(const Layout& layout) {
  const auto size = [](float points) { return std::isfinite(points) && points >= 0; };
  const bool text =
      layout.textScale == 0 || (layout.textScale >= kTextScales.front() && layout.textScale <= kTextScales.back());
  return size(layout.side) && size(layout.figures) && size(layout.fields) && text;
}

}  // namespace tyndall::editor
