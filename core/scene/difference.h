#pragma once
#include <string>
#include <vector>

#include "core/scene/description.h"

namespace underact::scene {

/// A value that two scenes do not share, as their files would say it.
struct Difference {
  std::string key;         // "control.kp_N_per_mm"; of a constraint its name goes first: "ball.radius_mm"
  std::string one, other;  // as in a file; empty: the key is left out there
  bool operator==(const Difference&) const = default;
};

/// What the files of the two would say otherwise, in the order of the first; titles and what is said about them do not
/// count. Empty: they feel the same.
std::vector<Difference> differencesBetween(const Description& one, const Description& other);

}  // namespace underact::scene
