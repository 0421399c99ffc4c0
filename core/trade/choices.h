#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/trade/run.h"

namespace underact::trade {

/// One way out of a choice.
struct Option {
  std::string name;
  /// Sets this option, and leaves all else as it is.
  std::function<void(Settings&)> choose;
};

/// What an option costs and how far it is off.
struct Figures {
  lab::Cost cost;              // of what the choice is about, ns; for each tick
  double cost_us_per_s = 0.0;  // processor time for a second of the servo's
  double error = 0.0;          // root of the mean square over the run, in the choice's unit
  double worst = 0.0;          // the largest of it
};

/// One option, as its settings say it, on the bench that this was made for. Problems: the scene has no such way, a run
/// ended in a fault, or the hand never touches what the choice is about.
using Measure = std::function<Result<Figures>(const Settings& settings)>;

/// A choice that the program offers between speed and accuracy.
struct Choice {
  const char* key;
  const char* question;
  const char* cost;    // what is timed
  const char* error;   // what it is off by, and from which oracle
  const char* unit;    // of the error
  double bound;        // the largest error, root of the mean square, that is borne
  const char* reason;  // for the bound
  std::vector<Option> options;
  /// Whether the scene has what the choice is about.
  bool (*applies)(const scene::Description& scene);
  bool (*same)(const Settings& a, const Settings& b);  // in what this choice is about
  /// For one bench. What all options are held against is computed here, once. base: what they have in common, all but
  /// what the choice is about.
  Measure (*measureOn)(const Bench& bench, const Settings& base);
};

/// rate, simulation, search, solver, steps, velocity, inverse, blocks. Of float or double nothing offers a
/// choice: a mesh's boxes are bounded in floats with a proved margin, and the answer is the same to the bit.
std::span<const Choice> choices();

/// The place among the choice's options of the one that settings name; none: another.
std::optional<std::size_t> optionOf(const Choice& choice, const Settings& settings);

}  // namespace underact::trade
