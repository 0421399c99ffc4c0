#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/tradeoff/choices.h"

namespace underact::tradeoff {

/// The result for one option of one choice, with one scene and one hand.
struct TradeoffRow {
  std::string scene, hand, choice, option;
  Figures figures;
  bool is_default = false;  // the scene's own value, or the program's default
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

/// Measures every option of every choice, for each scene and each hand, except options that a scene does not have (a
/// closed form that does not exist). Errors are reproducible; times are of this machine.
std::vector<TradeoffRow> measureRows(const Plan& plan, const Progress& goes_on);

/// The result for one option over all runs.
struct Summary {
  std::string choice, option;
  int runs = 0;
  double p50_ns = 0.0, p99_ns = 0.0;  // medians over the runs
  double cost_us_per_s = 0.0;         // the same, for a second of the servo's
  double error = 0.0;                 // 90th percentile over the runs, root mean square, in the choice's unit
  double worst = 0.0;                 // the largest of all
  std::string scene = {}, hand = {};  // of the run that has this error: it alone gives the error again
  bool is_default = false;            // of the program
  bool is_recommended = false;
};

/// Costs that differ by less count as equal: the scatter of the same work between runs.
inline constexpr double kSameCost = 0.1;

/// The summaries, in the order of the catalogue. Of the options whose error is within the choice's bound and whose cost
/// is within kSameCost of the cheapest of these, the one with the least error is recommended, of equals the first.
std::vector<Summary> summaryOf(const std::vector<TradeoffRow>& rows);

/// The summary of one option of one choice over its rows, not marked. runs is 0 where there are none.
Summary summaryOf(const std::vector<TradeoffRow>& rows, const std::string& choice, const std::string& option);

/// Marks the recommended option of one choice, by the same rule.
void recommend(double bound, std::vector<Summary>& options);

}  // namespace underact::tradeoff
