#pragma once
#include <cstdint>
#include <functional>

#include "core/servo/device_port.h"
#include "core/servo/histogram.h"
#include "core/servo/late.h"
#include "core/system/scheduling.h"
#include "core/tick/program.h"

namespace underact::servo {

/// What checkServo() is asked for.
struct CheckOptions {
  int seconds = 60;    // in all
  int rate_hz = 1000;  // 100 to 10000
  bool load = false;   // one busy thread on each core meanwhile
  system::SchedulingWanted scheduling = {};
};

/// floor: lateness of a loop that does nothing but wake; servo: lateness of the servo's ticks; tick_time: what they
/// took. The rest is of the servo.
struct CheckResult {
  Percentiles floor, servo, tick_time;
  system::Scheduling scheduling;
  LateTicks late;
  double seconds = 0;
  std::int64_t ticks = 0;
};

/// Measures how late the servo's ticks are on this machine, beside the least that is possible: a bare loop of the same
/// scheduling. The two take turns of a second (half of the time, where there are less than two), since the floor itself
/// moves within minutes.
/// device: the arm to tick; a simulated one is pushed by what program says, any other gets zero force. program: what
/// the servo runs. progress(share) is called some times a second; false: stop there. Not while another servo ticks the
/// device. Takes options.seconds; call it from a thread that may wait.
CheckResult checkServo(DevicePort& device, tick::TickProgram program, const CheckOptions& options,
                       const std::function<bool(double)>& progress);

}  // namespace underact::servo
