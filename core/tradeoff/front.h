#pragma once
#include <vector>

#include "core/tradeoff/table.h"

namespace underact::tradeoff {

/// One set of settings for a scene, and its cost and error.
struct Point {
  Settings settings;
  double cost_us_per_s = 0.0;  // processor time of tick and simulated arm for a second, medians
  // Root mean square over a run, median over the hands: where a robot has two equal minima, one hand may end in another
  // one than the reference, which says nothing about accuracy.
  double error_mm = 0.0;  // of the tip in the loop
  double error_N = 0.0;   // of the force
  bool is_own = false;    // the present settings of scene and servo
  bool on_front = false;  // Pareto-optimal: no other point is both cheaper and more accurate
};

/// The settings that are tried: each rate with three substeps of the arm, and with each search, solver and filter that
/// the scene uses; and the scene's own at the servo's rate.
std::vector<Settings> settingsToTry(const scene::Description& scene, int rate_hz);

/// The results for all settings that run without a fault, the cheapest first. Errors are against a run at 16 kHz with
/// exact angles, the finest integration, the global search and a solver that iterates to the last bit; none where that
/// run ends in a fault with any of the hands. rate_hz: of the servo now.
std::vector<Point> measurePoints(const scene::Description& scene, const std::vector<NamedHand>& hands, double seconds,
                                 int rate_hz, const Progress& goes_on);

/// Marks the Pareto-optimal points.
void markFront(std::vector<Point>& points);

}  // namespace underact::tradeoff
