#pragma once
#include <cstdint>
#include <optional>

#include "core/base/types.h"

namespace underact::registration {

inline constexpr double kHeld_s = 0.5;  // how long a tip is held: tremor (8 to 12 Hz) goes by four times at least

/// A tip that was held for so long.
struct Held {
  Vec3 p_WT = Vec3::Zero();  // mean of the samples
  double spread_m = 0.0;     // about it, root of the mean square
  double drift_m = 0.0;      // from the mean of the first half to that of the second
  int samples = 0;
  bool moved = false;  // it did not rest: press again
};

/// Collects the samples of a tip that is held. Copyable; the caller owns it.
class Still {
 public:
  /// A sample. time_ns: of the arm; where it does not go on by a period, or the place is not finite, it begins anew.
  /// The result, once so much time has been collected; then it waits for begin().
  std::optional<Held> add(std::int64_t time_ns, const Vec3& p_WT);
  /// Begins to collect with the next sample; what was collected is dropped.
  void begin() { *this = Still(true); }
  /// Stops collecting; what was collected is dropped.
  void end() { *this = Still(); }
  bool isAtWork() const { return at_work_; }
  double share() const;  // of the time

  Still() = default;

 private:
  explicit Still(bool at_work) : at_work_(at_work) {}
  Held result() const;

  /// Sums about the first sample, so that nothing is lost in rounding.
  struct Sums {
    Vec3 p = Vec3::Zero();
    double squares = 0.0;
    int count = 0;
  };
  Sums first_, second_;  // halves
  Vec3 p_WOrigin_ = Vec3::Zero();
  std::int64_t began_ns_ = 0, last_ns_ = 0;
  bool at_work_ = false, has_one_ = false;
};

}  // namespace underact::registration
