#pragma once
#include "core/tradeoff/choices.h"

namespace underact::tradeoff {

// Inside the room: how each choice is measured.
Measure rateOn(const Bench& bench, const Settings& base);
Measure simulationOn(const Bench& bench, const Settings& base);
Measure searchOn(const Bench& bench, const Settings& base);
Measure solverOn(const Bench& bench, const Settings& base);
Measure velocityOn(const Bench& bench, const Settings& base);
Measure inverseOn(const Bench& bench, const Settings& base);
Measure blocksOn(const Bench& bench, const Settings& base);

// The references of the measurements: so fine that their own error is negligible.
inline constexpr int kOracleRate_hz = 16'000;  // a multiple of every rate that is an option
inline constexpr double kOracleSubstep_us = 5.0;
inline const scene::Solver kOracleSolver{scene::SolverMethod::Iterative, 100, 1e-14};

inline constexpr int kFewestBlocks = 10;  // of a recording, however short the run

/// One option to be measured, and its settings.
struct Entry {
  std::string name;
  Settings settings;
};

/// Measures each entry on one bench, in order, and passes on those that can be run. goes_on() is asked before each;
/// false ends it, and is returned.
bool measureEach(const Choice& choice, const Bench& bench, const Settings& base, const std::vector<Entry>& entries,
                 const std::function<bool()>& goes_on,
                 const std::function<void(const Entry& entry, const Figures& figures)>& add);

}  // namespace underact::tradeoff
