#include "app/gui/stability.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/sim/hand.h"

namespace underact::gui {

// The limit of a wall with one tick of delay is K T = (b + B) / 1.5 where B is small (Gil et al. 2009). The arm itself
// has none of that delay in the simulation, so this errs on the calm side by a factor of three.
constexpr double kHalfATickAndOneOfDelay = 1.5;

// Gains of joints are as felt in the middle of the workspace along each joint's own way; the stiffest way of the tip in
// the workspace is 7.5 times as stiff (guide, "Control in joint space": 3.74 N/mm of 0.5).
constexpr double kStiffestByJoints = 7.5;

double calmStiffness(double kd_N_s_per_m, double hand_damping_N_s_per_m, int rate_hz) {
  const double period_s = 1.0 / rate_hz;
  const double delayed = (hand_damping_N_s_per_m + kd_N_s_per_m) / (kHalfATickAndOneOfDelay * period_s);
  const double passive = 2.0 * (hand_damping_N_s_per_m - std::abs(kd_N_s_per_m)) / period_s;
  return std::max(0.0, std::min(delayed, passive));
}

QString whyItMayBuzz(const scene::Control& control, int axis, int rate_hz) {
  const bool in_joints = control.space == tick::Space::Joint;
  const double kp = control.gains.kp_N_per_mm[axis] * (in_joints ? kStiffestByJoints : 1.0);
  const double kd = control.law == scene::LawType::P ? 0.0 : control.gains.kd_N_s_per_mm[axis] * kNewtonPerMetre;
  const double hand = sim::HandModel{}.damping_N_s_per_m;
  const double calm = calmStiffness(kd, hand, rate_hz) / kNewtonPerMetre;
  if (kp <= calm) return {};
  if (in_joints) {
    return QObject::tr("q%1: above %2 N/mm at %3 Hz the stylus may buzz somewhere in the workspace.")
        .arg(axis + 1)
        .arg(calm / kStiffestByJoints, 0, 'f', 2)
        .arg(rate_hz);
  }
  return QObject::tr("%1: above %2 N/mm at %3 Hz the stylus may buzz in a hand with %4 N s/m of damping.")
      .arg(QChar('x' + axis))
      .arg(calm, 0, 'f', 2)
      .arg(rate_hz)
      .arg(hand, 0, 'f', 0);
}

}  // namespace underact::gui
