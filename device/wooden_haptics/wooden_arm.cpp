#include "device/wooden_haptics/wooden_arm.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <utility>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/base/excepted.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/system/thread.h"
#include "device/wooden_haptics/handshake.h"

namespace underact::device {
namespace {

// A computer that stalls for a moment is not a problem of the arm.
constexpr std::int64_t kSilent_ns = 100'000'000;
constexpr int kSilentReads = 20;  // in a row; after more, the gate gives up
// Steps of 0.05 mm at the tip: a hand that holds the arm crosses many per second.
constexpr double kFrozen_s = 1.0;
constexpr int kMaxRefused = 5;  // messages in a row that the arm did not accept: a single one may be lost
constexpr int kRead_ms = 5;     // how often a thread checks whether to end
constexpr std::int64_t kBetweenCalibrations_ns = 50'000'000;  // until the arm has answered the last one

std::int64_t periodOf(int rate_hz) {
  return 1'000'000'000 / std::max(rate_hz, 1);
}

bool isSame(const arm::Geometry& a, const arm::Geometry& b) {
  constexpr double kAlike_m = 1e-9;  // one was read from mm
  return std::abs(a.upper_m - b.upper_m) < kAlike_m && std::abs(a.fore_m - b.fore_m) < kAlike_m &&
         (a.p_WB - b.p_WB).norm() < kAlike_m;
}

}  // namespace

Result<std::unique_ptr<WoodenArm>> WoodenArm::open(HidBus& bus, const WoodenChoice& choice, const arm::Geometry& arm,
                                                   int rate_hz) {
  std::unique_ptr<WoodenArm> opened(new WoodenArm(bus, choice, arm, rate_hz));
  const Problems problems = opened->connect();
  if (!problems.empty()) return problems;
  return opened;
}

WoodenArm::WoodenArm(HidBus& bus, WoodenChoice choice, const arm::Geometry& arm, int rate_hz)
    : bus_(bus), choice_(std::move(choice)), arm_(arm), period_ns_(periodOf(rate_hz)) {
  opened_ns_ = system::monotonicNow_ns();
}

WoodenArm::~WoodenArm() {
  disconnect();
}

Problems WoodenArm::connect() {
  Result<WoodenLine> line = shakeHands(bus_, choice_);
  if (!line) return line.problems();
  pipe_ = std::move(line.value().pipe);
  format_ = line.value().format;
  model_ = line.value().model;
  wiring_ = &woodenWiring(format_.protocol);
  is_own_ = isSame(arm_, woodenGeometry(*model_));
  {
    const std::scoped_lock lock(words_mutex_);
    const std::string& serial = line.value().node.serial;
    info_ = {serial.empty() ? Sentence(model_->title)
                            : phrase(TRANSLATE_NOOP("problem", "%1, serial %2"), {model_->title, serial}),
             false, true, kFrozen_s, serial};
    home_path_ = format_.protocol == WoodenProtocol::V1
                     ? phrase(TRANSLATE_NOOP("problem",
                                             "Unplug it, put it in its home posture (upper arm upright, forearm level, "
                                             "straight ahead), plug it in and press Restart."))
                     : phrase(TRANSLATE_NOOP("problem",
                                             "Put it in its home posture (upper arm upright, forearm level, straight "
                                             "ahead) and press the calibration button on its board."));
  }
  ends_ = false;
  calibrates_ = false;
  is_lost_ = !isWoodenPosture(woodenJoints(*model_, *wiring_, line.value().first.counts));
  take(line.value().first);
  loss_ = Loss::None;
  missed_ = 0;
  start(reader_, "underact-in", &WoodenArm::readAll);
  start(writer_, "underact-out", &WoodenArm::writeAll);
  return {};
}

/// With the servo's priority, since the servo waits for these threads. Returns when the system has answered the
/// request.
void WoodenArm::start(std::thread& thread, const char* name, void (WoodenArm::*work)()) {
  std::promise<void> answered;
  std::future<void> answer = answered.get_future();
  const int rate_hz = static_cast<int>(1'000'000'000 / period_ns_);
  const auto run = [this, name, work, rate_hz](std::promise<void> asked) {
    system::nameThread(name);
    system::askForRealTime({}, rate_hz);
    asked.set_value();
    (this->*work)();
  };
  thread = std::thread(run, std::move(answered));
  answer.wait();
}

void WoodenArm::disconnect() {
  ends_ = true;
  wrote_.ring();
  if (reader_.joinable()) reader_.join();
  if (writer_.joinable()) writer_.join();
  pipe_.reset();
}

Problems WoodenArm::reopen() {
  disconnect();
  ++epoch_;
  Problems problems = connect();
  if (!problems.empty()) loss_ = Loss::Reading;
  return problems;
}

void WoodenArm::lose(Loss loss) {
  Loss none = Loss::None;
  loss_.compare_exchange_strong(none, loss);
  came_.ring();
  wrote_.ring();
}

void WoodenArm::readAll() {
  std::array<std::uint8_t, kLongestWoodenReport> bytes{};
  while (!ends_ && loss_ == Loss::None) {
    const int size = pipe_->read(bytes, kRead_ms);
    if (size < 0) return lose(Loss::Reading);
    const auto report = readWoodenReport(format_, std::span(bytes).first(static_cast<std::size_t>(size)));
    if (report) take(*report);
  }
}

/// The calibration is done when the arm no longer asks for it; its counts then are others in the same posture.
void WoodenArm::take(const WoodenReport& report) {
  if (calibrates_ && !report.wants_calibration) {
    ++epoch_;
    is_lost_ = !isWoodenPosture(woodenJoints(*model_, *wiring_, report.counts));
  }
  calibrates_ = report.wants_calibration;
  const std::int64_t now_ns = system::monotonicNow_ns();
  taken_.back() = {++reports_, now_ns, report.counts, report.button, epoch_};
  taken_.publish();
  came_ns_ = now_ns;
  came_.ring();
}

void WoodenArm::writeAll() {
  std::uint64_t given = wanted_.latest().number;  // a command for a lost connection is not sent on this one
  std::int64_t sent_ns = 0, calibrated_ns = 0;
  int refused = 0;
  while (!ends_ && loss_ == Loss::None) {
    const std::int64_t quiet_ns = kQuietPeriods * period_ns_;
    wrote_.waitFor(quiet_ns);
    const std::int64_t now_ns = system::monotonicNow_ns();
    const Wanted& wanted = wanted_.latest();
    const bool is_new = wanted.number != given, is_quiet = now_ns - sent_ns >= quiet_ns;
    if (!is_new && !is_quiet && !is_cut_ && !calibrates_) continue;  // woken again for what was sent already
    given = wanted.number;
    WoodenMessage message =
        currentsMessage(format_, is_new && !is_cut_ && !calibrates_ ? wanted.currents_mA : Currents_mA{});
    if (calibrates_ && now_ns - calibrated_ns >= kBetweenCalibrations_ns) {
      message = calibrationMessage(format_, wiring_->home_counts);
      calibrated_ns = now_ns;
    }
    refused = pipe_->write(message.span()) ? 0 : refused + 1;
    if (refused > kMaxRefused) lose(Loss::Writing);
    sent_ns = now_ns;
  }
  pipe_->write(currentsMessage(format_, {}).span());  // whatever was lost: it may still arrive
}

std::int64_t WoodenArm::staleAfter_ns() const noexcept {
  return std::max(kStale_ns, kStalePeriods * period_ns_.load(std::memory_order_relaxed));
}

bool WoodenArm::isSilent() const {
  return system::monotonicNow_ns() - came_ns_ > kSilent_ns || missed_ >= kSilentReads;
}

bool WoodenArm::read(arm::Sample& sample) noexcept {
  const std::int64_t half_ns = period_ns_.load(std::memory_order_relaxed) / 2;
  came_.waitFor(half_ns);
  const Taken& taken = taken_.latest();
  const std::int64_t now_ns = system::monotonicNow_ns();
  if (loss_.load(std::memory_order_acquire) != Loss::None || now_ns - taken.time_ns > staleAfter_ns()) {
    missed_.fetch_add(1, std::memory_order_relaxed);
    return false;
  }
  missed_.store(0, std::memory_order_relaxed);
  q_rad_ = woodenJoints(*model_, *wiring_, taken.counts);
  is_reached_ = true;
  sample.q_rad = q_rad_;
  if (!is_own_) {
    const Vec3 p_WT =
        UNDERACT_EXCEPTED("lengths alone: nothing to free", arm::tipPosition(woodenGeometry(*model_), q_rad_));
    const arm::PositionSolution reach = arm::solvePosition(arm_, p_WT);
    sample.q_rad = reach.q_rad;
    is_reached_ = reach.reachable;
  }
  sample.buttons = taken.button ? 1U : 0U;
  sample.epoch = taken.epoch;
  // When it was received. A tick soon after a late one would divide a distance by almost no time.
  time_ns_ = std::max(now_ns - opened_ns_, time_ns_ + half_ns);
  sample.time_ns = time_ns_;
  return true;
}

void WoodenArm::write(const safety::GatedForce& force) noexcept {
  Wanted& wanted = wanted_.back();
  wanted.number = ++writes_;
  const bool pushes = is_reached_ && !is_lost_.load(std::memory_order_relaxed);
  wanted.currents_mA = pushes ? woodenCurrents(*model_, *wiring_, q_rad_, force.f_T_W()) : Currents_mA{};
  wanted_.publish();
  is_cut_.store(false, std::memory_order_release);
  wrote_.ring();
}

void WoodenArm::cut() noexcept {
  is_cut_.store(true, std::memory_order_release);
  wrote_.ring();
}

void WoodenArm::setRate(int rate_hz) {
  period_ns_ = periodOf(rate_hz);
}

servo::ZeroForceMessage WoodenArm::zeroForceMessage() const {
  if (!pipe_ || pipe_->guardFd() < 0) return {};
  const WoodenMessage zero = currentsMessage(format_, {});
  return {pipe_->guardFd(),
          std::string(zero.bytes.begin(), zero.bytes.begin() + static_cast<std::ptrdiff_t>(zero.size))};
}

Sentence WoodenArm::trouble() const {
  if (loss_ != Loss::None)
    return phrase(TRANSLATE_NOOP(
        "problem", "The WoodenHaptics arm was unplugged, or its connection was lost. Plug it in and press Restart."));
  if (isSilent())
    return phrase(
        TRANSLATE_NOOP("problem",
                       "The WoodenHaptics arm is plugged in, but sends nothing. Press the reset button on its "
                       "board, or plug it in again, and press Restart."));
  const std::scoped_lock lock(words_mutex_);
  if (is_lost_)
    return oneAfterAnother(
        {phrase(TRANSLATE_NOOP("problem", "The WoodenHaptics arm does not know its posture, so it gives no force.")),
         home_path_});
  return {};
}

servo::DeviceInfo WoodenArm::info() const {
  const std::scoped_lock lock(words_mutex_);
  return info_;
}

}  // namespace underact::device
