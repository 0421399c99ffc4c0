// The 36 calls, with signatures of their own: they are not the driver's, so that a mistake there shows.
#include <array>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "tests/openhaptics/hd/library.h"

namespace underact::test::hd {
namespace {

/// One call, from its count to its end.
class Call {
 public:
  explicit Call(const char* name) : lock(the.mutex), entry_(the.enter(name)) {
    if (entry_.delay_ms == 0) return;
    lock.unlock();
    std::this_thread::sleep_for(std::chrono::milliseconds(entry_.delay_ms));
    lock.lock();
  }
  bool fails() const { return entry_.fails; }

  Library& the = Library::the();
  std::unique_lock<std::mutex> lock;

 private:
  Library::Entry entry_;
};

/// The results of a getter; of one that fails, or in a storm, anything.
template <class T, class Narrow>
void answer(const char* name, std::uint32_t parameter, T* values, bool fits, const Narrow& narrow) {
  Call call(name);
  std::array<double, 16> all{};
  const bool knows = fits && call.the.get(parameter, all.data());
  if (!knows && !call.fails()) call.the.push(fits ? 0x100 : 0x103);
  const bool is_random = call.the.isRandom();
  if (call.fails()) all.fill(std::nan(""));
  if (is_random) {
    for (std::size_t i = 0; i < 6; ++i) all[i] = call.the.randomNumber();
  }
  const bool are_angles = parameter == 0x2100 || parameter == 0x2150;
  if (are_angles && !(std::isfinite(all[0]) && std::isfinite(all[1]) && std::isfinite(all[2]))) call.the.sawNoNumber();
  if (!knows && !is_random && !call.fails()) return;
  const std::size_t count = parameter == 0x2052 ? 16
                            : parameter == 0x2550 || parameter == 0x2551 || parameter == 0x2010 || parameter == 0x2605
                                ? 6
                            : parameter == 0x2050 || parameter == 0x2051 || are_angles ? 3
                                                                                       : 1;
  for (std::size_t i = 0; i < count; ++i) values[i] = narrow(all[i]);
}

bool isWhole(std::uint32_t parameter) {
  return parameter == 0x2000 || parameter == 0x2200 || (parameter >= 0x2553 && parameter <= 0x2555) ||
         parameter == 0x2600 || parameter == 0x2601;
}

bool isSwitch(std::uint32_t parameter) {
  return parameter == 0x2001 || parameter == 0x2002;
}

template <class T>
T whole(double value) {
  return std::isfinite(value) && std::fabs(value) < 2e9 ? static_cast<T>(value) : static_cast<T>(-1);
}

}  // namespace

#define HD_API __attribute__((visibility("default")))

extern "C" {

HD_API std::uint32_t hdInitDevice(const char* /*name*/) {
  Call call("hdInitDevice");
  return call.fails() ? kNoDevice : call.the.init();
}
HD_API void hdMakeCurrentDevice(std::uint32_t device) {
  Call call("hdMakeCurrentDevice");
  if (!call.fails() && device != kTheDevice) call.the.push(0x104);
}
HD_API std::uint32_t hdGetCurrentDevice() {
  Call call("hdGetCurrentDevice");
  return call.fails() ? kNoDevice : call.the.current();
}
HD_API void hdDisableDevice(std::uint32_t /*device*/) {
  Call call("hdDisableDevice");
  if (!call.fails()) call.the.disable();
}
HD_API void hdBeginFrame(std::uint32_t /*device*/) {
  Call call("hdBeginFrame");
  if (!call.fails()) call.the.beginFrame();
}
HD_API void hdEndFrame(std::uint32_t /*device*/) {
  Call call("hdEndFrame");
  if (call.fails()) call.the.dropForce();
  call.the.endFrame();
}
HD_API ErrorInfo hdGetError() {
  Call call("hdGetError");
  return call.the.pop();
}
HD_API const char* hdGetErrorString(std::uint32_t /*code*/) {
  Call call("hdGetErrorString");
  return call.fails() ? nullptr : "an error of the stand-in";
}
HD_API void hdEnable(std::uint32_t capability) {
  Call call("hdEnable");
  if (!call.fails() && capability == 0x4000) call.the.switchForce(true);
}
HD_API void hdDisable(std::uint32_t capability) {
  Call call("hdDisable");
  if (!call.fails() && capability == 0x4000) call.the.switchForce(false);
}
HD_API std::uint8_t hdIsEnabled(std::uint32_t capability) {
  Call call("hdIsEnabled");
  return !call.fails() && capability == 0x4000 && call.the.forceIsOn() ? 1 : 0;
}
HD_API void hdGetBooleanv(std::uint32_t parameter, std::uint8_t* values) {
  answer("hdGetBooleanv", parameter, values, isSwitch(parameter),
         [](double value) { return static_cast<std::uint8_t>(value != 0.0); });
}
HD_API void hdGetIntegerv(std::uint32_t parameter, std::int32_t* values) {
  answer("hdGetIntegerv", parameter, values, isWhole(parameter), whole<std::int32_t>);
}
HD_API void hdGetFloatv(std::uint32_t parameter, float* values) {
  answer("hdGetFloatv", parameter, values, !isWhole(parameter) && !isSwitch(parameter) && parameter != 0x2010,
         [](double value) { return std::fabs(value) < 1e38 ? static_cast<float>(value) : std::nanf(""); });
}
HD_API void hdGetDoublev(std::uint32_t parameter, double* values) {
  const bool fits =
      !isWhole(parameter) && !isSwitch(parameter) && parameter != 0x2010 && parameter != 0x2552;  // a float, a long
  answer("hdGetDoublev", parameter, values, fits, [](double value) { return value; });
}
HD_API void hdGetLongv(std::uint32_t parameter, long* values) {
  answer("hdGetLongv", parameter, values, parameter == 0x2010, whole<long>);
}
HD_API const char* hdGetString(std::uint32_t parameter) {
  Call call("hdGetString");
  return call.fails() || call.the.isRandom() ? nullptr : call.the.text(parameter);
}
HD_API void hdSetBooleanv(std::uint32_t /*parameter*/, const std::uint8_t* /*values*/) {
  Call call("hdSetBooleanv");
}
HD_API void hdSetIntegerv(std::uint32_t /*parameter*/, const std::int32_t* /*values*/) {
  Call call("hdSetIntegerv");
}
HD_API void hdSetFloatv(std::uint32_t /*parameter*/, const float* /*values*/) {
  Call call("hdSetFloatv");
}
HD_API void hdSetDoublev(std::uint32_t parameter, const double* values) {
  Call call("hdSetDoublev");
  if (!call.fails() && parameter == 0x2700) call.the.setForce(values);
}
HD_API void hdSetLongv(std::uint32_t /*parameter*/, const long* /*values*/) {
  Call call("hdSetLongv");
}
HD_API std::uint32_t hdCheckCalibration() {
  Call call("hdCheckCalibration");
  if (call.the.isRandom()) return call.the.randomCode();
  return call.fails() ? 0 : call.the.calibrationStatus();
}
HD_API std::uint32_t hdCheckCalibrationStyle() {
  Call call("hdCheckCalibrationStyle");
  if (call.the.isRandom()) return call.the.randomCode();
  return call.fails() ? 0 : call.the.calibrationStyle();
}
HD_API void hdUpdateCalibration(std::uint32_t style) {
  Call call("hdUpdateCalibration");
  if (!call.fails()) call.the.updateCalibration(style);
}
HD_API void hdUpdateCalibrationMessage() {
  Call call("hdUpdateCalibrationMessage");
}
HD_API void hdScaleGimbalAngles() {
  Call call("hdScaleGimbalAngles");
}
HD_API void hdDeploymentLicense() {
  Call call("hdDeploymentLicense");
}
HD_API void hdStartScheduler() {
  Call call("hdStartScheduler");
  if (!call.fails()) call.the.startClock(call.lock);
}
HD_API void hdStopScheduler() {
  Call call("hdStopScheduler");
  if (!call.fails()) call.the.stopClock(call.lock);
}
HD_API void hdSetSchedulerRate(unsigned long rate_hz) {
  Call call("hdSetSchedulerRate");
  if (!call.fails() && !call.the.setRate(rate_hz)) call.the.push(0x101);
}
HD_API void hdScheduleSynchronous(Callback callback, void* self, std::uint16_t /*priority*/) {
  {
    Call call("hdScheduleSynchronous");
    if (call.fails()) return;
  }
  (void)callback(self);
}
HD_API unsigned long hdScheduleAsynchronous(Callback callback, void* self, std::uint16_t priority) {
  Call call("hdScheduleAsynchronous");
  return call.fails() ? 0 : call.the.schedule(callback, self, priority);
}
HD_API void hdUnschedule(unsigned long handle) {
  Call call("hdUnschedule");
  if (!call.fails()) call.the.unschedule(handle);
}
HD_API std::uint8_t hdWaitForCompletion(unsigned long handle, std::uint32_t /*wait*/) {
  Call call("hdWaitForCompletion");
  return call.the.isScheduled(handle) ? 1 : 0;
}
HD_API double hdGetSchedulerTimeStamp() {
  Call call("hdGetSchedulerTimeStamp");
  return 0.0;
}
HD_API Control* underactHdControl() {
  return &Library::the();
}
}

#undef HD_API

}  // namespace underact::test::hd
