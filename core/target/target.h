#pragma once
#include <cstdint>

#include "core/base/types.h"

namespace underact::target {

/// Both: the stylus is held to the surface. Outside, Inside: the side on which it is free; a wall pushes it back there.
enum class Side : std::uint8_t { Both, Outside, Inside };

/// Free: an untouched wall. Degenerate: several points are equally near, so there is no direction for a force.
enum class Status : std::uint8_t { Unique, Degenerate, Free };

/// The target of a constraint in this tick.
struct Target {
  Vec3 p_WP = Vec3::Zero();  // m; the tip itself unless Unique, so that the error is zero
  Status status = Status::Degenerate;
  double distance_m = 0.0;  // from the shape, in W (Degenerate and weighted: in the metric); 0 for a free wall
};

/// "unique", "degenerate", "free": as on the command line.
const char* name(Status status);

}  // namespace underact::target
