#pragma once
#include <cstdint>

#include "core/base/sentence.h"
#include "device/openhaptics/abi.h"

namespace underact::device::openhaptics {

/// The arm's calibration as its driver sees it: zero force until it is done.
class Calibration {
 public:
  /// styles: bits of CalibrationStyle that the arm knows.
  explicit Calibration(std::uint32_t styles = kInkwell) noexcept;

  /// Checks the calibration, and has the driver take it over when it is ready. pressed: a button went down, by which
  /// the person confirms that the arm is in its reset position. Inside a frame; its errors are left to the caller.
  void poll(const Calls& hd, bool pressed) noexcept;

  bool done() const noexcept { return status_ == kCalibrated; }
  std::uint32_t status() const noexcept { return status_; }
  std::uint32_t style() const noexcept { return style_; }

 private:
  std::uint32_t styles_;
  std::uint32_t style_;
  std::uint32_t status_ = 0;  // not known yet: not done
};

/// What the person has to do; empty if it is done.
Sentence calibrationSentence(std::uint32_t status, std::uint32_t style);

}  // namespace underact::device::openhaptics
