#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/node.h"

namespace underact::mesh {

/// Lays the node's frame along the corners (their mean and principal axes) and its boxes around them: box k around
/// corners begins[k] to before begins[k + 1], widened by more than the rounding of boundsOf().
void setBoxes(const std::vector<Eigen::Vector3f>& corners, const std::array<std::size_t, kChildren + 1>& begins,
              Node& node);

}  // namespace underact::mesh
