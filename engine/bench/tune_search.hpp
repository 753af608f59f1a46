// Searches the settings of a plugin's techniques by successive halving, on views whose ray-traced truth is known.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/bench_options.hpp"
#include "bench/halving.hpp"
#include "bench/stand.hpp"
#include "bench/sweep.hpp"
#include "bench/truths.hpp"

namespace tyndall::bench {

/// A camera of the level and how it is turned.
struct TunedView {
  std::uint32_t camera;
  Turn turn;
  bool lightOnScreen = false;
};

/// Settings that are tried, and what was measured of them in the present round.
struct Candidate {
  std::string technique;
  Assignments settings;
  std::vector<std::vector<double>> milliseconds;  ///< of each view that was measured
  std::vector<double> errors;                     ///< nRMSE of each view that was measured
  double known = 0;                               ///< ms that the round before measured
  bool dropped = false;                           ///< out of the round before its last view
  bool dear = false;                              ///< because another meets the bound in far less time
  std::string failure;

  std::string text() const;
  double worstError() const;
  /// The worst error and median time of the views that were measured.
  Score score() const;
  bool timed() const;  ///< who misses the error is not
  bool out() const { return dropped || !failure.empty(); }
};

/// How much a round of the search measures, and how many candidates go on.
struct Round {
  bool everyView;
  bool wholeErrors;  ///< errors at the field's size and with its truth, or with half of both
  int timed;         ///< frames
  double slack;
  std::size_t keep;  ///< at most, of those that go on; 0: the last round
  double hopeless;   ///< a view on which a candidate misses the bound by this factor is its last of the round
};

class TuneSearch {
 public:
  /// How the best did on a view that the search did not see.
  struct Held {
    TunedView view;
    Score score;
    bool kindSearched;  ///< whether a view of the search is like it in having a light on the screen, or none
  };

  TuneSearch(Stand& stand, const app::TuneOptions& options);

  /// The views to search on: `cameras`, each also turned as asked for. A camera that sees no light so gets one more
  /// view, turned to one, unless that is not wanted. Those with a light on the screen come first: they are the hardest,
  /// and who fails there need not be tried on the others.
  Result<void> chooseViews(const std::vector<std::uint32_t>& cameras);
  /// Searches one field of candidates. Afterwards best() is the best of all fields so far.
  Result<void> run(const Sweep& field);
  /// Measures the best on a camera that the search did not see.
  Result<void> holdOut(std::uint32_t camera);

  const std::vector<Held>& held() const { return held_; }
  bool met() const { return sought_.met(scoreOf(best())); }
  const Candidate& best() const { return candidates_.front(); }
  const Goal& goal() const { return goal_; }
  /// The best's settings as a preset (JSON), with what was measured as evidence.
  std::string preset();

 private:
  /// Of a bound on the error two things are asked: that the worst view keeps clear of it by the margin, and that a view
  /// which the search has not seen is to be under it.
  Score scoreOf(const Candidate& c) const;
  std::vector<Score> scores() const;
  std::string cameraOptions() const;
  void take(const std::vector<std::size_t>& order);
  Result<void> makeCandidates();
  Result<TunedView> viewOf(std::uint32_t camera, Turn turn);

  struct Prepared {
    scene::CameraView camera;
    Truth truth;
  };
  Result<void> measure(const Round& round);
  Result<std::vector<Prepared>> prepare(const Round& round, Size errorSize);
  /// The cheapest by what is known first: once one meets the bound everywhere, those that are dearer by far are not
  /// tried.
  void measureErrors(const Round& round, const std::vector<Prepared>& views, Size errorSize);
  /// Interleaved, so that a drift of the machine meets all alike.
  void measureTimes(const Round& round, const std::vector<Prepared>& views);

  Stand& stand_;
  const app::TuneOptions& options_;
  Sweep field_;
  std::vector<TunedView> views_;
  Goal goal_, sought_;  ///< as asked for, and with the margin
  std::vector<Candidate> candidates_;
  std::vector<std::size_t> counts_;
  std::size_t dear_ = 0;
  std::vector<Held> held_;
  std::vector<std::string> left_;
  std::set<std::string> notBuilt_, read_, varied_;
};

}  // namespace tyndall::bench
