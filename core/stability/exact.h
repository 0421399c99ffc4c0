#pragma once
#include <optional>

#include "core/stability/wall.h"

namespace underact::stability {

/// The greatest eigenvalue, in size, of what a period makes of all that there is: place, velocity, what the filter
/// remembers, the forces under way. Below 1 all dies out. Exact: the motion between samples by the exponential of its
/// matrix; the Kalman filter with the gains at which it settles. stiffness_N_per_m: K, from 0 on. wall: a linear one.
/// Source: sampled-data control, e.g. Astrom and Wittenmark 1997, chapter 2.
double spectralRadius(const SampledWall& wall, double stiffness_N_per_m);

/// The greatest K, N/m, up to which every smaller one dies out; 0 where the damping alone does not. None: the wall is
/// not linear, or nothing below kMostStiffness swings.
std::optional<double> exactLimit(const SampledWall& wall);

inline constexpr double kMostStiffness_N_per_m = 1e7;

/// The greatest K, N/m, up to which wall and damping together never give any hand more energy than it put in; the mass
/// and the hand have no part in it. 0 where there is none. Friction and steps of the encoders are left out. Exact for a
/// linear wall, its delay and its filter included, on a grid of 2000 frequencies; without both it is 2 (b - |B|) / T.
/// Source: Colgate and Schenkel 1997, theorem 1, which is linear in K.
double passiveLimit(const SampledWall& wall);

/// The two formulas, N/m, 0 where they are below. K < 2 (b - |B|) / T: any passive hand, no delay.
/// Source: Colgate and Schenkel 1997.
double colgateSchenkel(const SampledWall& wall);
/// K < (b + B) / (T / 2 + t_d), for small B and K. Source: Gil, Avello, Rubio and Florez 2004; Hulin, Preusche and
/// Hirzinger 2006.
double gilHulin(const SampledWall& wall);

}  // namespace underact::stability
