#include "device/openhaptics/calibration.h"

#include "core/base/translate.h"

namespace underact::device::openhaptics {
namespace {

/// The one to use where the arm knows several: the easiest for a person.
std::uint32_t easiest(std::uint32_t styles) noexcept {
  for (const std::uint32_t style : {kAutomatic, kInkwell, kEncoderReset}) {
    if ((styles & style) != 0) return style;
  }
  return kInkwell;
}

bool isOne(std::uint32_t style) noexcept {
  return style == kAutomatic || style == kInkwell || style == kEncoderReset;
}

}  // namespace

Calibration::Calibration(std::uint32_t styles) noexcept : styles_(styles), style_(easiest(styles)) {}

void Calibration::poll(const Calls& hd, bool pressed) noexcept {
  status_ = hd.hdCheckCalibration();
  if (status_ == kCalibrated) return;
  const std::uint32_t style = hd.hdCheckCalibrationStyle();
  style_ = isOne(style) ? style : easiest(styles_);
  const bool is_reset = style_ == kEncoderReset && status_ == kCalibrationNeedsHand && pressed;
  if (status_ == kCalibrationNeedsUpdate || is_reset) {
    hd.hdUpdateCalibration(style_);
    status_ = hd.hdCheckCalibration();
  }
}

Sentence calibrationSentence(std::uint32_t status, std::uint32_t style) {
  if (status == kCalibrated) return {};
  if (status == kCalibrationNeedsHand && style == kInkwell)
    return phrase(
        TRANSLATE_NOOP("problem", "The arm is not calibrated, so it gives no force. Put the stylus into the inkwell."));
  if (status == kCalibrationNeedsHand && style == kEncoderReset) {
    return phrase(TRANSLATE_NOOP("problem",
                                 "The arm is not calibrated, so it gives no force. Hold it in its reset position, as "
                                 "the vendor's manual shows, and press the stylus button nearer to the tip."));
  }
  if (status == kCalibrationNeedsHand || status == kCalibrationNeedsUpdate)
    return phrase(TRANSLATE_NOOP(
        "problem", "The arm is not calibrated, so it gives no force. Move the stylus around slowly until it is."));
  return phrase(TRANSLATE_NOOP(
      "problem", "The arm does not say whether it is calibrated, so it gives no force. Run the vendor's setup."));
}

}  // namespace underact::device::openhaptics
