#pragma once
#include <cstddef>
#include <vector>

#include "core/servo/late.h"
#include "core/servo/snapshot.h"

namespace underact::servo {

inline constexpr std::size_t kHistories = 4;  // one is written, three may wait to be fetched

/// The last second of ticks, in a ring that is allocated once.
class History {
 public:
  History() = default;
  /// ticks: its room, above 0. Allocates.
  explicit History(std::size_t ticks) : ring_(ticks) {}
  /// The newest tick; it takes the place of the oldest where the ring is full. Not for a history without room.
  void add(const TickRecord& record) noexcept UNDERACT_REAL_TIME {
    ring_[next_] = record;
    next_ = next_ + 1 < ring_.size() ? next_ + 1 : 0;
    full_ = full_ || next_ == 0;
  }
  /// Closes the history: why it ended, and what held then.
  void end(const Fault& fault, std::uint64_t revision, const LateTicks& late,
           std::int64_t period_ns) noexcept UNDERACT_REAL_TIME {
    fault_ = fault;
    period_ns_ = period_ns;
    revision_ = revision;
    late_ = late;
  }
  /// No ticks; the room stays.
  void clear() noexcept UNDERACT_REAL_TIME {
    next_ = 0;
    full_ = false;
  }
  const Fault& fault() const { return fault_; }
  std::uint64_t revision() const { return revision_; }
  const LateTicks& late() const { return late_; }
  /// The period of the servo at that time.
  std::int64_t period_ns() const { return period_ns_; }
  std::size_t room() const { return ring_.size(); }
  std::vector<TickRecord> inOrder() const;  // oldest first

 private:
  std::vector<TickRecord> ring_;
  std::size_t next_ = 0;
  bool full_ = false;
  Fault fault_;
  std::uint64_t revision_ = 0;
  LateTicks late_;
  std::int64_t period_ns_ = 0;
};

}  // namespace underact::servo
