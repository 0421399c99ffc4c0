#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/json_object.h"
#include "core/base/fault.h"
#include "core/record/tick_figures.h"
#include "core/servo/histogram.h"
#include "core/servo/snapshot.h"

namespace underact::cli {

/// The statistics of a run over its ticks.
class RunSummary {
 public:
  void add(const servo::TickRecord& record);
  /// The servo's report of a fault, with the numbers that a row does not hold. tick: the one that found it.
  void tell(std::int64_t tick, const Fault& fault);
  std::int64_t ticks() const { return figures_.ticks(); }
  bool faulted() const { return !faults_.empty(); }

  struct Setting {
    int rate_hz = 1000;
    std::uint64_t seed = 0;
    bool fast = false;  // then no tick can be late
    std::string scheduling;
    std::string guard;                        // see servo::Host::guarding()
    std::optional<bool> renders_moment = {};  // none: the scene asks for no moment
  };
  JsonObject json(const Setting& setting) const;

 private:
  record::TickFigures figures_;
  double peak_moment_N_m_ = 0.0;
  std::int64_t clamped_ = 0;
  record::Work work_;
  record::StoredEnergy energy_;
  std::int64_t branch_changes_ = 0;
  std::int64_t out_of_reach_ = 0;
  FaultKind fault_ = FaultKind::None;  // of the last tick
  struct Found {
    std::int64_t tick = 0;
    std::int64_t time_ns = 0;
    Fault fault;
  };
  std::vector<Found> faults_;
  servo::Histogram lateness_;
  servo::Histogram tick_time_;
};

/// {"p50", "p99", "p99.9", "max"}, us; null if a number is not finite.
JsonObject percentilesObject(const servo::Percentiles& values);

}  // namespace underact::cli
