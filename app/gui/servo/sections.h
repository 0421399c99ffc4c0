#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "app/gui/kit/section.h"
#include "app/gui/kit/theme.h"
#include "core/servo/host.h"

class QLabel;

namespace underact::gui {

class LatenessChart;
class NumberTable;
class Readout;
class ShareBar;

/// How fast, how late, how long: what the servo's time is like.
class TimeSection : public Section {
  Q_OBJECT
 public:
  explicit TimeSection(QWidget* parent = nullptr);
  /// measured_hz: ticks a second by the clock on the wall; 0: it is ticked by hand.
  void present(const servo::Snapshot& snapshot, const servo::Timing& timing, int rate_hz, double measured_hz);
  void setTheme(const Theme& theme);

 private:
  Readout *rate_, *late_;
  NumberTable* percentiles_;
  LatenessChart* chart_;
};

/// What scheduling is in effect, and how to get better.
class SchedulingSection : public Section {
  Q_OBJECT
 public:
  explicit SchedulingSection(QWidget* parent = nullptr);
  void present(const system::Scheduling& scheduling);

 private:
  QLabel *name_, *also_, *hint_;
};

/// Each limit of the gate: what it cuts now, when it did last and how much, and how warm the motors are.
class LimitsSection : public Section {
  Q_OBJECT
 public:
  explicit LimitsSection(QWidget* parent = nullptr);
  void add(const servo::TickRecord& record);
  void present(const servo::Snapshot& snapshot, int rate_hz);
  /// From the tick `ticks` on they come at another rate: when a limit acted is kept in ticks.
  void setRate(std::int64_t ticks, int was_hz, int is_hz);
  void setTheme(const Theme& theme);

 private:
  struct Limit {
    ShareBar* bar = nullptr;
    std::int64_t last_tick = 0;  // in which it acted; 0: it never did
    double most_N = 0.0;
  };
  std::vector<Limit> limits_;
  ShareBar* ramp_;
  std::array<ShareBar*, 3> heat_{};
};

}  // namespace underact::gui
