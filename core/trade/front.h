#pragma once
#include <vector>

#include "core/trade/table.h"

namespace underact::trade {

/// One way to run a scene, whole.
struct Point {
  Settings settings;
  double cost_us_per_s = 0.0;  // processor time of tick and simulated arm for a second, medians
  // Root of the mean square over a run, the median over the hands: where a robot has two minima that are as good, one
  // hand may come to the other one than the oracle, and says nothing of accuracy.
  double error_mm = 0.0;  // of the tip's way in the loop
  double error_N = 0.0;   // of the force
  bool is_own = false;    // as the scene and the servo are now
  bool on_front = false;  // nothing is both cheaper and more exact
};

/// The ways that are tried: each rate with each way to integrate the arm, and with each search, solver and filter that
/// the scene has use for; and its own at the servo's rate.
std::vector<Settings> waysOf(const scene::Description& scene, int rate_hz);

/// All ways that can be run without a fault, the cheapest first. Errors are against a run at 16 kHz with exact angles,
/// the finest integration, the global search and a solver that goes on to the last bit; none where that one ends in a
/// fault in any of the hands. rate_hz: of the servo now.
std::vector<Point> measurePoints(const scene::Description& scene, const std::vector<NamedHand>& hands, double seconds,
                                 int rate_hz, const Progress& goes_on);

/// Marks the points that no other one beats in both.
void markFront(std::vector<Point>& points);

}  // namespace underact::trade
