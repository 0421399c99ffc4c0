#include "app/gui/view/contact_patch.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <cmath>
#include <set>
#include <vector>

#include "core/base/units.h"
#include "core/mesh/search.h"

namespace underact::gui {
namespace {

constexpr int kDiscSides = 20;           // of the disc
constexpr std::size_t kMaxFaces = 1500;  // of one patch: a finer mesh gets a smaller one

/// The part of a polygon within reach of p along the unit direction.
std::vector<Vec3> cut(const std::vector<Vec3>& polygon, const Vec3& p, const Vec3& direction, double reach) {
  std::vector<Vec3> left;
  for (std::size_t index = 0; index < polygon.size(); ++index) {
    const Vec3 &one = polygon[index], &next = polygon[(index + 1) % polygon.size()];
    const double over = direction.dot(one - p) - reach, next_over = direction.dot(next - p) - reach;
    if (over <= 0.0) left.push_back(one);
    if ((over <= 0.0) != (next_over <= 0.0)) left.push_back(one + over / (over - next_over) * (next - one));
  }
  return left;
}

/// The directions of a prism's sides around the normal, and of its two ends.
std::vector<Vec3> prismAround(const Vec3& normal) {
  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Vec3> directions{normal, -normal};
  for (int side = 0; side < kDiscSides; ++side) {
    const double angle_rad = 2.0 * kPi * side / kDiscSides;
    directions.emplace_back(std::cos(angle_rad) * u + std::sin(angle_rad) * v);
  }
  return directions;
}

}  // namespace

ContactPatch::ContactPatch()
    : data_(vtkSmartPointer<vtkPolyData>::New()),
      points_(vtkSmartPointer<vtkPoints>::New()),
      cells_(vtkSmartPointer<vtkCellArray>::New()) {
  data_->SetPoints(points_);
  data_->SetPolys(cells_);
}

std::size_t ContactPatch::corners() const {
  return static_cast<std::size_t>(points_->GetNumberOfPoints());
}

void ContactPatch::clear() {
  points_->Reset();
  cells_->Reset();
}

void ContactPatch::add(const target::MeshPlace& place, const Vec3& p_WP) {
  mesh::SearchState from_nowhere;
  const mesh::Surface& surface = *place.surface;
  const mesh::Hit hit = mesh::nearestPoint(surface, mesh::Search::Hybrid, target::toMesh(place, p_WP), from_nowhere);
  const Vec3 normal_M = mesh::outwardAt(surface, hit);
  if (hit.face < 0 || normal_M.isZero()) return;
  const double reach = kMetrePerMillimetre * kRadius_mm / std::abs(place.scale_m);
  const std::vector<Vec3> directions = prismAround(normal_M);
  std::vector<std::int32_t> faces{hit.face};  // connected to it, as far as they are within reach
  std::set<std::int32_t> seen{hit.face};
  for (std::size_t index = 0; index < faces.size() && index < kMaxFaces; ++index) {
    const mesh::Corners corners = mesh::cornersOf(surface, faces[index]);
    std::vector<Vec3> polygon{corners.a, corners.b, corners.c};
    for (const Vec3& direction : directions) polygon = cut(polygon, hit.p_M, direction, reach);
    if (polygon.size() < 3) continue;
    cells_->InsertNextCell(static_cast<int>(polygon.size()));
    for (const Vec3& p_M : polygon) {
      const Vec3 p_mm = kMillimetrePerMetre * target::toWorkspace(place, p_M);
      cells_->InsertCellPoint(points_->InsertNextPoint(p_mm.data()));
    }
    for (const std::int32_t next : surface.neighbours[static_cast<std::size_t>(faces[index])]) {
      if (next >= 0 && seen.insert(next).second) faces.push_back(next);
    }
  }
}

void ContactPatch::done() {
  points_->Modified();
  cells_->Modified();
  data_->Modified();
}

}  // namespace underact::gui
