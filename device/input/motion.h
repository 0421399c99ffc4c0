#pragma once
#include <array>
#include <cstdint>

#include "core/base/types.h"
#include "core/sim/hand.h"

namespace underact::device::input {

inline constexpr int kMaxAxes = 16, kMaxButtons = 64;

/// The readings of a controller or a 3D mouse at one moment.
struct Readings {
  int axes = 0;                         // how many there are
  std::array<double, kMaxAxes> axis{};  // -1 to 1; a stick rests at 0, a trigger at -1
  int buttons = 0;                      // how many there are
  std::uint64_t pressed = 0;            // bit 0: the first
  bool isPressed(int button) const {
    return button >= 0 && button < kMaxButtons && (pressed >> static_cast<unsigned>(button) & 1U) != 0;
  }
};

enum class SourceKind : std::uint8_t { None, Axis, Buttons, Triggers };

/// The input that moves the stylus one way and back. Axis: plus only. Buttons: the one for the positive direction and
/// the one for the negative. Triggers: the same with axes that rest at -1.
struct Source {
  SourceKind kind = SourceKind::None;
  int plus = -1, minus = -1;  // -1: none
  friend bool operator==(const Source&, const Source&) = default;
};

/// In frame W: x to the right, y up, z towards the person; rotations about the same axes.
enum class MotionAxis : std::uint8_t { Right, Up, Near, TurnX, TurnY, TurnZ };
inline constexpr std::size_t kMotionAxes = 6, kMoves = 3;  // the first kMoves of them are translations

inline constexpr double kFurthestDeadZone = 0.9, kFinest = 4.0;
inline constexpr double kFastest_m_per_s = 0.5, kFastest_rad_per_s = 6.0;

struct AxisMap {
  Source source;
  bool inverted = false;
  double dead_zone = 0.12;  // share of the range without effect, 0 to kFurthestDeadZone
  double exponent = 2.0;    // 1: linear; up to kFinest: fine near the middle, as fast at the end
  double top = 0.0;         // at the end of the range: m/s, for a rotation rad/s
  friend bool operator==(const AxisMap&, const AxisMap&) = default;
};

enum class ButtonRole : std::uint8_t { Stylus1, Stylus2, Stop };
inline constexpr std::size_t kPresses = 3;

/// What each input of a device does.
struct Map {
  std::array<AxisMap, kMotionAxes> motions;
  std::array<int, kPresses> presses{-1, -1, -1};  // a button each; -1: none
  friend bool operator==(const Map&, const Map&) = default;
};

/// The motion that a hand asks for.
struct Motion {
  Vec3 v_WT = Vec3::Zero();     // m/s
  Vec3 w_WT_W = Vec3::Zero();   // rad/s
  unsigned stylus_buttons = 0;  // bit 0: nearer to the tip
  bool stop = false;
  bool isAtRest() const { return v_WT.isZero(0.0) && w_WT_W.isZero(0.0); }
};

/// Which directions have been at rest once since the device appeared. What was held before that moves nothing: a
/// throttle at its end, a stick that is pushed while another window is active.
struct ReadyAxes {
  std::array<bool, kMotionAxes> motions{};
};

/// How far an input is moved, -1 to 1; 0 if the device has no such axis or button, or its reading is not finite.
double deflection(const Source& source, const Readings& readings);

/// 0 within the dead zone, growing continuously from its border to 1 at the end of the range; odd.
double shaped(double deflection, double dead_zone, double exponent);

/// The demanded share of the top speed, -1 to 1.
double share(const AxisMap& map, const Readings& readings);

ReadyAxes updatedReadyAxes(const ReadyAxes& awake, const Map& map, const Readings& readings);

Motion motionOf(const Map& map, const Readings& readings, const ReadyAxes& awake);

/// Two hands at one stylus.
Motion combined(const Motion& one, const Motion& other);

/// Distance from W beyond which there is no arm.
inline constexpr double kReach_m = 0.15;
/// How far a hand that pushes with a stick leads the tip at most: some 6 N with the usual hand, far more than any
/// supported arm resists with, and no long way back out of a wall.
inline constexpr double kLeash_m = 0.02;
/// A longer pause between two polls counts as this.
inline constexpr double kLongestStep_s = 0.25;

/// Where a hand with this motion wants the stylus after dt_s. X_WT: where the stylus is. Never further from W than
/// kReach_m, nor by its own motion further from the tip than kLeash_m; a motion that is not finite has no effect.
sim::HandSetpoint movedSetpoint(const sim::HandSetpoint& setpoint, const Motion& motion, double dt_s, const Pose& X_WT);

}  // namespace underact::device::input
