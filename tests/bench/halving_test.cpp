// Successive halving against a search of everything, on made-up tables.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "bench/halving.hpp"

namespace tyndall::bench {
namespace {

TEST(Halving, RankingPutsThoseThatMeetTheBoundFirst) {
  const std::vector<Score> scores = {{10, 0.01}, {2, 0.2}, {5, 0.04}, {7, 0.05}, {1, 0.06}};
  const Goal error{0.05, {}};
  EXPECT_EQ(ranking(scores, error, 1), (std::vector<std::size_t>{2, 3, 0, 4, 1}));
  EXPECT_EQ(ranking(scores, error, 1.3), (std::vector<std::size_t>{4, 2, 3, 0, 1}));
  const Goal budget{{}, 6.0};
  EXPECT_EQ(ranking(scores, budget, 1), (std::vector<std::size_t>{2, 4, 1, 3, 0}));
}

TEST(Halving, SurvivorsHoldTheFrontNearTheBound) {
  // The cheap measurement says that 1 and 2 fail the bound; on the front near it they go on all the same.
  const std::vector<Score> scores = {{10, 0.01}, {4, 0.07}, {3, 0.09}, {5, 0.2}, {2, 0.5}};
  const auto kept = survivors(scores, {0.05, {}}, 1, 1);
  EXPECT_EQ(kept, (std::vector<std::size_t>{0, 1, 2}));
}

// Costs and errors of random candidates; cheap rounds see them with noise, the last one as they are.
TEST(Halving, FindsWhatASearchOfEverythingFinds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal(0, 1);
  int same = 0, met = 0;
  constexpr int kTables = 200;
  for (int table = 0; table < kTables; ++table) {
    std::vector<Score> truth;
    for (int i = 0; i < 80; ++i) {
      const double ms = std::exp(4 * uniform(random));
      truth.push_back({ms, 0.5 / ms * std::exp(uniform(random) * 2)});
    }
    const Goal goal = table % 2 == 0 ? Goal{0.05, {}} : Goal{{}, 12.0};
    const std::size_t best = ranking(truth, goal, 1).front();
    std::vector<std::size_t> alive(truth.size());
    for (std::size_t i = 0; i < alive.size(); ++i) alive[i] = i;
    for (const auto& [noise, slack, keep] : {std::tuple{0.12, 1.3, std::size_t{16}}, {0.05, 1.15, std::size_t{5}}}) {
      std::vector<Score> seen;
      for (const std::size_t i : alive)
        seen.push_back({truth[i].milliseconds * std::exp(noise * normal(random)),
                        truth[i].error * std::exp(noise * normal(random))});
      std::vector<std::size_t> next;
      for (const std::size_t i : survivors(seen, goal, slack, keep)) next.push_back(alive[i]);
      alive = next;
    }
    EXPECT_LE(alive.size(), 12u);
    std::vector<Score> last;
    for (const std::size_t i : alive) last.push_back(truth[i]);
    const std::size_t found = alive[ranking(last, goal, 1).front()];
    if (found == best) ++same;
    if (goal.met(truth[found]) || !goal.met(truth[best])) ++met;
  }
  // Noise may cost the best one its place now and then.
  EXPECT_GE(met, kTables * 98 / 100);
  EXPECT_GE(same, kTables * 9 / 10);
}

}  // namespace
}  // namespace tyndall::bench
