#include "core/mesh_file/unite.h"

#include <algorithm>
#include <utility>

#include "core/base/translate.h"
#include "core/mesh_file/holes.h"
#include "core/mesh_union/union.h"

namespace underact::mesh_file {
namespace {

/// Larger meshes are not searched for intersections here; they are united if some were found before.
constexpr std::int64_t kMaxFacesToUnite = 2'000'000;

bool mayCross(const Facts& facts) {
  if (facts.crossings > 0 || facts.crowded_edges > 0 || facts.border_edges > 0) return true;
  return (facts.parts > 1 || facts.crossings_checked == 0) && facts.faces <= kMaxFacesToUnite;
}

void setFelt(const mesh::Triangles& triangles, Facts& facts) {
  facts.felt_faces = static_cast<std::int64_t>(triangles.faces.size());
  facts.felt_corners = static_cast<std::int64_t>(triangles.p_MV.size());
}

}  // namespace

bool uniteRepaired(Repaired& repaired, const TaskMonitor& monitor) {
  Facts& facts = repaired.facts;
  setFelt(repaired.triangles, facts);
  // Where faces cannot agree on an outside, there is no inside.
  if (facts.clashing_edges > 0 || !mayCross(facts)) return true;
  const char* step = TRANSLATE_NOOP("step of work", "Uniting parts that intersect");
  monitor.report(step, 0.0);
  mesh::Triangles triangles = repaired.triangles;
  // Two bodies may have the same face: then it counts for each of them.
  if (facts.crowded_edges > 0)
    triangles.faces.insert(triangles.faces.end(), repaired.twice.begin(), repaired.twice.end());
  if (facts.border_edges > 0) {
    const std::optional<ClosedHoles> holes = closeHoles(triangles, monitor);
    if (!holes) return !monitor.isCancelled();
    facts.closed_holes = holes->count;
    facts.longest_closed_hole = holes->longest;
  }
  // Pieces of a convex decomposition end at the same plane, apart from rounding: the gap must not be felt.
  mesh_union::Union made =
      mesh_union::unite(triangles, 0.25 * facts.weld_tolerance, 2.0 * facts.weld_tolerance, monitor);
  monitor.report(step, 1.0);
  if (made.outcome == mesh_union::Outcome::AsItWas && facts.closed_holes > 0) made.outcome = mesh_union::Outcome::Made;
  switch (made.outcome) {
    case mesh_union::Outcome::Cancelled:
      return false;
    case mesh_union::Outcome::Made:
      repaired.triangles = std::move(triangles);
      facts.inside = Inside::United;
      facts.within = made.dropped;
      setFelt(repaired.triangles, facts);
      break;
    case mesh_union::Outcome::TooMuch:
    case mesh_union::Outcome::Open:
      if (facts.crossings_checked == 0) facts.crossings = std::max(facts.crossings, made.crossings);
      if (isClosed(facts) && facts.crossings > 0) facts.inside = Inside::Unsure;
      facts.closed_holes = 0;
      break;
    case mesh_union::Outcome::AsItWas:
      facts.crossings_checked = 1;  // of larger meshes than repair() checks
      break;
  }
  return true;
}

}  // namespace underact::mesh_file
