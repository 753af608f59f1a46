#include "distributions.hpp"

#include <algorithm>

namespace tyndall::stability {
namespace {

float clamped(double z) { return static_cast<float>(std::clamp(z, -1.0, 1.0)); }

/// Depths around `centre`, Cauchy-distributed: most near it, some anywhere.
float heavyTailed(Random& random, double centre, double width) {
  return clamped(centre + width * std::tan(3.14159265 * (random.next() - 0.5)));
}

std::vector<float> depthsOf(Random& random, Kind kind) {
  std::vector<float> z;
  const auto fill = [&](int count, auto&& make) {
    for (int i = 0; i < count; ++i) z.push_back(make());
  };
  const auto anywhere = [&] { return clamped(random.between(-1, 1)); };
  const double centre = random.between(-1, 1);
  switch (kind) {
    case Kind::kFew: fill(1 + random.below(16), anywhere); break;
    case Kind::kSingle: fill(1, [&] { return clamped(random.between(-1.05, 1.05)); }); break;
    case Kind::kNearlyEqual: {
      const double gap = random.decades(1e-7, 1e-1);
      fill(2 + random.below(5), [&] { return clamped(centre + gap * random.between(-1, 1)); });
      break;
    }
    case Kind::kEnds: fill(2, [&] { return random.next() < 0.5 ? -1.0f : 1.0f; }); break;
    case Kind::kClamped: fill(2 + random.below(15), [&] { return clamped(random.between(-3, 3)); }); break;
    case Kind::kNearSingular: fill(1 + random.below(6), anywhere); break;
    case Kind::kClusters: {
      const double width = random.decades(1e-6, 1e-2);
      for (int clump = 2 + random.below(3); clump > 0; --clump) {
        const double middle = random.between(-1, 1);
        fill(1 + random.below(4), [&] { return clamped(middle + width * random.between(-1, 1)); });
      }
      break;
    }
    default: {
      const double width = random.decades(1e-3, 0.3);
      fill(static_cast<int>(random.decades(32, 512)), [&] { return heavyTailed(random, centre, width); });
    }
  }
  return z;
}

}  // namespace

Blockers makeBlockers(Random& random, Kind kind) {
  Blockers made;
  made.z = depthsOf(random, kind);
  const bool uneven = random.next() < 0.3;
  const double crumb = random.decades(1e-8, 1e-2);
  double total = 0;
  for (std::size_t i = 0; i < made.z.size(); ++i) {
    double share = uneven ? std::pow(random.next(), 8) + 1e-12 : random.next() + 1e-3;
    if (kind == Kind::kNearSingular && i >= 3) share *= crumb;
    made.share.push_back(share);
    total += share;
  }
  for (double& share : made.share) share /= total;
  return made;
}

float rayDepth(Random& random, const std::vector<float>& z) {
  const auto one = [&] { return z[static_cast<std::size_t>(random.below(static_cast<int>(z.size())))]; };
  const double pick = random.next();
  if (pick < 0.25) return one();
  if (pick < 0.45) return clamped(one() + (random.next() < 0.5 ? -1 : 1) * random.decades(1e-8, 1e-4));
  if (pick < 0.65) return 0.5f * (one() + one());
  if (pick < 0.85) return clamped(random.between(-1, 1));
  if (pick < 0.92) return random.next() < 0.5 ? -1.0f : 1.0f;
  const auto [low, high] = std::minmax_element(z.begin(), z.end());
  return random.next() < 0.5 ? clamped(*low - random.decades(1e-7, 1)) : clamped(*high + random.decades(1e-7, 1));
}

Truth visibilityAt(const Blockers& blockers, float zf) {
  Truth truth;
  for (std::size_t i = 0; i < blockers.z.size(); ++i) {
    truth.high += blockers.z[i] >= zf ? blockers.share[i] : 0;
    truth.low += blockers.z[i] > zf ? blockers.share[i] : 0;
  }
  return truth;
}

std::array<double, 7> momentsOf(const Blockers& blockers) {
  std::array<double, 7> b{};
  for (std::size_t i = 0; i < blockers.z.size(); ++i) {
    double power = blockers.share[i];
    for (double& moment : b) {
      moment += power;
      power *= static_cast<double>(blockers.z[i]);
    }
  }
  return b;
}

}  // namespace tyndall::stability
