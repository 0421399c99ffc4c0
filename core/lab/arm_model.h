#pragma once
#include "core/lab/transfer_function.h"
#include "core/scene/description.h"

namespace underact::lab {

/// A stylus held along one direction: mass and damping that the hand and the arm have, and the gains of the law.
struct HeldMass {
  double mass_kg = 0.0;
  double damping_N_s_per_m = 0.0;
  double kp_N_per_m = 0.0;
  double kd_N_s_per_m = 0.0;  // of PD and PID
  double ki_N_per_m_s = 0.0;  // of PID
};

/// From the target's position to the tip's. The target rests apart from its step, so damping acts on the tip alone
/// (eq. B.14 with its x_desired rate of 0). P, PD: kp / (m s^2 + (b + kd) s + kp). PID: (kp s + ki) / (m s^3 + (b + kd)
/// s^2 + kp s + ki). No friction, no sampling, no limits. Problems: neither mass nor damping, or a number below 0.
/// Source: Beckman 2007, eq. B.7 and B.13 to B.15.
Result<TransferFunction> transferOf(const HeldMass& held, scene::LawType law);

/// omega_n = sqrt(kp / m), rad/s, and zeta = (b + kd) / (2 sqrt(kp m)); of PID those of its second-order part. Not a
/// number where there is no mass or no kp.
struct NaturalMotion {
  double omega_n_rad_per_s;
  double zeta;
};
/// From the denominator of transferOf(); P leaves kd out.
NaturalMotion naturalMotion(const HeldMass& held, scene::LawType law);

}  // namespace underact::lab
