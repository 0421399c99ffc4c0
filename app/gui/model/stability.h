#pragma once
#include <QString>

#include "core/scene/description.h"

namespace underact::gui {

/// The stiffness in N/m up to which a sampled wall does not buzz in the simulated hand: the lower of Gil and Hulin's
/// bound with one tick of delay, K < (b + B) / (1.5 T), and Colgate and Schenkel's, b > K T / 2 + |B|. b: the hand's
/// damping, B: kd.
double calmStiffness(double kd_N_s_per_m, double hand_damping_N_s_per_m, int rate_hz);

/// Why the stiffness of one axis (0 x, 1 y, 2 z) may buzz, in a sentence; empty if it does not.
QString buzzWarning(const scene::Control& control, int axis, int rate_hz);

}  // namespace underact::gui
