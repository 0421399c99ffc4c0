#pragma once
#include <optional>
#include <vector>

#include "core/tradeoff/run.h"

namespace underact::tradeoff {

/// A quantity that a tick can compute, and what it adds to a minimal tick of a scene.
struct Quantity {
  const char* key;   // "error_rate"
  const char* what;  // "how fast the error changes (PD)"
  bool required = false;
  std::optional<double> adds_ns;  // none: not applicable to this scene
};

/// The cost of a scene's tick as it is and with all quantities: medians along the hand's path, ns.
struct Model {
  double bare_ns = 0.0;        // tip position, targets and P laws alone, in the scene's space and metric
  double as_it_is_ns = 0.0;    // what the scene requires
  double everything_ns = 0.0;  // all quantities that add something
  std::vector<Quantity> quantities;
};

/// Measures it. The programs alternate in several rounds, so that a machine that slows down affects all of them.
/// Problems: those of the scene.
Result<Model> modelOf(const Bench& bench);

}  // namespace underact::tradeoff
