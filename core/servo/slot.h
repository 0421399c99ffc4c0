#pragma once
#include <array>
#include <atomic>
#include <cstdint>

#include "core/base/real_time.h"

namespace underact::servo {

/// The latest value of one writer for one reader: three copies, so that neither ever waits. Values are passed on by
/// assignment (Eigen types are not trivially copyable).
template <class T>
class Slot {
 public:
  /// Writer: the copy to fill in; it holds some older value.
  T& back() noexcept UNDERACT_REAL_TIME { return copies_[back_]; }
  /// Writer: publishes the back copy.
  void publish() noexcept UNDERACT_REAL_TIME {
    back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kIndex;
  }
  /// Reader: the newest published value; unchanged until the next call.
  const T& latest() noexcept UNDERACT_REAL_TIME {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) != 0U) {
      front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    }
    return copies_[front_];
  }

 private:
  static constexpr std::uint32_t kIndex = 3, kFresh = 4;
  std::array<T, 3> copies_{};
  std::uint32_t back_ = 0;
  std::uint32_t front_ = 1;
  std::atomic<std::uint32_t> middle_{2};
};

}  // namespace underact::servo
