#pragma once
#include <string>
#include <vector>

#include "core/scene/description.h"

namespace underact::scene {

/// A value in which two scenes differ, as their files would write it.
struct Difference {
  std::string key;         // "control.kp_N_per_mm"; for a constraint its name comes first: "ball.radius_mm"
  std::string one, other;  // as in a file; empty: the key is left out there
  bool operator==(const Difference&) const = default;
};

/// What the files of the two scenes would state differently, in the order of the first; titles and descriptions do not
/// count. Empty: they feel the same.
std::vector<Difference> differencesBetween(const Description& one, const Description& other);

}  // namespace underact::scene
