#include "core/mesh_file/duplicates.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace underact::mesh_file {
namespace {

/// A face by its corners in order, and its place.
struct Key {
  std::uint64_t low_and_middle;
  std::int32_t high, face;
  friend bool operator<(const Key& a, const Key& b) {
    return std::tie(a.low_and_middle, a.high, a.face) < std::tie(b.low_and_middle, b.high, b.face);
  }
};

bool haveSameCorners(const Key& a, const Key& b) {
  return a.low_and_middle == b.low_and_middle && a.high == b.high;
}

std::vector<Key> keysOf(const mesh::Triangles& triangles) {
  std::vector<Key> keys(triangles.faces.size());
  for (std::size_t face = 0; face < keys.size(); ++face) {
    mesh::Face sorted = triangles.faces[face];
    std::sort(sorted.begin(), sorted.end());
    keys[face] = {static_cast<std::uint64_t>(sorted[0]) << 32U | static_cast<std::uint64_t>(sorted[1]), sorted[2],
                  static_cast<std::int32_t>(face)};
  }
  return keys;
}

/// Sorts in blocks that are merged, so that cancelling need not wait for all of it. false: cancelled.
bool sortKeys(std::vector<Key>& keys, const TaskMonitor& monitor) {
  constexpr std::size_t kBlock = std::size_t{1} << 18;
  const auto at = [&keys](std::size_t place) {
    return keys.begin() + static_cast<std::ptrdiff_t>(std::min(place, keys.size()));
  };
  for (std::size_t from = 0; from < keys.size(); from += kBlock) {
    if (monitor.isCancelled()) return false;
    std::sort(at(from), at(from + kBlock));
  }
  for (std::size_t width = kBlock; width < keys.size(); width *= 2) {
    for (std::size_t from = 0; from + width < keys.size(); from += 2 * width) {
      if (monitor.isCancelled()) return false;
      std::inplace_merge(at(from), at(from + width), at(from + 2 * width));
    }
  }
  return true;
}

}  // namespace

std::optional<std::vector<mesh::Face>> dropDuplicates(mesh::Triangles& triangles, const TaskMonitor& monitor) {
  std::vector<Key> keys = keysOf(triangles);
  if (!sortKeys(keys, monitor)) return {};
  std::vector<std::uint8_t> is_twice(keys.size(), 0);
  for (std::size_t k = 1; k < keys.size(); ++k) {
    if (haveSameCorners(keys[k - 1], keys[k])) is_twice[static_cast<std::size_t>(keys[k].face)] = 1;
  }
  std::size_t kept = 0;
  std::vector<mesh::Face> twice;
  for (std::size_t face = 0; face < keys.size(); ++face) {
    if (is_twice[face] == 0) {
      triangles.faces[kept++] = triangles.faces[face];
    } else {
      twice.push_back(triangles.faces[face]);
    }
  }
  triangles.faces.resize(kept);
  return twice;
}

}  // namespace underact::mesh_file
