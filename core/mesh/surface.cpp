#include "core/mesh/surface.h"

#include <bit>
#include <string>

#include "core/base/translate.h"
#include "core/mesh/normals.h"
#include "core/mesh/topology.h"
#include "core/mesh/tree.h"

namespace underact::mesh {
namespace {

constexpr std::size_t kMaxFaces = std::size_t{1} << 27U;
constexpr float kLargest = 1e15F;  // units: the square of a distance is a float

Problems whatIsWrong(const Triangles& triangles) {
  if (triangles.faces.empty()) return {{phrase(TRANSLATE_NOOP("problem", "The mesh has no triangles.")), {}}};
  if (triangles.faces.size() > kMaxFaces || triangles.p_MV.size() > 3 * kMaxFaces)
    return {{phrase(TRANSLATE_NOOP("problem", "The mesh has more than 134 million triangles.")), {}}};
  for (const Eigen::Vector3f& corner : triangles.p_MV) {
    if (!(corner.cwiseAbs().maxCoeff() <= kLargest) || !corner.allFinite())
      return {{phrase(TRANSLATE_NOOP("problem", "A vertex of the mesh is not a finite point.")), {}}};
  }
  const auto corners = static_cast<std::int32_t>(triangles.p_MV.size());
  for (const Face& face : triangles.faces) {
    for (const std::int32_t corner : face) {
      if (corner < 0 || corner >= corners)
        return {{phrase(TRANSLATE_NOOP("problem", "A triangle refers to a vertex that does not exist.")), {}}};
    }
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0])
      return {{phrase(TRANSLATE_NOOP("problem", "A triangle has the same vertex twice.")), {}}};
  }
  return {};
}

/// Puts faces in the tree's order, and corners in the order of first use: what is near in space is near in memory.
/// Unused corners are removed.
Triangles inOrder(const Triangles& given, const std::vector<std::int32_t>& order) {
  Triangles triangles;
  triangles.faces.reserve(given.faces.size());
  triangles.p_MV.reserve(given.p_MV.size());
  std::vector<std::int32_t> places(given.p_MV.size(), -1);
  for (const std::int32_t index : order) {
    Face face = given.faces[static_cast<std::size_t>(index)];
    for (std::int32_t& corner : face) {
      std::int32_t& place = places[static_cast<std::size_t>(corner)];
      if (place < 0) {
        place = static_cast<std::int32_t>(triangles.p_MV.size());
        triangles.p_MV.push_back(given.p_MV[static_cast<std::size_t>(corner)]);
      }
      corner = place;
    }
    triangles.faces.push_back(face);
  }
  return triangles;
}

/// A hash of faces and tree. Source of the constants: Vigna 2015, splitmix64.
std::uint64_t markOf(const Surface& surface) {
  const Triangles& triangles = surface.triangles;
  std::uint64_t mark = triangles.p_MV.size();
  const auto add = [&mark](std::uint32_t word) {
    mark = (mark ^ word) * 0xbf58'476d'1ce4'e5b9U;
    mark ^= mark >> 31U;
  };
  for (const Eigen::Vector3f& corner : triangles.p_MV) {
    for (const float x : corner) add(std::bit_cast<std::uint32_t>(x));
  }
  for (const Face& face : triangles.faces) {
    for (const std::int32_t corner : face) add(static_cast<std::uint32_t>(corner));
  }
  for (const Node& node : surface.nodes) {
    for (const std::int32_t child : node.children) add(static_cast<std::uint32_t>(child));
  }
  return mark;
}

}  // namespace

void complete(Surface& surface) {
  surface.mark = markOf(surface);
  surface.low_M = surface.high_M = surface.triangles.p_MV.front();
  for (const Eigen::Vector3f& corner : surface.triangles.p_MV) {
    surface.low_M = surface.low_M.cwiseMin(corner);
    surface.high_M = surface.high_M.cwiseMax(corner);
  }
}

Result<std::shared_ptr<const Surface>> makeSurface(Triangles triangles, const TaskMonitor& monitor,
                                                   const Vec3& origin_M) {
  Problems problems = whatIsWrong(triangles);
  if (!problems.empty()) return problems;
  const Problems cancelled{{phrase(TRANSLATE_NOOP("problem", "Cancelled.")), {}}};
  monitor.report(TRANSLATE_NOOP("step of work", "Building the tree"), 0.0);
  std::optional<Tree> tree = makeTree(triangles, monitor);
  if (!tree) return cancelled;
  auto surface = std::make_shared<Surface>();
  surface->origin_M = origin_M;
  surface->triangles = inOrder(triangles, tree->order);
  triangles = {};
  surface->nodes = std::move(tree->nodes);
  Topology topology = topologyOf(surface->triangles.faces);
  surface->neighbours = std::move(topology.neighbours);
  surface->is_closed = topology.is_closed;
  surface->normals_M = cornerNormals(surface->triangles);
  complete(*surface);
  return std::shared_ptr<const Surface>(std::move(surface));
}

std::shared_ptr<const Surface> withoutInside(const Surface& surface) {
  auto open = std::make_shared<Surface>(surface);
  open->is_closed = false;
  return open;
}

std::shared_ptr<const Surface> asUnited(const Surface& surface) {
  auto united = std::make_shared<Surface>(surface);
  united->is_united = true;
  return united;
}

std::size_t bytesOf(const Surface& surface) {
  const auto bytes = [](const auto& list) { return list.size() * sizeof(list[0]); };
  return sizeof(Surface) + bytes(surface.triangles.p_MV) + bytes(surface.triangles.faces) + bytes(surface.neighbours) +
         bytes(surface.normals_M) + bytes(surface.nodes);
}

}  // namespace underact::mesh
