#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/tradeoff/run.h"

namespace underact::tradeoff {

/// One option of a choice.
struct Option {
  std::string name;
  /// Sets this option, and leaves all else as it is.
  std::function<void(Settings&)> choose;
};

/// Cost and error of an option.
struct Figures {
  lab::Cost cost;              // of what the choice is about, ns; for each tick
  double cost_us_per_s = 0.0;  // processor time for a second of the servo's
  double error = 0.0;          // root of the mean square over the run, in the choice's unit
  double worst = 0.0;          // the largest error
};

/// Measures the option that the settings have, on the bench for which this was made. Problems: the scene has no such
/// option, a run ended in a fault, or the hand never touches what the choice is about.
using Measure = std::function<Result<Figures>(const Settings& settings)>;

/// A choice that the program offers between speed and accuracy.
struct Choice {
  const char* key;
  const char* question;
  const char* cost;    // what is timed
  const char* error;   // the error, and the reference it is measured against
  const char* unit;    // of the error
  double bound;        // the largest acceptable error, root mean square
  const char* reason;  // for the bound
  std::vector<Option> options;
  /// Whether the scene has what the choice is about.
  bool (*applies)(const scene::Description& scene);
  bool (*same)(const Settings& a, const Settings& b);  // in what this choice is about
  /// Prepares a measurement on one bench; the reference for all options is computed here, once. base: the settings
  /// common to all options.
  Measure (*measureOn)(const Bench& bench, const Settings& base);
};

/// rate, simulation, search, solver, steps, velocity, inverse, blocks. There is no choice between float and double: a
/// mesh's boxes are bounded in floats with a proved margin, and the result is the same to the bit.
std::span<const Choice> choices();

/// The index of the option that the settings have; none: another value.
std::optional<std::size_t> optionOf(const Choice& choice, const Settings& settings);

}  // namespace underact::tradeoff
