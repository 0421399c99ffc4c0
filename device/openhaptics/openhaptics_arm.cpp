#include "device/openhaptics/openhaptics_arm.h"

#include <chrono>
#include <clocale>
#include <cstring>
#include <thread>
#include <utility>

#include "core/base/translate.h"
#include "core/system/clock.h"
#include "device/openhaptics/find_arms.h"
#include "device/openhaptics/library.h"
#include "device/openhaptics/scheduler.h"
#include "device/openhaptics/settings.h"

namespace underact::device::openhaptics {
namespace {

constexpr double kFrozen_s = 0.5;  // encoder steps are 0.05 mm: no hand is so still
constexpr std::int64_t kSilence_ns = 500'000'000;
constexpr std::uint32_t kAlreadyOpen = 0x301;
constexpr const char* kStandsStill =
    TRANSLATE_NOOP("problem",
                   "The scheduler of the arm's driver has stopped: it has made no call for half a second. Restart the "
                   "servo; if that does not help, quit the program.");
constexpr const char* kHangs = TRANSLATE_NOOP("problem",
                                              "A call to the arm's driver has not returned, and the force may still be "
                                              "on. Switch the arm off, quit the program and start it again.");

/// Frames that hang in the driver: they may come back, and find what they touch.
void keepForGood(std::unique_ptr<Frames> frames) {
  static std::mutex mutex;
  static std::vector<std::unique_ptr<Frames>>* const kept = new std::vector<std::unique_ptr<Frames>>;
  const std::scoped_lock lock(mutex);
  kept->push_back(std::move(frames));
}

/// The driver reads and writes numbers with points.
void keepNumbersPlain() {
  const char* const locale = std::setlocale(LC_NUMERIC, nullptr);
  if (locale == nullptr || std::strcmp(locale, "C") != 0) std::setlocale(LC_NUMERIC, "C");
}

Sentence joined(const Problems& problems) {
  std::vector<Sentence> sentences;
  for (const Problem& problem : problems) sentences.push_back(problem.sentence);
  return oneAfterAnother(sentences);
}

}  // namespace

Result<std::unique_ptr<OpenHapticsArm>> OpenHapticsArm::open(const Options& options) {
  const Result<const Calls*> hd = load();
  if (!hd) return hd.problems();
  std::unique_ptr<OpenHapticsArm> arm(new OpenHapticsArm(*hd.value(), options));
  Problems problems = arm->connect();
  if (!problems.empty()) return problems;
  return arm;
}

OpenHapticsArm::OpenHapticsArm(const Calls& hd, const Options& options)
    : hd_(hd), options_(options), frames_(std::make_unique<Frames>(hd, options.arm)), rate_hz_(options.rate_hz) {}

OpenHapticsArm::~OpenHapticsArm() {
  disconnect();
  if (hangs_) keepForGood(std::move(frames_));
}

Problems OpenHapticsArm::connect() {
  if (hangs_) return {{phrase(kHangs), {}}};
  keepNumbersPlain();
  pointToSettings();
  Problems problems = initialise();
  keepNumbersPlain();
  if (!problems.empty()) return problems;
  Ticket* const ticket = frames_->begin(device_);
  Result<Scheduled> scheduled = Scheduler::theOne().join(hd_, rate_hz_, Frames::callback, ticket);
  if (scheduled) {
    scheduled_ = scheduled.value();
    is_open_ = true;
    problems = awaitFirstFrame();
  } else {
    problems = scheduled.problems();
  }
  if (!problems.empty()) disconnect();
  return problems;
}

Problems OpenHapticsArm::initialise() {
  std::vector<const char*> names{nullptr, "Default Device", "Default PHANToM"};
  if (!options_.address.empty()) names = {options_.address.c_str()};
  std::uint32_t worst = 0;
  for (const char* const name : names) {
    (void)drain(hd_);
    Handle device = hd_.hdInitDevice(name);
    Drained drained = drain(hd_);
    if (drained.code == kAlreadyOpen && Scheduler::theOne().users() == 0) {  // by nobody in this process: left over
      hd_.hdDisableDevice(hd_.hdGetCurrentDevice());
      (void)drain(hd_);
      device = hd_.hdInitDevice(name);
      drained = drain(hd_);
    }
    if (device != kNoHandle && drained.worst == Severity::None) {
      device_ = device;
      break;
    }
    if (worst == 0) worst = drained.code;
    if (device != kNoHandle) hd_.hdDisableDevice(device);
  }
  if (device_ == kNoHandle) {
    const char* const words = worst != 0 ? hd_.hdGetErrorString(worst) : nullptr;
    return {{oneAfterAnother(
                 {options_.address.empty()
                      ? phrase(TRANSLATE_NOOP("problem", "No arm could be opened."))
                      : phrase(TRANSLATE_NOOP("problem", "No arm could be opened under the name \"%1\"."),
                               {options_.address}),
                  worst != 0 ? sentenceOf(worst) : phrase(TRANSLATE_NOOP("problem", "Its driver gives no reason.")),
                  words != nullptr ? phrase(TRANSLATE_NOOP("problem", "Its driver says: %1."), {words}) : Sentence()}),
             {}}};
  }
  hd_.hdMakeCurrentDevice(device_);
  hd_.hdEnable(kForceOutput);
  const bool is_on = hd_.hdIsEnabled(kForceOutput) != 0 && hd_.hdGetCurrentDevice() == device_;
  const Drained drained = drain(hd_);
  if (is_on && drained.worst == Severity::None) return {};
  disconnect();
  return {{oneAfterAnother(
               {phrase(TRANSLATE_NOOP("problem", "The arm's force cannot be switched on.")), sentenceOf(drained.code)}),
           {}}};
}

Problems OpenHapticsArm::awaitFirstFrame() {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  while (frames_->capabilities() == nullptr && !frames_->armStatus().stopped()) {
    if (std::chrono::steady_clock::now() > end) return {{phrase(kStandsStill), {}}};
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  if (frames_->armStatus().stopped()) return {{frames_->armStatus().sentence(0, options_.arm.name), {}}};
  const std::scoped_lock lock(mutex_);
  capabilities_ = *frames_->capabilities();
  return {};
}

/// Zero force, then clock, callback, force output and arm, in the order that the vendor's manual asks for.
void OpenHapticsArm::disconnect() {
  frames_->attach(nullptr);
  if (is_open_) {
    frames_->close();
    Scheduler::theOne().leave(hd_, scheduled_);
  }
  hangs_ = !frames_->retire();
  is_open_ = false;
  if (device_ != kNoHandle && !hangs_) {
    hd_.hdMakeCurrentDevice(device_);
    hd_.hdDisable(kForceOutput);
    hd_.hdDisableDevice(device_);
    (void)drain(hd_);
  }
  device_ = kNoHandle;
}

void OpenHapticsArm::say(const Problems& problems) {
  const std::scoped_lock lock(mutex_);
  trouble_ = joined(problems);
}

bool OpenHapticsArm::read(arm::Sample& sample) noexcept {
  return frames_->exchange().read(sample);
}

void OpenHapticsArm::write(const safety::GatedForce& force) noexcept {
  frames_->exchange().write(force.f_T_W());
}

void OpenHapticsArm::cut() noexcept {
  frames_->exchange().cut();
}

Problems OpenHapticsArm::reopen() {
  disconnect();
  Problems problems = connect();
  say(problems);
  return problems;
}

Sentence OpenHapticsArm::fixedRateReason() const {
  const std::vector<int> rates = Scheduler::theOne().rates();
  if (Scheduler::theOne().users() > 1) return rateRefusal(0);
  if (rates.size() > 1) return {};
  return phrase(TRANSLATE_NOOP("problem", "The arm's driver supports only one rate, %1 Hz."),
                {std::to_string(rate_hz_)});
}

Sentence OpenHapticsArm::rateRefusal(int rate_hz) const {
  return Scheduler::theOne().refuses(rate_hz);
}

void OpenHapticsArm::setRate(int rate_hz) {
  rate_hz_ = rate_hz;  // drive() goes by it, and says where it cannot
}

bool OpenHapticsArm::drive(servo::Ticks& ticks, int rate_hz) {
  if (!is_open_) return false;
  const Problems problems = Scheduler::theOne().setRate(hd_, rate_hz);
  say(problems);
  if (!problems.empty()) return false;
  rate_hz_ = rate_hz;
  frames_->attach(&ticks);
  return true;
}

void OpenHapticsArm::endDrive() {
  frames_->attach(nullptr);
}

Sentence OpenHapticsArm::trouble() const {
  const std::scoped_lock lock(mutex_);
  if (!trouble_.empty()) return trouble_;
  const std::int64_t now_ns = system::monotonicNow_ns();
  const Sentence sentence = frames_->armStatus().sentence(now_ns, options_.arm.name);
  return sentence.empty() && now_ns - frames_->began_ns() > kSilence_ns ? phrase(kStandsStill) : sentence;
}

servo::DeviceInfo OpenHapticsArm::info() const {
  const std::scoped_lock lock(mutex_);
  std::string title = capabilities_.model.value_or("");
  if (title.empty()) title = "Touch, Omni";
  return {phrase(TRANSLATE_NOOP("problem", "%1 (vendor's driver)"), {title}), false, true, kFrozen_s,
          capabilities_.serial.value_or("")};
}

std::vector<std::string> OpenHapticsArm::listing() const {
  const std::scoped_lock lock(mutex_);
  return openhaptics::listing(capabilities_, options_.arm);
}

Result<std::unique_ptr<servo::DevicePort>> openArm(const Request& request) {
  Result<std::unique_ptr<OpenHapticsArm>> arm = OpenHapticsArm::open({request.arm, request.rate_hz, request.address});
  if (!arm) return arm.problems();
  return std::unique_ptr<servo::DevicePort>(std::move(arm).value());
}

std::vector<Found> searchArms() {
  return findArms(places(), missing());
}

}  // namespace underact::device::openhaptics
