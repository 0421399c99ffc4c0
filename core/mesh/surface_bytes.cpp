#include "core/mesh/surface_bytes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

namespace underact::mesh {
namespace {

constexpr std::uint64_t kVersion = 1;

struct Head {
  std::uint64_t version = kVersion, node_bytes = sizeof(Node);
  std::uint64_t corners = 0, faces = 0, nodes = 0, is_closed = 0;
  std::array<float, 6> bounds{};
};

template <class T>
void add(const std::vector<T>& list, std::vector<std::byte>& bytes) {
  const std::span<const std::byte> from = std::as_bytes(std::span(list));
  bytes.insert(bytes.end(), from.begin(), from.end());
}

template <class T>
void take(std::uint64_t count, std::span<const std::byte>& bytes, std::vector<T>& list) {
  list.resize(count);
  std::ranges::copy(bytes.first(count * sizeof(T)), std::as_writable_bytes(std::span(list)).begin());
  bytes = bytes.subspan(count * sizeof(T));
}

bool areWithin(const std::vector<Face>& faces, std::int32_t low, std::int32_t end) {
  return std::ranges::all_of(faces, [&](const Face& face) {
    return std::ranges::all_of(face, [&](std::int32_t index) { return index >= low && index < end; });
  });
}

/// Every number names something that is there, and the nodes are a tree: a child stands after its parent.
bool isWhole(const Surface& surface) {
  const auto faces = static_cast<std::int32_t>(surface.triangles.faces.size());
  const auto nodes = static_cast<std::int32_t>(surface.nodes.size());
  if (!areWithin(surface.triangles.faces, 0, static_cast<std::int32_t>(surface.triangles.p_MV.size()))) return false;
  if (!areWithin(surface.neighbours, -1, faces)) return false;
  for (std::int32_t node = 0; node < nodes; ++node) {
    for (const std::int32_t child : surface.nodes[static_cast<std::size_t>(node)].children) {
      if (child == kNoChild) continue;
      if (child < 0 ? -1 - child >= faces : child <= node || child >= nodes) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<std::byte> surfaceBytes(const Surface& surface) {
  Head head;
  head.corners = surface.triangles.p_MV.size();
  head.faces = surface.triangles.faces.size();
  head.nodes = surface.nodes.size();
  head.is_closed = surface.is_closed ? 1 : 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    head.bounds[axis] = surface.low_M[static_cast<Eigen::Index>(axis)];
    head.bounds[axis + 3] = surface.high_M[static_cast<Eigen::Index>(axis)];
  }
  std::vector<std::byte> bytes;
  bytes.reserve(sizeof head + bytesOf(surface));
  const std::span<const std::byte> from = std::as_bytes(std::span(&head, 1));
  bytes.insert(bytes.end(), from.begin(), from.end());
  add(surface.triangles.p_MV, bytes);
  add(surface.triangles.faces, bytes);
  add(surface.neighbours, bytes);
  add(surface.normals_M, bytes);
  add(surface.nodes, bytes);
  return bytes;
}

std::shared_ptr<const Surface> surfaceOfBytes(std::span<const std::byte> bytes) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();
  Head head;
  if (bytes.size() < sizeof head) return nullptr;
  std::memcpy(&head, bytes.data(), sizeof head);
  bytes = bytes.subspan(sizeof head);
  if (head.version != kVersion || head.node_bytes != sizeof(Node)) return nullptr;
  if (head.corners > kMost || head.faces > kMost || head.nodes > kMost || head.faces == 0 || head.nodes == 0) {
    return nullptr;
  }
  if (bytes.size() != head.corners * 24 + head.faces * 24 + head.nodes * sizeof(Node)) return nullptr;
  auto surface = std::make_shared<Surface>();
  take(head.corners, bytes, surface->triangles.p_MV);
  take(head.faces, bytes, surface->triangles.faces);
  take(head.faces, bytes, surface->neighbours);
  take(head.corners, bytes, surface->normals_M);
  take(head.nodes, bytes, surface->nodes);
  surface->is_closed = head.is_closed != 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    surface->low_M[static_cast<Eigen::Index>(axis)] = head.bounds[axis];
    surface->high_M[static_cast<Eigen::Index>(axis)] = head.bounds[axis + 3];
  }
  return isWhole(*surface) ? surface : nullptr;
}

}  // namespace underact::mesh
