#pragma once
#include <cstdint>
#include <vector>

namespace underact::gui {

/// How late the ticks of the last 10 s started.
class Lateness {
 public:
  explicit Lateness(int rate_hz);
  void add(std::int64_t lateness_ns);
  /// The share (0.99) of the ticks started no later than this; 0 where there are none. Cost: linear, so not each frame.
  double percentile_us(double share) const;

 private:
  std::vector<std::int64_t> ring_;
  std::size_t next_ = 0;
  bool full_ = false;
};

}  // namespace underact::gui
