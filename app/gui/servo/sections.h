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

/// Rate, latency and tick time of the servo.
class TimeSection : public Section {
  Q_OBJECT
 public:
  explicit TimeSection(QWidget* parent = nullptr);
  /// measured_hz: ticks per second of real time; 0: the servo is ticked by hand.
  void present(const servo::Snapshot& snapshot, const servo::Timing& timing, int rate_hz, double measured_hz);
  void setTheme(const Theme& theme);

 private:
  Readout *rate_, *late_;
  NumberTable* percentiles_;
  LatenessChart* chart_;
};

/// The scheduling in effect, and how to improve it.
class SchedulingSection : public Section {
  Q_OBJECT
 public:
  explicit SchedulingSection(QWidget* parent = nullptr);
  void present(const system::Scheduling& scheduling);

 private:
  QLabel *name_, *also_, *hint_;
};

/// Each limit of the safety gate: how much it reduces the force now, when it last did and by how much; and the motor
/// heat.
class LimitsSection : public Section {
  Q_OBJECT
 public:
  explicit LimitsSection(QWidget* parent = nullptr);
  void add(const servo::TickRecord& record);
  void present(const servo::Snapshot& snapshot, int rate_hz);
  /// The rate changes at the tick `ticks`; converts the ticks at which limits last acted.
  void setRate(std::int64_t ticks, int was_hz, int is_hz);
  void setTheme(const Theme& theme);

 private:
  struct Limit {
    ShareBar* bar = nullptr;
    std::int64_t last_tick = 0;  // at which it last acted; 0: never
    double max_N = 0.0;
  };
  std::vector<Limit> limits_;
  ShareBar* ramp_;
  std::array<ShareBar*, 3> heat_{};
};

}  // namespace underact::gui
