#pragma once
#include <optional>
#include <vector>

#include "core/trade/run.h"

namespace underact::trade {

/// One thing that a tick can compute, and what it adds to the barest tick of a scene.
struct Quantity {
  const char* key;   // "error_rate"
  const char* what;  // "how fast the error changes (PD)"
  bool required = false;
  std::optional<double> adds_ns;  // none: this scene has no use for it, whatever one asks
};

/// What a scene's tick computes, and what it would cost to compute all there is: medians along the hand's way, ns.
struct Model {
  double bare_ns = 0.0;        // place, targets and P laws alone, in the scene's own space and metric
  double as_it_is_ns = 0.0;    // what the scene requires
  double everything_ns = 0.0;  // all quantities that add something
  std::vector<Quantity> quantities;
};

/// Each program is measured in several rounds in turn with the others, so that a machine that gets slower meanwhile
/// does so for all. Problems: those of the scene.
Result<Model> modelOf(const Bench& bench);

}  // namespace underact::trade
