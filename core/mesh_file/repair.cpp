#include "core/mesh_file/repair.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/mesh_file/crossings.h"
#include "core/mesh_file/duplicates.h"
#include "core/mesh_file/edges.h"
#include "core/mesh_file/limits.h"
#include "core/mesh_file/parts.h"
#include "core/mesh_file/seams.h"
#include "core/mesh_file/weld.h"

namespace underact::mesh_file {
namespace {

using mesh::Face;
using mesh::Triangles;

bool isFinite(const Eigen::Vector3f& p) {
  return std::abs(p.x()) < kBeyondAll && std::abs(p.y()) < kBeyondAll && std::abs(p.z()) < kBeyondAll;
}

/// Removes faces with corners that are missing or not finite, and unused corners.
void dropUnusable(Triangles& triangles, Facts& facts) {
  const auto count = static_cast<std::int64_t>(triangles.p_MV.size());
  std::erase_if(triangles.faces, [&](const Face& face) {
    const bool is_there = std::all_of(face.begin(), face.end(), [count](auto k) { return k >= 0 && k < count; });
    facts.out_of_range += is_there ? 0 : 1;
    if (!is_there) return true;
    const bool finite = std::all_of(face.begin(), face.end(),
                                    [&](auto k) { return isFinite(triangles.p_MV[static_cast<std::size_t>(k)]); });
    facts.not_finite += finite ? 0 : 1;
    return !finite;
  });
}

/// Puts corners in the order of their first use, and removes unused ones. also: faces without a corner of their own.
void compact(Triangles& triangles, std::vector<Face>* also = nullptr) {
  std::vector<std::int32_t> now(triangles.p_MV.size(), -1);
  std::vector<Eigen::Vector3f> p_MV;
  for (Face& face : triangles.faces) {
    for (std::int32_t& corner : face) {
      std::int32_t& place = now[static_cast<std::size_t>(corner)];
      if (place < 0) {
        place = static_cast<std::int32_t>(p_MV.size());
        p_MV.push_back(triangles.p_MV[static_cast<std::size_t>(corner)]);
      }
      corner = place;
    }
  }
  triangles.p_MV = std::move(p_MV);
  if (also == nullptr) return;
  for (Face& face : *also) {
    for (std::int32_t& corner : face) corner = now[static_cast<std::size_t>(corner)];
  }
}

void setBounds(const Triangles& triangles, Facts& facts) {
  if (triangles.p_MV.empty()) return;
  Eigen::Vector3f low = triangles.p_MV[0], high = low;
  for (const Eigen::Vector3f& p_MV : triangles.p_MV) {
    low = low.cwiseMin(p_MV);
    high = high.cwiseMax(p_MV);
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    facts.low[static_cast<std::size_t>(axis)] = low[axis];
    facts.high[static_cast<std::size_t>(axis)] = high[axis];
  }
}

bool weldAll(Triangles& triangles, Facts& facts, const TaskMonitor& monitor) {
  const Eigen::Map<const Vec3> low(facts.low.data()), high(facts.high.data());
  facts.weld_tolerance = kWeldShare * (high - low).norm();
  const auto firsts = weld(triangles.p_MV, facts.weld_tolerance, monitor);
  if (!firsts) return false;
  for (std::size_t corner = 0; corner < firsts->size(); ++corner) {
    facts.welded += (*firsts)[corner] == static_cast<std::int32_t>(corner) ? 0 : 1;
  }
  for (Face& face : triangles.faces) {
    for (std::int32_t& corner : face) corner = (*firsts)[static_cast<std::size_t>(corner)];
  }
  return true;
}

/// Removes faces with fewer than three different corners. One with three different collinear corners stays: it may
/// connect two others, and the nearest point on it is well defined.
void dropEmpty(Triangles& triangles, Facts& facts) {
  const auto before = triangles.faces.size();
  std::erase_if(triangles.faces, [](const Face& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; });
  facts.without_extent += static_cast<std::int64_t>(before - triangles.faces.size());
}

void turnFaces(Triangles& triangles, const Parts& parts, Facts& facts) {
  for (std::size_t face = 0; face < triangles.faces.size(); ++face) {
    const Part& part = parts.parts[static_cast<std::size_t>(parts.part_of[face])];
    if ((parts.is_against[face] != 0) == part.is_turned_over) continue;
    std::swap(triangles.faces[face][1], triangles.faces[face][2]);
    ++facts.turned;
  }
}

void describeParts(const Parts& parts, Facts& facts) {
  facts.parts = static_cast<std::int64_t>(parts.parts.size());
  facts.clashing_edges = parts.clashes;
  for (const Part& part : parts.parts) {
    facts.area += part.area;
    if (!isClosed(part)) continue;
    ++facts.closed_parts;
    const double volume = part.is_turned_over ? -part.volume : part.volume;
    facts.nested_parts += part.is_nested ? 1 : 0;
    facts.hollows += part.is_nested && volume < 0.0 ? 1 : 0;
    facts.volume += volume;
    const double thickness = part.area > 0.0 ? 2.0 * std::abs(part.volume) / part.area : 0.0;
    if (facts.thinnest == 0.0 || thickness < facts.thinnest) facts.thinnest = thickness;
  }
}

/// Counts the connected borders, each a hole or the rim of an open surface, and measures the longest of them.
void describeBorders(const Triangles& triangles, const Edges& edges, Facts& facts) {
  std::vector<std::int32_t> leader(triangles.p_MV.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto lead = [&leader](std::int32_t corner) {
    auto k = static_cast<std::size_t>(corner);
    while (leader[k] != static_cast<std::int32_t>(k)) {
      leader[k] = leader[static_cast<std::size_t>(leader[k])];
      k = static_cast<std::size_t>(leader[k]);
    }
    return static_cast<std::int32_t>(k);
  };
  const auto each = [&](const auto& visit) {
    for (std::size_t side = 0; side < edges.across.size(); ++side) {
      if (edges.across[side] == kBorder) visit(static_cast<Side>(side));
    }
  };
  each([&](Side side) {
    const std::int32_t a = lead(startOf(triangles, side)), b = lead(endOf(triangles, side));
    leader[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  });
  std::vector<double> length(triangles.p_MV.size(), -1.0);
  each([&](Side side) {
    double& sum = length[static_cast<std::size_t>(lead(startOf(triangles, side)))];
    if (sum < 0.0) {
      sum = 0.0;
      ++facts.borders;
    }
    sum += (cornerAt(triangles, endOf(triangles, side)) - cornerAt(triangles, startOf(triangles, side))).norm();
    facts.longest_border = std::max(facts.longest_border, sum);
  });
}

void countFlat(const Triangles& triangles, Facts& facts) {
  for (const Face& face : triangles.faces) {
    const Vec3 ab = cornerAt(triangles, face[1]) - cornerAt(triangles, face[0]),
               ac = cornerAt(triangles, face[2]) - cornerAt(triangles, face[0]);
    const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
    // The differences of floats are exact in doubles, so within 8 epsilon of the products the corners are collinear.
    if (ab.cross(ac).norm() <= 0x1p-49 * longest) ++facts.flat_faces;
  }
}

}  // namespace

std::optional<Repaired> repair(Triangles triangles, const TaskMonitor& monitor) {
  constexpr const char* kStep = "Repairing";
  Facts facts;
  facts.file_faces = static_cast<std::int64_t>(triangles.faces.size());
  facts.file_corners = static_cast<std::int64_t>(triangles.p_MV.size());
  monitor.report(kStep, 0.0);
  dropUnusable(triangles, facts);
  if (monitor.isCancelled()) return {};
  compact(triangles);
  setBounds(triangles, facts);
  if (monitor.isCancelled() || !weldAll(triangles, facts, monitor)) return {};
  monitor.report(kStep, 0.3);
  dropEmpty(triangles, facts);
  std::optional<std::vector<Face>> duplicates = dropDuplicates(triangles, monitor);
  if (!duplicates) return {};
  facts.duplicates = static_cast<std::int64_t>(duplicates->size());
  compact(triangles, &*duplicates);
  setBounds(triangles, facts);
  monitor.report(kStep, 0.5);
  if (monitor.isCancelled()) return {};
  std::optional<Edges> edges = edgesOf(triangles, monitor);
  if (!edges) return {};
  const std::optional<std::int64_t> added = divideAtSeams(triangles, *edges, facts.weld_tolerance, monitor);
  if (!added) return {};
  facts.added_at_seams = *added;
  monitor.report(kStep, 0.7);
  const std::optional<Parts> parts = partsOf(triangles, *edges, monitor);
  if (!parts) return {};
  describeBorders(triangles, *edges, facts);
  turnFaces(triangles, *parts, facts);  // the sides of the edges change with it
  facts.faces = static_cast<std::int64_t>(triangles.faces.size());
  facts.corners = static_cast<std::int64_t>(triangles.p_MV.size());
  facts.border_edges = edges->borders;
  facts.crowded_edges = edges->crowded;
  describeParts(*parts, facts);
  countFlat(triangles, facts);
  monitor.report(kStep, 0.9);
  const Crossings crossings = crossingsOf(triangles, monitor);
  facts.crossings = crossings.pairs;
  facts.crossings_checked = crossings.is_whole ? 1 : 0;
  if (monitor.isCancelled()) return {};
  monitor.report(kStep, 1.0);
  return Repaired{std::move(triangles), facts, std::move(*duplicates)};
}

}  // namespace underact::mesh_file
