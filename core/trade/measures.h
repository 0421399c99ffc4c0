#pragma once
#include "core/trade/choices.h"

namespace underact::trade {

// Inside the room: how each choice is measured.
Measure rateOn(const Bench& bench, const Settings& base);
Measure simulationOn(const Bench& bench, const Settings& base);
Measure searchOn(const Bench& bench, const Settings& base);
Measure solverOn(const Bench& bench, const Settings& base);
Measure velocityOn(const Bench& bench, const Settings& base);
Measure inverseOn(const Bench& bench, const Settings& base);
Measure blocksOn(const Bench& bench, const Settings& base);

// What others are held against: so fine that what is left of its own error does not show.
inline constexpr int kOracleRate_hz = 16'000;  // a multiple of every rate that is an option
inline constexpr double kOracleSubstep_us = 5.0;
inline const scene::Solver kOracleSolver{scene::SolverMethod::Iterative, 100, 1e-14};

inline constexpr int kFewestBlocks = 10;  // of a recording, however short the run

/// One option to be measured, and the settings with which it is run.
struct Entry {
  std::string name;
  Settings settings;
};

/// Measures each entry on one bench, in order, and hands on those that there is a way to. goes_on() is asked before
/// each; false: it ended it.
bool measureEach(const Choice& choice, const Bench& bench, const Settings& base, const std::vector<Entry>& entries,
                 const std::function<bool()>& goes_on,
                 const std::function<void(const Entry& entry, const Figures& figures)>& add);

}  // namespace underact::trade
