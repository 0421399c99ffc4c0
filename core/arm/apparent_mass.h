#pragma once
#include "core/arm/model.h"

namespace underact::arm {

/// The mass, kg, that a hand feels at the tip of an arm with the masses of its file: the mean over all directions of
/// the mass against a push there, with joints 1 to 3 free, the others held, and the tip in the middle of the workspace:
/// trace(J_p^-T M J_p^-1) / 3, M the inertia in these joints. 0: the file has no masses, the arm has not
/// omniGeometry(), or the place is singular. Not for the servo thread. Source: Khatib 1987, eq. 25.
double apparentMass_kg(const Model& model);

}  // namespace underact::arm
