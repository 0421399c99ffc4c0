#pragma once
#include <algorithm>
#include <cstdint>

namespace underact::device::remote {

/// Limits the rate of connections: a bucket of kMax tokens, refilled at kASecond. A whole class that looks for arms
/// stays within it; a program that keeps connecting empties it, and strangers are then refused until it is half full.
class ConnectionLimit {
 public:
  static constexpr double kMax = 100.0, kASecond = 50.0;

  /// That many have connected since the last call. now_ns: of a monotonic clock.
  void count(int connections, std::int64_t now_ns) noexcept {
    const double since_s = last_ns_ == 0 ? 0.0 : 1e-9 * static_cast<double>(now_ns - last_ns_);
    last_ns_ = now_ns;
    tokens_ = std::clamp(tokens_ + kASecond * since_s - connections, 0.0, kMax);
    are_too_many_ = are_too_many_ ? tokens_ < 0.5 * kMax : tokens_ <= 0.0;
  }
  bool areTooMany() const noexcept { return are_too_many_; }

 private:
  double tokens_ = kMax;
  std::int64_t last_ns_ = 0;
  bool are_too_many_ = false;
};

}  // namespace underact::device::remote
