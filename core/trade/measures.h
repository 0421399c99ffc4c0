#pragma once
#include "core/trade/choices.h"

namespace underact::trade {

// Inside the room: how each choice is measured.
Result<Figures> measureRate(const Bench& bench, const Settings& settings);
Result<Figures> measureSimulation(const Bench& bench, const Settings& settings);
Result<Figures> measureSearch(const Bench& bench, const Settings& settings);
Result<Figures> measureSolver(const Bench& bench, const Settings& settings);
Result<Figures> measureVelocity(const Bench& bench, const Settings& settings);
Result<Figures> measureInverse(const Bench& bench, const Settings& settings);
Result<Figures> measureBlocks(const Bench& bench, const Settings& settings);

}  // namespace underact::trade
