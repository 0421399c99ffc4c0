#pragma once
#include <cstring>
#include <vector>

#include "core/arm/inverse.h"
#include "core/arm/preset.h"
#include "core/base/trig.h"
#include "core/base/units.h"
#include "core/tick/step.h"
#include "tests/support/property.h"

namespace underact::test {

inline const arm::Geometry& thesisGeometry() {
  return arm::findPreset(arm::kDefaultArm)->geometry;
}
inline const safety::Limits kTestLimits{0.88};

/// A program, its state and its report, moved by a tip that goes where the test says.
class Hand {
 public:
  explicit Hand(tick::TickProgram program) : program_(std::move(program)), state_(makeState(program_)) {}
  Hand(std::vector<tick::Entry> entries, tick::Combine combine)
      : Hand(makeProgram(thesisGeometry(), std::move(entries), combine, kTestLimits)) {}

  /// A tick dt_s after the last one with the tip in p_WT.
  const tick::TickReport& at(const Vec3& p_WT, double dt_s = 1e-3) {
    return feed(arm::solvePosition(thesisGeometry(), p_WT).q_rad, dt_s);
  }
  const tick::TickReport& feed(const arm::JointAngles& q_rad, double dt_s = 1e-3) {
    input.sample.time_ns += static_cast<std::int64_t>(dt_s * 1e9 + (dt_s < 0.0 ? -0.5 : 0.5));
    input.sample.q_rad = q_rad;
    step(program_, input, state_, report_);
    input.restart = false;
    return report_;
  }
  /// So long at p_WT that every ramp is complete.
  const tick::TickReport& settle(const Vec3& p_WT) {
    for (int tick = 0; tick < 400; ++tick) at(p_WT);
    return report_;
  }

  tick::TickInput input{{}, true, true, false};
  tick::TickState& state() { return state_; }
  const tick::TickProgram& program() const { return program_; }
  const tick::TickReport& report() const { return report_; }

 private:
  tick::TickProgram program_;
  tick::TickState state_;
  tick::TickReport report_;
};

inline tick::Entry hold(const shape::Shape& shape, const control::Law& law, target::Side side = target::Side::Both) {
  return {target::makeConstraint(shape, side, control::stiffness(law)), law};
}

/// One of each shape about the middle of the workspace; unequal gains make the other alternatives of them.
inline std::vector<shape::Shape> middleShapes() {
  const Vec3 c(0.01, 0.02, 0.03);
  return {shape::makePoint(c, {}).value(),
          shape::makeSphere(c, 0.04, {}).value(),
          shape::makeLine(c, {-1, -2, 1}, {}).value(),
          shape::makePlane(c, {1, 1, 1}, {}).value(),
          shape::makeCircle(c, {-1, 1, -1}, 0.04, {}).value(),
          shape::makeCylinder(c, {-1, 1, -1}, 0.03, {}).value(),
          shape::makeBox(c, {0.06, 0.05, 0.04}, Mat3::Identity(), {}).value()};
}

/// P, PD and PID, each with equal gains and with unequal ones (the weighted metric).
inline std::vector<control::Law> everyLaw() {
  const Vec3 even = Vec3::Constant(500.0), uneven(800.0, 200.0, 400.0), kd = Vec3::Constant(2.0),
             ki(900.0, 300.0, 600.0);
  return {control::P{even},
          control::P{uneven},
          control::PD{even, kd},
          control::PD{uneven, kd},
          control::PID{even, kd, ki, 0.4},
          control::PID{uneven, kd, ki, 0.4}};
}

/// A motion through all of the workspace, by base/trig.h alone: the same bits everywhere.
inline arm::JointAngles scriptedAngles(std::int64_t tick) {
  const double t_s = 1e-3 * static_cast<double>(tick);
  return {0.35 * sinCos(1.7 * t_s).sin, 0.6 + 0.35 * sinCos(2.3 * t_s + 1.0).sin, 0.1 + 0.4 * sinCos(3.1 * t_s).cos,
          1.0 * sinCos(0.9 * t_s).sin,  1.5 + 0.5 * sinCos(1.1 * t_s).cos,        0.7 * sinCos(1.3 * t_s).sin};
}

/// FNV-1a over the bits of doubles.
class Checksum {
 public:
  void add(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    value_ = (value_ ^ bits) * 0x100000001B3U;
  }
  void add(const Vec3& v) { add(v.x()), add(v.y()), add(v.z()); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325U;
};

}  // namespace underact::test
