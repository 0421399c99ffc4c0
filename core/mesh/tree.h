#pragma once
#include <optional>
#include <vector>

#include "core/base/watch.h"
#include "core/mesh/node.h"
#include "core/mesh/triangles.h"

namespace underact::mesh {

/// A tree of boxes over faces: each node has up to eight children, each bottom node up to eight faces in a row.
struct Tree {
  std::vector<std::int32_t> order;  // place in the tree -> face as it was given
  std::vector<Node> nodes;          // the root first; their faces are numbered in the new order
};

/// Split at the median of the longest extent, three times a node, so that its depth is that of a balanced tree for any
/// mesh. Empty where it was cancelled.
std::optional<Tree> makeTree(const Triangles& triangles, const Watch& watch);

/// How many nodes there are from the root down, at most, with 2^27 faces: a bottom node holds 8, each node above halves
/// three times, but for the lowest of them.
inline constexpr int kMostDepth = 10;

}  // namespace underact::mesh
