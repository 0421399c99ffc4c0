#include "core/mesh/topology.h"

#include <algorithm>

namespace underact::mesh {
namespace {

struct HalfEdge {
  std::uint64_t edge;  // both corners, the smaller one first
  std::int32_t face;
  std::int8_t side;  // 0 AB, 1 BC, 2 CA
  bool forward;      // from the smaller corner to the larger
};

std::vector<HalfEdge> halfEdgesOf(const std::vector<Face>& faces) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * faces.size());
  for (std::size_t face = 0; face < faces.size(); ++face) {
    for (std::size_t side = 0; side < 3; ++side) {
      const auto from = static_cast<std::uint32_t>(faces[face][side]);
      const auto to = static_cast<std::uint32_t>(faces[face][(side + 1) % 3]);
      const std::uint64_t edge = (std::uint64_t{std::min(from, to)} << 32U) | std::max(from, to);
      edges.push_back({edge, static_cast<std::int32_t>(face), static_cast<std::int8_t>(side), from < to});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const HalfEdge& a, const HalfEdge& b) { return a.edge != b.edge ? a.edge < b.edge : a.face < b.face; });
  return edges;
}

}  // namespace

Topology topologyOf(const std::vector<Face>& faces) {
  const std::vector<HalfEdge> edges = halfEdgesOf(faces);
  Topology topology{std::vector<Face>(faces.size(), Face{-1, -1, -1}), !faces.empty()};
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].edge == edges[begin].edge) ++end;
    const HalfEdge& one = edges[begin];
    if (end - begin == 2 && one.forward != edges[begin + 1].forward) {
      const HalfEdge& other = edges[begin + 1];
      topology.neighbours[static_cast<std::size_t>(one.face)][static_cast<std::size_t>(one.side)] = other.face;
      topology.neighbours[static_cast<std::size_t>(other.face)][static_cast<std::size_t>(other.side)] = one.face;
    } else {
      topology.is_closed = false;
    }
    begin = end;
  }
  return topology;
}

}  // namespace underact::mesh
