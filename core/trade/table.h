#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/trade/choices.h"

namespace underact::trade {

/// One option of one choice, on one scene in one hand.
struct Row {
  std::string scene, hand, choice, option;
  Figures figures;
  bool is_default = false;  // of the scene, or of the program
};

/// A scene by the name of its file.
struct NamedScene {
  std::string name;
  scene::Description scene;  // with its meshes loaded
};
struct NamedHand {
  std::string name;
  sim::HandScript hand;
};

/// What is measured, and how long each run is.
struct Plan {
  std::vector<NamedScene> scenes;
  std::vector<NamedHand> hands;
  std::vector<std::string> choices;  // keys; empty: all
  double seconds = 4.0;
};

/// Called with the fraction that is done; false ends it.
using Progress = std::function<bool(double share)>;

/// Every option of every choice that a scene offers, on each scene and in each hand, except those that a scene cannot
/// run (a missing closed form). Errors are the same each time; times are those of this machine, now.
std::vector<Row> measureRows(const Plan& plan, const Progress& goes_on);

/// One option over all runs.
struct Summary {
  std::string choice, option;
  int runs = 0;
  double p50_ns = 0.0, p99_ns = 0.0;  // medians over the runs
  double cost_us_per_s = 0.0;         // the same, for a second of the servo's
  double error = 0.0;                 // root of the mean square, not exceeded by nine of ten runs, in the choice's unit
  double worst = 0.0;                 // the largest of all
  bool is_default = false;            // of the program
  bool is_recommended = false;
};

/// Costs that differ by less count as equal: the same work scatters by as much from run to run.
inline constexpr double kSameCost = 0.1;

/// In the order of the catalogue. Recommended is, of the options whose error is within the choice's bound and whose
/// cost is within kSameCost of the cheapest of these, the one with the least error, and of equals the first.
std::vector<Summary> summaryOf(const std::vector<Row>& rows);

/// One option of one choice over its rows; nothing is marked. No runs: it has no rows.
Summary summaryOf(const std::vector<Row>& rows, const std::string& choice, const std::string& option);

/// The options marked as recommended by the same rule; of one choice.
void recommend(double bound, std::vector<Summary>& options);

}  // namespace underact::trade
