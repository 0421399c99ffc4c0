#include "device/openhaptics/arm_status.h"

#include "core/base/translate.h"
#include "device/openhaptics/calibration.h"
#include "device/openhaptics/errors.h"

namespace underact::device::openhaptics {
namespace {

constexpr std::int64_t kShown_ns = 2'000'000'000;  // long enough to read
constexpr int kManyPeriods = 20;                   // as many as the gate tolerates
constexpr double kWorthAWord_m = 5e-3;             // a calibrated arm deviates some 0.1 mm from its own model

Sentence millimetres(double length_m) {
  return shownNumber(1e3 * length_m, 0);
}

}  // namespace

void ArmStatus::begin() noexcept {
  stop_ = 0;
  calibration_ = kCalibrated;
  docked_ = false;
  off_m_ = 0.0;
  wrong_ = false;
  force_error_ns_ = 0;
  without_sample_ = 0;
}

void ArmStatus::stop(std::uint32_t code) noexcept {
  std::uint32_t none = 0;
  stop_.compare_exchange_strong(none, code, std::memory_order_acq_rel);
}

void ArmStatus::calibration(std::uint32_t status, std::uint32_t style) noexcept {
  calibration_.store(std::uint64_t{style} << 32 | status, std::memory_order_relaxed);
}

void ArmStatus::deviation(double off_m, bool wrong) noexcept {
  off_m_.store(off_m, std::memory_order_relaxed);
  wrong_.store(wrong, std::memory_order_relaxed);
}

void ArmStatus::forceError(std::uint32_t code, int count, std::int64_t now_ns) noexcept {
  force_errors_.fetch_add(count, std::memory_order_relaxed);
  force_code_.store(code, std::memory_order_relaxed);
  force_error_ns_.store(now_ns, std::memory_order_relaxed);
}

void ArmStatus::withoutSample(int periods, std::uint32_t code) noexcept {
  without_sample_.store(periods, std::memory_order_relaxed);
  sample_code_.store(code, std::memory_order_relaxed);
}

Sentence ArmStatus::sentence(std::int64_t now_ns, const std::string& arm) const {
  if (const std::uint32_t code = stop_.load(std::memory_order_acquire)) return sentenceOf(code);
  const std::uint64_t calibration = calibration_.load(std::memory_order_relaxed);
  const auto status = static_cast<std::uint32_t>(calibration), style = static_cast<std::uint32_t>(calibration >> 32);
  if (status != kCalibrated) return calibrationSentence(status, style);
  if (without_sample_.load(std::memory_order_relaxed) >= kManyPeriods) return sentenceOf(sample_code_);
  if (docked_.load(std::memory_order_relaxed))
    return phrase(TRANSLATE_NOOP("problem", "The stylus is in the inkwell, so the arm gives no force. Take it out."));
  const double off_m = off_m_.load(std::memory_order_relaxed);
  if (wrong_.load(std::memory_order_relaxed)) {
    return phrase(
        TRANSLATE_NOOP("problem",
                       "The arm reports its tip %1 mm from where the scene's arm \"%2\" has it, so it gets no "
                       "force: the force would point elsewhere. Choose the arm that is connected."),
        {millimetres(off_m), arm});
  }
  const std::int64_t at_ns = force_error_ns_.load(std::memory_order_relaxed);
  if (at_ns != 0 && now_ns - at_ns < kShown_ns)
    return oneAfterAnother({sentenceOf(force_code_),
                            phrase(TRANSLATE_NOOP("problem", "%1 times so far."), {std::to_string(forceErrors())})});
  if (off_m > kWorthAWord_m) {
    return phrase(
        TRANSLATE_NOOP("problem",
                       "The arm reports its tip %1 mm from where the scene's arm \"%2\" has it. Choose the arm "
                       "that is connected, otherwise shapes are felt elsewhere than they are shown."),
        {millimetres(off_m), arm});
  }
  return {};
}

}  // namespace underact::device::openhaptics
