#include "core/lab/arm_model.h"

#include <algorithm>
#include <cmath>

#include "core/base/translate.h"
#include "core/base/types.h"

namespace underact::lab {

Result<TransferFunction> transferOf(const HeldMass& held, scene::LawType law) {
  const double damping = held.damping_N_s_per_m + (law == scene::LawType::P ? 0.0 : held.kd_N_s_per_m);
  const double ki = law == scene::LawType::PID ? held.ki_N_per_m_s : 0.0;
  if (!(std::min({held.mass_kg, held.damping_N_s_per_m, held.kp_N_per_m, held.kd_N_s_per_m, ki}) >= 0.0))
    return Problems{{phrase(TRANSLATE_NOOP("problem", "Mass, damping and gains must be 0 or above."))}};
  if (!(held.mass_kg > 0.0 || damping > 0.0))
    return Problems{{phrase(TRANSLATE_NOOP(
        "problem",
        "What is held has neither mass nor damping, so it would reach the target at once. Give it mass or damping."))}};
  if (law != scene::LawType::PID)
    return makeTransferFunction({held.kp_N_per_m}, {held.mass_kg, damping, held.kp_N_per_m});
  return makeTransferFunction({held.kp_N_per_m, ki}, {held.mass_kg, damping, held.kp_N_per_m, ki});
}

NaturalMotion naturalMotion(const HeldMass& held, scene::LawType law) {
  if (!(held.mass_kg > 0.0 && held.kp_N_per_m > 0.0)) return {kNotANumber, kNotANumber};
  const double damping = held.damping_N_s_per_m + (law == scene::LawType::P ? 0.0 : held.kd_N_s_per_m);
  return {std::sqrt(held.kp_N_per_m / held.mass_kg), damping / (2.0 * std::sqrt(held.kp_N_per_m * held.mass_kg))};
}

}  // namespace underact::lab
