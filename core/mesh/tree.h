#pragma once
#include <optional>
#include <vector>

#include "core/base/task_monitor.h"
#include "core/mesh/node.h"
#include "core/mesh/triangles.h"

namespace underact::mesh {

/// A tree of boxes over faces: each node has up to eight children, each leaf up to eight faces in a row.
struct Tree {
  std::vector<std::int32_t> order;  // index in the tree -> face as it was given
  std::vector<Node> nodes;          // the root first; their faces are numbered in the new order
};

/// Split at the median of the longest extent, three times a node, so that the tree is balanced for any mesh. Empty
/// where it was cancelled.
std::optional<Tree> makeTree(const Triangles& triangles, const TaskMonitor& monitor);

/// The greatest depth with 2^27 faces: a leaf holds 8, each node above halves three times, except for the lowest.
inline constexpr int kMaxDepth = 10;

}  // namespace underact::mesh
