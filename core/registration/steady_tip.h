#pragma once
#include <cstdint>
#include <optional>

#include "core/base/types.h"

namespace underact::registration {

inline constexpr double kHeld_s = 0.5;  // how long a tip is held: at least four periods of tremor (8 to 12 Hz)

/// The result of holding the tip for kHeld_s.
struct HeldTip {
  Vec3 p_WT = Vec3::Zero();  // mean of the samples
  double spread_m = 0.0;     // about the mean, root mean square
  double drift_m = 0.0;      // from the mean of the first half to that of the second
  int samples = 0;
  bool moved = false;  // it did not rest: press again
};

/// Collects the samples of a tip that is held. Copyable; the caller owns it.
class SteadyTip {
 public:
  /// A sample. time_ns: of the arm; where it does not increase by about a period, or the position is not finite,
  /// collecting begins anew. Gives the result once enough time has been collected, and then waits for begin().
  std::optional<HeldTip> add(std::int64_t time_ns, const Vec3& p_WT);
  /// Begins to collect with the next sample; what was collected is dropped.
  void begin() { *this = SteadyTip(true); }
  /// Stops collecting; what was collected is dropped.
  void end() { *this = SteadyTip(); }
  bool isRunning() const { return running_; }
  double share() const;  // of the time

  SteadyTip() = default;

 private:
  explicit SteadyTip(bool at_work) : running_(at_work) {}
  HeldTip result() const;

  /// Sums relative to the first sample, to avoid cancellation.
  struct Sums {
    Vec3 p = Vec3::Zero();
    double squares = 0.0;
    int count = 0;
  };
  Sums first_, second_;  // halves
  Vec3 p_WOrigin_ = Vec3::Zero();
  std::int64_t began_ns_ = 0, last_ns_ = 0;
  bool running_ = false, has_one_ = false;
};

}  // namespace underact::registration
