#pragma once
#include <optional>
#include <vector>

#include "core/trade/run.h"

namespace underact::trade {

/// A quantity that a tick can compute, and what it adds to the minimal tick of a scene.
struct Quantity {
  const char* key;   // "error_rate"
  const char* what;  // "the rate of the error (PD)"
  bool required = false;
  std::optional<double> adds_ns;  // none: this scene can never use it
};

/// What a scene's tick computes, and what it would cost to compute everything: medians along the path of the hand, ns.
struct Model {
  double bare_ns = 0.0;        // position, targets and P laws alone, in the scene's own space and metric
  double as_it_is_ns = 0.0;    // what the scene requires
  double everything_ns = 0.0;  // all quantities that add something
  std::vector<Quantity> quantities;
};

/// The programs are measured in turn, in several rounds, so that a machine that becomes slower meanwhile affects all
/// alike. Problems: those of the scene.
Result<Model> modelOf(const Bench& bench);

}  // namespace underact::trade
