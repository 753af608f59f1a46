#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "convex.hpp"

namespace tyndall::render {
namespace {

TEST(ConvexHull, DropsInnerAndCollinearPointsAndTurnsLeft) {
  const Polygon hull = convexHull({{0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {1, 1}, {0, 0}});
  EXPECT_EQ(hull.size(), 4u);
  EXPECT_DOUBLE_EQ(area(hull), 4.0);
}

TEST(ConvexHull, OfALineHasNoArea) {
  EXPECT_LT(convexHull({{0, 0}, {1, 1}, {2, 2}}).size(), 3u);
  EXPECT_EQ(convexHull({{3, 4}, {3, 4}}).size(), 1u);
}

TEST(Intersect, TwoSquaresShareTheirOverlap) {
  const Polygon a{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, b{{1, 1}, {3, 1}, {3, 3}, {1, 3}}, far{{9, 9}, {10, 9}, {10, 10}};
  EXPECT_NEAR(area(intersect(a, b)), 1, 1e-12);
  EXPECT_NEAR(area(intersect(b, a)), 1, 1e-12);
  EXPECT_TRUE(intersect(a, far).empty());
}

TEST(Intersect, AgreesWithCountingPoints) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(0, 1);
  const auto inside = [](const Polygon& p, glm::dvec2 q) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const glm::dvec2 e = p[(i + 1) % p.size()] - p[i], d = q - p[i];
      if (e.x * d.y - e.y * d.x < 0) return false;
    }
    return !p.empty();
  };
  for (int n = 0; n < 30; ++n) {
    std::vector<glm::dvec2> a, b;
    for (int i = 0; i < 7; ++i) a.emplace_back(u(random), u(random)), b.emplace_back(u(random), u(random));
    const Polygon p = convexHull(a), q = convexHull(b), both = intersect(p, q);
    int hits = 0;
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i) {
      const glm::dvec2 x(u(random), u(random));
      hits += inside(p, x) && inside(q, x);
    }
    EXPECT_NEAR(area(both), static_cast<double>(hits) / kCount, 0.02);
  }
}

TEST(SmallestRectangle, FindsTheTurnOfARotatedSquare) {
  for (double angle = 0; angle < 1.6; angle += 0.1) {
    const glm::dvec2 x(std::cos(angle), std::sin(angle)), y(-x.y, x.x);
    const Polygon square = convexHull({x * 0.0, x * 3.0, x * 3.0 + y, y});
    const Rectangle r = smallestRectangle(square);
    EXPECT_NEAR(4 * r.half.x * r.half.y, 3.0, 1e-9);
    EXPECT_NEAR(glm::length(r.center - (x * 1.5 + y * 0.5)), 0, 1e-9);
  }
}

}  // namespace
}  // namespace tyndall::render
