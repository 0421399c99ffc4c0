#pragma once
#include "core/manipulator/descend.h"

namespace underact::manipulator {

/// The global minimum of the energy.
struct Global {
  Energy at;
  int steps = 0;                // over all starts
  bool is_unique = false;       // false: another position of the end effector has the same energy, or none was found
  double second_J = kInfinity;  // excess energy of the second best position
};

/// Finds it from a cold start: descents from a grid over the joints (a fixed sequence from 3 joints on, and the chain's
/// own inverse where it has one). For set-up and for single poses; not for the servo thread. Of equal minima the first
/// one found counts. Deterministic. Cost: a closed form, or some hundred descents.
Global minEnergy(const Manipulator& manipulator, const Pose& X_WT);

}  // namespace underact::manipulator
