#include "app/gui/model/stability.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "app/gui/kit/words.h"
#include "core/base/units.h"
#include "core/sim/hand.h"
#include "core/stability/exact.h"

namespace underact::gui {

// Joint gains are as felt in the middle of the workspace along each joint's own direction; the stiffest direction of
// the tip in the workspace is 7.5 times as stiff (guide, "Control in joint space": 3.74 N/mm for 0.5).
constexpr double kStiffestByJoints = 7.5;

double calmStiffness(double kd_N_s_per_m, double hand_damping_N_s_per_m, int rate_hz) {
  stability::SampledWall wall;
  wall.damping_N_s_per_m = hand_damping_N_s_per_m;
  wall.kd_N_s_per_m = kd_N_s_per_m;
  wall.period_ns = 1'000'000'000 / rate_hz;
  const double passive = stability::colgateSchenkel(wall);
  // The simulated arm has none of that delay, so this errs on the safe side by a factor of three.
  wall.delay_ticks = 1;
  return std::min(stability::gilHulin(wall), passive);
}

QString buzzWarning(const scene::Control& control, int axis, int rate_hz) {
  const bool in_joints = control.space == tick::Space::Joint;
  const double kp = control.gains.kp_N_per_mm[axis] * (in_joints ? kStiffestByJoints : 1.0);
  const double kd = control.law == scene::LawType::P ? 0.0 : control.gains.kd_N_s_per_mm[axis] * kNewtonPerMetre;
  const double hand = sim::HandModel{}.damping_N_s_per_m;
  const double calm = calmStiffness(kd, hand, rate_hz) / kNewtonPerMetre;
  if (kp <= calm) return {};
  if (in_joints) {
    return QObject::tr("q%1: above %2 N/mm at %3 Hz the stylus may buzz somewhere in the workspace.")
        .arg(axis + 1)
        .arg(numberText(calm / kStiffestByJoints, 2))
        .arg(rate_hz);
  }
  return QObject::tr("%1: above %2 N/mm at %3 Hz the stylus may buzz in a hand with %4 N s/m of damping.")
      .arg(QChar('x' + axis))
      .arg(numberText(calm, 2))
      .arg(rate_hz)
      .arg(numberText(hand, 0));
}

}  // namespace underact::gui
