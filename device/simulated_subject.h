#pragma once
#include <cstdint>

#include "core/calibration/trial.h"

namespace underact::device {

/// A scripted hand on the simulated arm, instead of a person: it presses the left beam, then the right one, and says
/// which felt stiffer. What it feels is the slope of the force that the servo sent over displacement, with noise
/// according to Weber's law.
struct SimulatedSubject {
  double weber = 0.15;       // standard deviation of the felt stiffness, relative
  std::uint64_t random = 1;  // of its noise
};

/// The slope of force over displacement at a beam, N/mm, without noise: the beam and the control's stiffness in series.
Result<double> pressedStiffness(const scene::Description& scene, calibration::Beam beam);

/// Its answer. Problems: those of the scene.
Result<calibration::Beam> answerOf(SimulatedSubject& subject, const scene::Description& scene);

}  // namespace underact::device
