// Random use of the editor instead of a user's (--stress): what can be changed is changed, in any order, and whatever
// breaks is counted.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "app/session.hpp"
#include "faults.hpp"
#include "window.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

class Stress {
 public:
  Stress(std::uint32_t steps, std::uint32_t seed);

  struct Stage {
    app::Session& session;
    Workspace& workspace;
    Window& window;
    std::uint32_t pictures = 0;  ///< rendered so far
  };
  /// Before each turn of the editor's loop. False: the steps are done.
  Result<bool> act(const Stage& stage);
  /// The report, on stdout; an error when something was wrong.
  Result<void> report(const Stage& stage);

 private:
  struct Memory {
    /// Bytes: of the process; of its heaps, what is held; of images and buffers.
    std::uint64_t resident = 0, allocated = 0, device = 0;
  };
  Result<void> something(const Stage& stage);
  void changeParameter(const Stage& stage);
  void resize(const Stage& stage);
  Result<void> changeLevel(const Stage& stage);
  void changeView(const Stage& stage);
  void editLevel(const Stage& stage);
  void orderFault(const Stage& stage);
  /// Defaults with small maps, the first level, the first size: where memory is compared.
  Result<void> goHome(const Stage& stage);
  void keepCheap(params::Table& table, const std::string& changed);
  void listen(const Stage& stage);
  void note(const std::string& what) { ++done_[what]; }
  std::uint32_t below(std::uint32_t count) {
    return std::uniform_int_distribution<std::uint32_t>(0, count - 1)(random_);
  }
  double unit() { return std::uniform_real_distribution<double>(0, 1)(random_); }

  enum class Mode { kRoaming, kGoingHome };
  std::uint32_t steps_, step_ = 0, quiet_ = 0;
  std::uint32_t pause_ = 0;  ///< frames to draw before the next step
  bool faulty_ = false;      ///< a fault was ordered in this step: errors are to be expected
  Mode mode_ = Mode::kGoingHome;
  std::vector<std::string> levels_;  ///< names; "" is one made up by chance
  std::mt19937_64 random_;
  Faults faults_;
  std::map<std::string, std::uint32_t> done_;      ///< steps by kind
  std::map<std::string, std::uint32_t> refusals_;  ///< errors told, by text
  std::vector<std::string> unexpected_;            ///< errors that nothing explains
  std::vector<Memory> atHome_;
  std::string lastMessage_;
  double longestMs_ = 0;
  std::string longestAfter_, lastAction_;
  std::uint32_t lastPictures_ = 0;
  std::chrono::steady_clock::time_point lastTurn_{};
};

}  // namespace tyndall::editor
