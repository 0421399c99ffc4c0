#pragma once
#include <optional>

#include "core/stability/wall.h"

namespace underact::stability {

/// The spectral radius of the map over one period of the whole state: position, velocity, filter state and delayed
/// forces. Below 1 every motion decays. Exact: the motion between samples by the matrix exponential; the Kalman filter
/// with its steady-state gains. stiffness_N_per_m: K, from 0 on. wall: a linear one.
/// Source: sampled-data control, e.g. Astrom and Wittenmark 1997, chapter 2.
double spectralRadius(const SampledWall& wall, double stiffness_N_per_m);

/// The greatest K, N/m, such that all up to it are stable; 0 where the damping alone is not. None: the wall is not
/// linear, or nothing below kMaxStiffness is unstable.
std::optional<double> exactLimit(const SampledWall& wall);

inline constexpr double kMaxStiffness_N_per_m = 1e7;

/// The greatest K, N/m, up to which wall and damping together never give any hand more energy than it put in; mass and
/// hand do not matter. 0 where there is none. Friction and encoder steps are ignored. Exact for a linear wall with its
/// delay and filter, on a grid of 2000 frequencies; without both it is 2 (b - |B|) / T.
/// Source: Colgate and Schenkel 1997, theorem 1, which is linear in K.
double passiveLimit(const SampledWall& wall);

/// Two closed formulas, N/m, 0 where they are negative. K < 2 (b - |B|) / T: any passive hand, no delay.
/// Source: Colgate and Schenkel 1997.
double colgateSchenkel(const SampledWall& wall);
/// K < (b + B) / (T / 2 + t_d), for small B and K. Source: Gil, Avello, Rubio and Florez 2004; Hulin, Preusche and
/// Hirzinger 2006.
double gilHulin(const SampledWall& wall);

}  // namespace underact::stability
