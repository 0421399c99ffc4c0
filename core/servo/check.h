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
  bool load = false;   // with a load on each core, see Busy
  system::SchedulingRequest scheduling = {};
};

/// floor: latency of a loop that does nothing but wake; servo: latency of the servo's ticks; tick_time: their duration.
/// The rest is of the servo.
struct CheckResult {
  Percentiles floor, servo, tick_time;
  system::Scheduling scheduling;
  LateTicks late;
  double seconds = 0;
  std::int64_t ticks = 0;
};

/// Measures the latency of the servo's ticks on this machine, beside the least possible one: that of a bare loop with
/// the same scheduling. The two alternate every second (half of the time, where there are less than two), since the
/// floor itself changes within minutes. device: the arm to tick; a simulated one gets the force of the program, any
/// other zero force. program: what the servo runs. progress(share) is called some times a second; false: stop. Not
/// while another servo ticks the device. Takes options.seconds; to be called from a thread that may wait.
CheckResult checkServo(DevicePort& device, tick::TickProgram program, const CheckOptions& options,
                       const std::function<bool(double)>& progress);

}  // namespace underact::servo
