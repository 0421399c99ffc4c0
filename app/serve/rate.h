#pragma once
#include <algorithm>

namespace underact::serve {

inline constexpr double kMaxRequestsPerSecond = 2000.0;  // of a client, and as many at once
inline constexpr double kMaxBytesPerSecond = 4U << 20U;  // the same; twice as many at once: frames of 1 MiB
inline constexpr double kMaxBytesAtOnce = 8U << 20U;

/// What may be used of something: so much a second in the long run, and so much at once. Times: of any clock that is
/// not set.
class Bucket {
 public:
  Bucket(double per_second, double at_once) : per_second_(per_second), at_once_(at_once), left_(at_once) {}
  /// Whether so much is there now.
  bool has(double amount, double now_s) {
    left_ = std::min(at_once_, left_ + per_second_ * std::max(0.0, now_s - filled_s_));
    filled_s_ = now_s;
    return left_ >= amount;
  }
  /// Who takes more than is there has to wait, but never for more than is refilled in a second.
  void take(double amount) { left_ = std::max(-per_second_, left_ - amount); }
  /// How long until something is there, s.
  double wait_s() const { return std::max(0.0, -left_ / per_second_); }

 private:
  double per_second_, at_once_, left_, filled_s_ = 0.0;
};

}  // namespace underact::serve
