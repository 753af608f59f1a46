// Errors of window system and memory on demand (--stress): functions of Vulkan are replaced by ones that fail when told
// to.
#pragma once

#include <cstdint>

namespace tyndall::editor {

enum class Fault {
  kNone,
  kOutOfDate,      ///< no image can be acquired
  kSuboptimal,     ///< one can
  kSurfaceLost,    ///< found when an image is acquired or the surface looked at
  kOutOfDateLate,  ///< found when the image is presented
  kSurfaceLostLate,
  kNoArea,  ///< the surface has a size of 0 by 0 when it is looked at, as that of a minimised window
  kNoMemory,
};

/// While one lives, faults can be ordered. One at a time in a program; from one thread.
class Faults {
 public:
  Faults();
  ~Faults();
  Faults(const Faults&) = delete;
  Faults& operator=(const Faults&) = delete;

  /// The next call that can give this error gives it, `times` times. kNoMemory: the next requests for device memory.
  void order(Fault fault, std::uint32_t times = 1);
  /// What was ordered and did not happen, will not.
  void withdraw();
  std::uint32_t happened() const;
};

}  // namespace tyndall::editor
