#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/trade/run.h"

namespace underact::trade {

/// One option of a choice.
struct Option {
  std::string name;
  std::function<void(Settings&)> choose;
};

/// Cost and error of an option.
struct Figures {
  lab::Cost cost;              // of the part that the choice affects, ns per tick
  double cost_us_per_s = 0.0;  // processor time for a second of the servo's
  double error = 0.0;          // root of the mean square over the run, in the choice's unit
  double worst = 0.0;          // the largest error
};

/// Measures one option, given by its settings, on the bench that this was made for. Problems: the scene does not have
/// this option, a run ended in a fault, or the hand never touches what the choice affects.
using Measure = std::function<Result<Figures>(const Settings& settings)>;

/// A choice that the program offers between speed and accuracy.
struct Choice {
  const char* key;
  const char* question;
  const char* cost;    // what is timed
  const char* error;   // what is compared, and with which oracle
  const char* unit;    // of the error
  double bound;        // the largest permitted root-mean-square error
  const char* reason;  // for the bound
  std::vector<Option> options;
  bool (*applies)(const scene::Description& scene);
  bool (*same)(const Settings& a, const Settings& b);  // in what this choice affects
  /// For one bench. Computes once what all options are compared with. base: the settings that they have in common, all
  /// except those that the choice affects.
  Measure (*measureOn)(const Bench& bench, const Settings& base);
};

/// rate, simulation, search, solver, steps, velocity, inverse, blocks. Of float or double nothing offers a
/// choice: a mesh's boxes are bounded in floats with a proved margin, and the answer is the same to the bit.
std::span<const Choice> choices();

/// The index among the choice's options of the one in the settings; none: it is not among them.
std::optional<std::size_t> optionOf(const Choice& choice, const Settings& settings);

}  // namespace underact::trade
