#pragma once
#include "core/extremes/input.h"
#include "core/manipulator/manipulator.h"

namespace underact::extremes {

// What rows that ask virtual robots draw.

/// 1 to 8 joints of any kind, 2^-size to 2^size m; orientation none, axis or full.
manipulator::Manipulator drawManipulator(Input& input, int size = 40);
/// One or two joints with a closed form, with and without limits.
manipulator::Manipulator drawClosedManipulator(Input& input);
/// A stylus beside it, or far.
Pose drawStylus(Input& input, const manipulator::Manipulator& m);
manipulator::Values drawTheta(Input& input, const manipulator::Manipulator& m);

}  // namespace underact::extremes
