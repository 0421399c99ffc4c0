#include "device/openhaptics/frames.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <deque>
#include <mutex>
#include <thread>

#include "core/arm/forward.h"
#include "core/arm/sample.h"
#include "core/base/units.h"
#include "core/safety/gate.h"
#include "core/system/clock.h"

namespace underact::device::openhaptics {
namespace {

constexpr std::int64_t kLooksApart = 64;        // frames between two looks at calibration and inkwell
constexpr std::int64_t kQuiet_ns = 20'000'000;  // zero force after a force error
constexpr int kFarewells = 5;
// A wrong preset is some 15 mm off; a sign that is not as the facts have it, twice the way from the middle.
constexpr double kWrongArm_m = 0.05, kRightArm_m = 0.04;
constexpr int kOffFrames = 50;

template <class Condition>
bool waitFor(std::chrono::milliseconds longest, const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + longest;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return true;
}

/// Kept for as long as the process lives; one for each time that an arm is opened.
Ticket* newTicket() {
  static std::mutex mutex;
  static std::deque<Ticket>* const all = new std::deque<Ticket>;
  const std::scoped_lock lock(mutex);
  return &all->emplace_back();
}

}  // namespace

Frames::Frames(const Calls& hd, const arm::Preset& arm)
    : hd_(hd), geometry_(arm.geometry), preset_force_N_(arm.continuous_force_N), opened_ns_(system::monotonicNow_ns()) {
  arm_status_.begin();
}

std::uint32_t Frames::callback(void* ticket) {
  Ticket& the = *static_cast<Ticket*>(ticket);
  the.is_at_work.store(true);
  Frames* const frames = the.frames.load();
  if (frames != nullptr) frames->run();
  the.is_at_work.store(false);
  return frames != nullptr ? kCallbackContinue : kCallbackDone;
}

void Frames::run() noexcept {
  count_.fetch_add(1, std::memory_order_release);
  began_ns_.store(system::monotonicNow_ns(), std::memory_order_relaxed);
  if (arm_status_.stopped()) {
    rest();
  } else {
    frame();
  }
}

Ticket* Frames::begin(Handle device) {
  ticket_ = newTicket();
  ticket_->frames.store(this);
  device_ = device;
  arm_status_.begin();
  exchange_.cut();
  closes_ = false;
  known_ = false;
  zeros_ = 0;
  count_ = 0;
  began_ns_ = system::monotonicNow_ns();
  quiet_until_ns_ = 0;
  could_push_ = inkwell_works_ = is_docked_ = is_wrong_arm_ = false;
  is_output_on_ = true;  // whoever opened it has switched it on
  off_frames_ = without_sample_ = 0;
  farewells_ = kFarewells;
  return ticket_;
}

void Frames::attach(servo::Ticks* ticks) noexcept {
  ticks_.store(ticks);
  if (ticks != nullptr) return;
  while (is_ticking_.load()) std::this_thread::yield();  // a tick, and nothing of the library's, is in between
}

void Frames::close() noexcept {
  closes_.store(true);
  (void)waitFor(std::chrono::milliseconds(100),
                [this] { return zeros_.load() >= 2 || (arm_status_.stopped() && farewells_.load() == 0); });
}

bool Frames::retire() noexcept {
  if (ticket_ == nullptr) return true;
  ticket_->frames.store(nullptr);
  return waitFor(std::chrono::seconds(1), [this] { return !ticket_->is_at_work.load(); });
}

void Frames::frame() noexcept {
  const std::int64_t now_ns = system::monotonicNow_ns();
  judge(drain(hd_), false, now_ns);  // left over from others
  hd_.hdBeginFrame(device_);
  if (!known_.load(std::memory_order_relaxed)) learn();
  const Seen seen = poll(now_ns);
  if (count_.load(std::memory_order_relaxed) % kLooksApart == 1 || (seen.pressed != 0 && !calibration_.done())) {
    watchCalibration(seen.pressed != 0);
    watchInkwell();
    judge(drain(hd_), false, now_ns);
  }
  if (seen.is_fresh) exchange_.offer(seen.sample, seen.pressed);
  tick();
  const Vec3 f_T_W = force(seen, now_ns);
  send(f_T_W);
  hd_.hdEndFrame(device_);
  judge(drain(hd_), false, now_ns);
  switchOutput(now_ns >= quiet_until_ns_ && !arm_status_.stopped());
  if (closes_.load()) zeros_.fetch_add(1);
  known_.store(true, std::memory_order_release);
}

void Frames::learn() noexcept {
  Drained worst;
  capabilities_ = readCapabilities(hd_, worst);
  if (worst.worst == Severity::Stop) arm_status_.stop(worst.code);
  const double cap_N = capabilities_.max_continuous_force_N.value_or(0.0);
  cap_N_ = cap_N > 0.0 ? cap_N : preset_force_N_;
  calibration_ = Calibration(static_cast<std::uint32_t>(capabilities_.calibration_styles.value_or(kInkwell)));
}

Frames::Seen Frames::poll(std::int64_t now_ns) noexcept {
  std::array<double, kRoom> joints_rad{}, gimbal_rad{}, p_mm{};
  std::array<std::int32_t, kRoom> now{}, before{};
  hd_.hdGetDoublev(kJointAngles, joints_rad.data());
  hd_.hdGetDoublev(kGimbalAngles, gimbal_rad.data());
  hd_.hdGetDoublev(kPosition, p_mm.data());
  hd_.hdGetIntegerv(kCurrentButtons, now.data());
  hd_.hdGetIntegerv(kLastButtons, before.data());
  const Drained drained = drain(hd_);
  judge(drained, true, now_ns);

  Seen seen;
  last_ns_ = std::max(last_ns_ + 1, now_ns - opened_ns_);
  seen.sample.time_ns = last_ns_;
  seen.sample.q_rad =
      arm::dhFromDevice({joints_rad[0], joints_rad[1], joints_rad[2], gimbal_rad[0], gimbal_rad[1], gimbal_rad[2]});
  seen.sample.buttons = static_cast<std::uint32_t>(now[0]) & 0xFU;
  seen.sample.epoch = epoch_;
  seen.pressed = seen.sample.buttons & ~static_cast<std::uint32_t>(before[0]);
  const Vec3 p_WT = kMetrePerMillimetre * Vec3(p_mm[0], p_mm[1], p_mm[2]);
  seen.off_m = (p_WT - arm::tipPosition(geometry_, seen.sample.q_rad)).norm();
  // Trigonometry of huge angles is no place: they are no arm's.
  constexpr double kMaxTurns_rad = 100.0;
  const bool is_finite = std::all_of(seen.sample.q_rad.begin(), seen.sample.q_rad.end(),
                                     [](double angle) { return std::fabs(angle) < kMaxTurns_rad; });
  seen.is_fresh = drained.worst == Severity::None && is_finite;
  without_sample_ = seen.is_fresh ? 0 : without_sample_ + 1;
  arm_status_.withoutSample(without_sample_, is_finite && drained.code != 0 ? drained.code : kNotANumberSent);
  if (seen.is_fresh) watchDeviation(seen.off_m);
  return seen;
}

Vec3 Frames::force(const Seen& seen, std::int64_t now_ns) noexcept {
  const bool may = isForceAllowed(now_ns);
  // It may push again: the arm begins anew, so that the servo's gate starts softly. What answers a sample from before
  // is no force any more.
  if (may && !could_push_) ++epoch_;
  could_push_ = may;
  const Vec3 wanted_W = exchange_.wanted(epoch_);
  return may && seen.is_fresh ? safety::clampForce(wanted_W, cap_N_) : Vec3::Zero();
}

bool Frames::isForceAllowed(std::int64_t now_ns) const noexcept {
  return calibration_.done() && !is_docked_ && !is_wrong_arm_ && now_ns >= quiet_until_ns_ && !arm_status_.stopped() &&
         !closes_.load();
}

void Frames::watchCalibration(bool pressed) noexcept {
  calibration_.poll(hd_, pressed);
  arm_status_.calibration(calibration_.status(), calibration_.style());
}

/// The switch says 0 of a stylus in the inkwell (so two public programs have it). One that has never said otherwise may
/// not be there at all.
void Frames::watchInkwell() noexcept {
  if (!capabilities_.inkwell_switch) return;
  std::array<std::uint8_t, kRoom> is_out{};
  hd_.hdGetBooleanv(kInkwellSwitch, is_out.data());
  inkwell_works_ = inkwell_works_ || is_out[0] != 0;
  is_docked_ = inkwell_works_ && is_out[0] == 0;
  arm_status_.docked(is_docked_);
}

void Frames::watchDeviation(double off_m) noexcept {
  // A place that is no number is as wrong as one far away.
  const bool is_off = is_wrong_arm_ ? !(off_m < kRightArm_m) : !(off_m < kWrongArm_m);
  off_frames_ = is_off == is_wrong_arm_ ? 0 : off_frames_ + 1;
  if (off_frames_ >= kOffFrames) {
    is_wrong_arm_ = is_off;
    off_frames_ = 0;
  }
  arm_status_.deviation(off_m, is_wrong_arm_);
}

void Frames::judge(const Drained& drained, bool of_sample, std::int64_t now_ns) noexcept {
  if (drained.worst == Severity::Stop) arm_status_.stop(drained.code);
  // A question refused around the force: nobody knows what the arm has made of the force.
  if (drained.worst == Severity::Force || (drained.worst == Severity::Question && !of_sample)) {
    arm_status_.forceError(drained.code, drained.count, now_ns);
    quiet_until_ns_ = now_ns + kQuiet_ns;
  }
}

void Frames::send(const Vec3& f_T_W) noexcept {
  const std::array<double, 3> force_N{f_T_W.x(), f_T_W.y(), f_T_W.z()};
  hd_.hdSetDoublev(kCurrentForce, force_N.data());
}

void Frames::switchOutput(bool on) noexcept {
  if (on == is_output_on_) return;
  is_output_on_ = on;
  on ? hd_.hdEnable(kForceOutput) : hd_.hdDisable(kForceOutput);
}

/// A stopped arm: zero until it was taken without an error, then nothing more is asked of it. The servo ticks on, so
/// that it knows and says so.
void Frames::rest() noexcept {
  if (farewells_.load() > 0) {
    farewells_.fetch_sub(1);
    (void)drain(hd_);
    hd_.hdBeginFrame(device_);
    send(Vec3::Zero());
    hd_.hdEndFrame(device_);
    switchOutput(false);
    if (drain(hd_).worst == Severity::None) farewells_.store(0);
  }
  tick();
}

void Frames::tick() noexcept {
  is_ticking_.store(true);
  if (servo::Ticks* const ticks = ticks_.load()) ticks->tick();
  is_ticking_.store(false);
}

}  // namespace underact::device::openhaptics
