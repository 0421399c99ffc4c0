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
  bool is_default = false;  // what the scene says, or the program's own
};

/// A scene by the name of its file.
struct NamedScene {
  std::string name;
  scene::Description scene;  // with its meshes loaded
};
/// A hand by its name.
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

/// Told the share that is done; false ends it.
using Progress = std::function<bool(double share)>;

/// Every option of every choice that a scene offers, on each scene and in each hand, but for what a scene has no way to
/// (a closed form that there is not). Errors are the same each time; times are this machine's, now.
std::vector<Row> measureRows(const Plan& plan, const Progress& goes_on);

/// One option over all runs.
struct Summary {
  std::string choice, option;
  int runs = 0;
  double p50_ns = 0.0, p99_ns = 0.0;  // medians over the runs
  double cost_us_per_s = 0.0;         // the same, for a second of the servo's
  double error = 0.0;       // that nine of ten runs stay within, root of the mean square, in the choice's unit
  double worst = 0.0;       // the largest of all
  bool is_default = false;  // of the program
  bool is_recommended = false;
};

/// Costs that differ by less are the same cost: so much one and the same work scatters from run to run.
inline constexpr double kSameCost = 0.1;

/// In the order of the catalogue. Recommended is, of the options whose error is within the choice's bound and whose
/// cost is within kSameCost of the cheapest of these, the one with the least error, and of equals the first.
std::vector<Summary> summaryOf(const std::vector<Row>& rows);

/// One option of one choice over those of the rows that are of it; nothing marked. No runs: there are none.
Summary summaryOf(const std::vector<Row>& rows, const std::string& choice, const std::string& option);

/// The options marked as recommended by the same rule; of one choice.
void recommend(double bound, std::vector<Summary>& options);

}  // namespace underact::trade
