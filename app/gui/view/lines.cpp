#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/gui/view/pieces.h"
#include "core/base/units.h"

namespace underact::gui {

constexpr int kCircleParts = 96;

Lines::Lines()
    : data_(vtkSmartPointer<vtkPolyData>::New()),
      points_(vtkSmartPointer<vtkPoints>::New()),
      cells_(vtkSmartPointer<vtkCellArray>::New()),
      faces_(vtkSmartPointer<vtkCellArray>::New()),
      colours_(vtkSmartPointer<vtkUnsignedCharArray>::New()) {
  colours_->SetNumberOfComponents(4);
  colours_->SetName("colour");
  data_->SetPoints(points_);
  data_->SetLines(cells_);
  data_->SetPolys(faces_);
  data_->GetPointData()->SetScalars(colours_);
}

void Lines::clear() {
  points_->Reset();
  cells_->Reset();
  faces_->Reset();
  colours_->Reset();
}

vtkIdType Lines::corner(const Vec3& p_mm, const QColor& colour) {
  const std::array<unsigned char, 4> rgba{
      static_cast<unsigned char>(colour.red()), static_cast<unsigned char>(colour.green()),
      static_cast<unsigned char>(colour.blue()), static_cast<unsigned char>(colour.alpha())};
  colours_->InsertNextTypedTuple(rgba.data());
  return points_->InsertNextPoint(p_mm.data());
}

void Lines::face(std::span<const vtkIdType> corners) {
  faces_->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
}

void Lines::chain(std::span<const Vec3> points_mm, const QColor& colour, bool closed) {
  if (points_mm.size() < 2) return;
  const vtkIdType first = points_->GetNumberOfPoints();
  cells_->InsertNextCell(static_cast<int>(points_mm.size()) + (closed ? 1 : 0));
  for (const Vec3& p_mm : points_mm) cells_->InsertCellPoint(corner(p_mm, colour));
  if (closed) cells_->InsertCellPoint(first);
}

void Lines::segment(const Vec3& a_mm, const Vec3& b_mm, const QColor& colour) {
  const std::array<Vec3, 2> ends{a_mm, b_mm};
  chain(ends, colour, false);
}

void Lines::circle(const Vec3& center_mm, const Vec3& u, const Vec3& v, double radius_mm, const QColor& colour) {
  std::array<Vec3, kCircleParts> points;
  for (int part = 0; part < kCircleParts; ++part) {
    const double angle = 2.0 * kPi * part / kCircleParts;
    points[static_cast<std::size_t>(part)] = center_mm + radius_mm * (std::cos(angle) * u + std::sin(angle) * v);
  }
  chain(points, colour, true);
}

void Lines::outline(const Vec3& eye_mm, const Vec3& center_mm, const Mat3& axes_mm, const QColor& colour) {
  const Vec3 offset = axes_mm.inverse() * (eye_mm - center_mm);  // in half axes, where it is the unit sphere
  const double share = 1.0 / std::max(offset.norm(), 1e-9);
  if (share >= 1.0) return;  // none from inside
  const Vec3 axis = offset.normalized(), u = axis.unitOrthogonal();
  circle(center_mm + axes_mm * (share * axis), axes_mm * u, axes_mm * axis.cross(u), std::sqrt(1.0 - share * share),
         colour);
}

void Lines::sides(const Vec3& eye_mm, const Vec3& a_mm, const Vec3& b_mm, double a_radius_mm, double b_radius_mm,
                  const QColor& colour) {
  const Vec3 axis = (b_mm - a_mm).normalized();
  Vec3 travel_mm = eye_mm - a_mm;
  travel_mm -= travel_mm.dot(axis) * axis;
  const double share = std::max(a_radius_mm, b_radius_mm) / std::max(travel_mm.norm(), 1e-9);
  if (share >= 1.0 || !axis.allFinite()) return;
  const Vec3 u = travel_mm.normalized(), v = axis.cross(u);
  for (const double side : {-1.0, 1.0}) {
    const Vec3 out = share * u + side * std::sqrt(1.0 - share * share) * v;
    segment(a_mm + a_radius_mm * out, b_mm + b_radius_mm * out, colour);
  }
}

void Lines::done() {
  points_->Modified();
  cells_->Modified();
  faces_->Modified();
  colours_->Modified();
  data_->Modified();
}

void addBoxEdges(Lines& lines, const Vec3& half_mm, const Vec3& center_mm, const Mat3& R, const QColor& colour) {
  for (int axis = 0; axis < 3; ++axis) {
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-1.0, 1.0}) {
        Vec3 from = Vec3::Zero();
        from[second] = a * half_mm[second];
        from[third] = b * half_mm[third];
        Vec3 to = from;
        from[axis] = -half_mm[axis];
        to[axis] = half_mm[axis];
        const Vec3 p_mm = center_mm + R * from, q_mm = center_mm + R * to;
        lines.segment(p_mm, q_mm, colour);
      }
    }
  }
}

}  // namespace underact::gui
