#include "core/mesh_file/edges.h"

#include <algorithm>
#include <tuple>

#include "core/mesh_file/steps.h"

namespace underact::mesh_file {
namespace {

struct Entry {
  std::int32_t high;  // the greater corner of the edge
  Side side;
};

/// All sides: those with the same lesser corner in a row, ordered by the greater one and by themselves.
struct Sorted {
  std::vector<std::int32_t> begin;  // of each lesser corner; one more at the end
  std::vector<Entry> entries;
};

Sorted sorted(const mesh::Triangles& triangles) {
  const auto sides = static_cast<Side>(3 * triangles.faces.size());
  Sorted all;
  all.begin.assign(triangles.p_MV.size() + 1, 0);
  all.entries.resize(static_cast<std::size_t>(sides));
  const auto low = [&](Side side) { return std::min(startOf(triangles, side), endOf(triangles, side)); };
  for (Side side = 0; side < sides; ++side) ++all.begin[static_cast<std::size_t>(low(side)) + 1];
  for (std::size_t corner = 0; corner + 1 < all.begin.size(); ++corner) all.begin[corner + 1] += all.begin[corner];
  std::vector<std::int32_t> next = all.begin;
  for (Side side = 0; side < sides; ++side) {
    const std::int32_t high = std::max(startOf(triangles, side), endOf(triangles, side));
    all.entries[static_cast<std::size_t>(next[static_cast<std::size_t>(low(side))]++)] = {high, side};
  }
  return all;
}

/// Joins the sides of one edge, from first to last.
void join(const Entry* first, const Entry* last, Edges& edges) {
  const auto across = [&](const Entry* entry) -> Side& { return edges.across[static_cast<std::size_t>(entry->side)]; };
  const auto count = last - first;
  if (count == 1) {
    across(first) = kBorder;
    ++edges.borders;
  } else if (count == 2) {
    across(first) = first[1].side;
    across(first + 1) = first[0].side;
  } else {
    for (const Entry* entry = first; entry != last; ++entry) across(entry) = kCrowded;
    ++edges.crowded;
  }
}

}  // namespace

std::optional<Edges> edgesOf(const mesh::Triangles& triangles, const TaskMonitor& monitor) {
  Edges edges;
  edges.across.assign(3 * triangles.faces.size(), kBorder);
  Sorted all = sorted(triangles);
  Steps steps(monitor);
  for (std::size_t corner = 0; corner + 1 < all.begin.size(); ++corner) {
    if (steps.isCancelled()) return {};
    Entry* begin = all.entries.data() + all.begin[corner];
    Entry* end = all.entries.data() + all.begin[corner + 1];
    std::sort(begin, end,
              [](const Entry& a, const Entry& b) { return std::tie(a.high, a.side) < std::tie(b.high, b.side); });
    while (begin != end) {
      const Entry* first = begin;
      while (begin != end && begin->high == first->high) ++begin;
      join(first, begin, edges);
    }
  }
  return edges;
}

}  // namespace underact::mesh_file
