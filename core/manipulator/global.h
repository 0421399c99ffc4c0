#pragma once
#include "core/manipulator/descend.h"

namespace underact::manipulator {

/// The place of least energy of all.
struct Global {
  Energy at;
  int steps = 0;                // over all starts
  bool is_unique = false;       // false: another place of the tip has the same energy, or no tip was found
  double second_J = kInfinity;  // how much more the next best place of the tip costs
};

/// From a cold start, whatever it takes: descents from a grid over the joints (a fixed sequence from 3 joints on, and
/// the arm's own inverse where the chain has one). For set-up and for lone poses; not for the servo thread. Of
/// equal minima the first found stands. Deterministic. Cost: a closed form, or some hundred descents.
Global leastEnergy(const Manipulator& manipulator, const Pose& X_WT);

}  // namespace underact::manipulator
