#pragma once
#include <array>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace underact::test {

/// The board of a WoodenHaptics arm and the arm behind it, said a second time: it shares no line with
/// device/wooden_haptics. It takes reports as bytes and gives reports as bytes; behind them are motors, bodies and a
/// tip. Any thread. Sources: the firmware's main.cpp of both protocols and kinematics.cpp; the bodies' inertia is made
/// up.
class WoodenFirmware {
 public:
  struct Built {
    int protocol = 1;              // 1, 2
    std::size_t report_bytes = 8;  // 8, 14; 64 on a Teensy
    std::array<double, 3> torque_N_m_per_A{0.0259, 0.0259, 0.0259};
    bool is_calibrated = true;  // protocol 2: its counters were set since it got its power
  };
  explicit WoodenFirmware(const Built& built);

  // The board. Times: ns of any clock that never goes back.
  /// A report of the host, without its id.
  void receive(std::span<const std::uint8_t> report, std::int64_t time_ns);
  /// What it says of itself, and the arm goes on until then.
  std::vector<std::uint8_t> report(std::int64_t time_ns);
  /// Protocol 2 says something only when it was spoken to; protocol 1 all the time.
  bool onlyAnswers() const { return built_.protocol == 2; }
  std::size_t reportBytes() const { return built_.report_bytes; }

  // The hand, and who looks at the motors.
  void placeTip(const Vec3& p_WT);  // and holds it there
  void letGo();                     // from now on the motors move it
  Vec3 tip() const;
  void holdButton(bool held);
  void freeze(bool on);  // reports stay as they are
  void pressCalibration();
  void losePower();  // its counters begin at 0, wherever it stands
  Vec3 force_N(std::int64_t time_ns) const;
  std::array<int, 3> currents_mA(std::int64_t time_ns) const;
  std::int64_t currentsTaken() const;  // reports with currents
  std::int64_t pushes() const;         // of them, with a current that is not 0
  double joules() const;               // what the motors have done since it was let go
  /// From each report that said first that the tip was placed elsewhere to the first other current (by more than 5 mA)
  /// that came after it.
  std::vector<std::int64_t> reactions_ns() const;

 private:
  Vec3 tipOf(const std::array<double, 3>& body_rad) const;
  Mat3 jacobian() const;
  std::array<int, 3> countsNow() const;
  Vec3 torques_N_m(std::int64_t time_ns) const;
  bool isPowered(std::int64_t time_ns) const;
  void moveUntil(std::int64_t time_ns);

  const Built built_;
  mutable std::mutex mutex_;
  std::array<double, 3> body_rad_{};  // A, B, C
  std::array<double, 3> rate_{};      // rad/s
  std::array<int, 3> offset_{};       // of the counters
  std::array<int, 3> currents_mA_{};
  std::int64_t time_ns_ = 0, heard_ns_ = 0;
  std::int64_t taken_ = 0, pushes_ = 0;
  double joules_ = 0.0;
  bool has_heard_ = false, is_held_ = true, button_ = false, wants_calibration_ = false, is_frozen_ = false;
  std::vector<std::uint8_t> frozen_;
  bool is_placed_ = false;     // no report has said so yet
  std::int64_t sent_ns_ = -1;  // when one did; -1: none, or it was answered
  std::array<int, 3> then_mA_{};
  std::vector<std::int64_t> reactions_ns_;
};

}  // namespace underact::test
