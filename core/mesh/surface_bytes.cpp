#include "core/mesh/surface_bytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/mesh/tree.h"

namespace underact::mesh {
namespace {

constexpr std::uint64_t kLayout = 0x554d'4553'0000'0003U ^ (sizeof(Node) << 8U);

struct Header {
  std::uint64_t layout = kLayout, corners = 0, faces = 0, nodes = 0, is_closed = 0, is_united = 0;
  std::array<double, 3> origin_M{};
};

/// All lists of a surface, in one place for both directions.
template <class Surface, class List>
void eachList(Surface& surface, List&& list) {
  list(surface.triangles.p_MV);
  list(surface.triangles.faces);
  list(surface.neighbours);
  list(surface.normals_M);
  list(surface.nodes);
}

bool areFinite(const std::vector<Eigen::Vector3f>& vectors) {
  return std::all_of(vectors.begin(), vectors.end(), [](const Eigen::Vector3f& v) { return v.allFinite(); });
}

/// Whether each face has existing corners, and each neighbour is a face that shares the edge, so that a walk around a
/// corner ends. No corner is without a face, and a closed surface has a neighbour at each side: so it has no more
/// corners than its faces allow.
bool areFacesValid(const Surface& surface) {
  const auto corners = static_cast<std::int32_t>(surface.triangles.p_MV.size());
  const auto faces = static_cast<std::int32_t>(surface.triangles.faces.size());
  std::vector<bool> has_face(surface.triangles.p_MV.size(), false);
  for (std::size_t index = 0; index < surface.triangles.faces.size(); ++index) {
    for (std::size_t side = 0; side < 3; ++side) {
      const std::int32_t corner = surface.triangles.faces[index][side], other = surface.neighbours[index][side];
      if (corner < 0 || corner >= corners || other < -1 || other >= faces) return false;
      has_face[static_cast<std::size_t>(corner)] = true;
      if (other < 0 && surface.is_closed) return false;
      if (other < 0) continue;
      const Face& beside = surface.triangles.faces[static_cast<std::size_t>(other)];
      if (std::find(beside.begin(), beside.end(), corner) == beside.end()) return false;
    }
  }
  return std::all_of(has_face.begin(), has_face.end(), [](bool has) { return has; });
}

bool isEmptyBox(const Node& node, std::size_t slot) {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  const auto is = [slot](const auto& axes, float value) {
    return std::all_of(axes.begin(), axes.end(), [&](const auto& of_axis) { return of_axis[slot] == value; });
  };
  return is(node.low_N, kInfinite) && is(node.high_N, -kInfinite);
}

/// Whether each node but the root is the child of one before it, and each face of one node; none deeper than a search
/// has room for. A missing child needs a box that nothing intersects, since a search does not check for children. The
/// numbers of other boxes may be any: they affect what is found, not whether it ends.
bool areNodesValid(const Surface& surface) {
  std::vector<bool> has_node(surface.nodes.size(), false), has_face(surface.triangles.faces.size(), false);
  std::vector<int> depths(surface.nodes.size(), 1);
  const auto nodes = static_cast<std::int32_t>(surface.nodes.size());
  for (std::int32_t index = 0; index < nodes; ++index) {
    const Node& node = surface.nodes[static_cast<std::size_t>(index)];
    const bool is_bottom = node.children[0] < 0;
    bool ended = false;
    std::size_t slot = 0;
    for (const std::int32_t child : node.children) {
      ended |= child == kNoChild;
      if (ended && (child != kNoChild || !isEmptyBox(node, slot))) return false;
      ++slot;
      if (ended) continue;
      if ((child < 0) != is_bottom) return false;
      std::vector<bool>& has = is_bottom ? has_face : has_node;
      const auto place = static_cast<std::size_t>(is_bottom ? -1 - child : child);
      if (place >= has.size() || has[place] || (!is_bottom && child <= index)) return false;
      has[place] = true;
      if (!is_bottom) depths[place] = depths[static_cast<std::size_t>(index)] + 1;
    }
    if (node.children[0] == kNoChild || depths[static_cast<std::size_t>(index)] > kMaxDepth) return false;
  }
  return std::all_of(has_face.begin(), has_face.end(), [](bool has) { return has; });
}

}  // namespace

std::vector<std::byte> surfaceBytes(const Surface& surface) {
  Header header;
  header.corners = surface.triangles.p_MV.size();
  header.faces = surface.triangles.faces.size();
  header.nodes = surface.nodes.size();
  header.is_closed = surface.is_closed ? 1 : 0;
  header.is_united = surface.is_united ? 1 : 0;
  header.origin_M = {surface.origin_M.x(), surface.origin_M.y(), surface.origin_M.z()};
  std::vector<std::byte> bytes;
  bytes.reserve(sizeof header + bytesOf(surface));
  const auto add = [&bytes](const void* data, std::size_t size) {
    const auto* const begin = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
  };
  add(&header, sizeof header);
  eachList(surface, [&](const auto& list) { add(list.data(), list.size() * sizeof(list[0])); });
  return bytes;
}

std::shared_ptr<const Surface> surfaceOfBytes(std::span<const std::byte> bytes) {
  Header header;
  if (bytes.size() < sizeof header) return nullptr;
  std::memcpy(&header, bytes.data(), sizeof header);
  // Counts beyond the number of bytes would overflow below.
  const bool is_likely = header.layout == kLayout && header.is_closed <= 1 && header.is_united <= 1 &&
                         header.faces > 0 && header.nodes > 0 &&
                         std::max({header.corners, header.faces, header.nodes}) <= bytes.size();
  if (!is_likely) return nullptr;
  auto surface = std::make_shared<Surface>();
  std::size_t wanted = sizeof header;
  wanted +=
      header.corners * 2 * sizeof(Eigen::Vector3f) + header.faces * 2 * sizeof(Face) + header.nodes * sizeof(Node);
  if (wanted != bytes.size()) return nullptr;
  surface->triangles.p_MV.resize(header.corners);
  surface->normals_M.resize(header.corners);
  surface->triangles.faces.resize(header.faces);
  surface->neighbours.resize(header.faces);
  surface->nodes.resize(header.nodes);
  surface->is_closed = header.is_closed == 1;
  surface->is_united = header.is_united == 1;
  surface->origin_M = Vec3(header.origin_M.data());
  std::size_t at = sizeof header;
  eachList(*surface, [&](auto& list) {
    std::memcpy(static_cast<void*>(list.data()), bytes.data() + at, list.size() * sizeof(list[0]));
    at += list.size() * sizeof(list[0]);
  });
  const bool is_ok = areFinite(surface->triangles.p_MV) && areFinite(surface->normals_M) &&
                     surface->origin_M.allFinite() && areFacesValid(*surface) && areNodesValid(*surface);
  if (!is_ok || surface->triangles.p_MV.empty()) return nullptr;
  complete(*surface);
  return surface;
}

}  // namespace underact::mesh
