#include "app/gui/view/section_cap.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace underact::gui {
namespace {

// Neighbouring rows share no corners, so each extends slightly below: no pixel between them is left out.
constexpr double kOver = 0.5;  // of a row

Vec3 inSpace(double u_mm, double v_mm, int axis, double at_mm) {
  Vec3 p_mm;
  p_mm[axis] = at_mm;
  p_mm[(axis + 1) % 3] = u_mm;
  p_mm[(axis + 2) % 3] = v_mm;
  return p_mm;
}

/// A side of the face, upwards; turns: the change of the winding number to its right, +1 or -1.
struct Side {
  int low = 0, high = 0;  // rows
  double low_u = 0.0, high_u = 0.0;
  int turns = 0;
  double at(int row) const {
    if (row == low) return low_u;
    if (row == high) return high_u;
    return low_u + (high_u - low_u) * (row - low) / (high - low);
  }
};

}  // namespace

SectionCap::SectionCap()
    : face_(vtkSmartPointer<vtkPolyData>::New()),
      outline_(vtkSmartPointer<vtkPolyData>::New()),
      face_points_(vtkSmartPointer<vtkPoints>::New()),
      outline_points_(vtkSmartPointer<vtkPoints>::New()),
      face_cells_(vtkSmartPointer<vtkCellArray>::New()),
      outline_cells_(vtkSmartPointer<vtkCellArray>::New()) {
  face_->SetPoints(face_points_);
  face_->SetPolys(face_cells_);
  outline_->SetPoints(outline_points_);
  outline_->SetLines(outline_cells_);
}

void SectionCap::clear() {
  for (vtkPoints* points : {face_points_.Get(), outline_points_.Get()}) points->Reset();
  for (vtkCellArray* cells : {face_cells_.Get(), outline_cells_.Get()}) cells->Reset();
}

void SectionCap::add(const mesh::Triangles& triangles, const Eigen::Matrix4d& X, int axis, double at_mm,
                     bool is_filled) {
  const std::vector<Segment> segments = segmentsOf(triangles, X, axis, at_mm);
  for (const Segment& segment : segments) {
    outline_cells_->InsertNextCell(2);
    for (const Eigen::Vector2d& end : {segment.from, segment.to}) {
      const Vec3 p_mm = inSpace(end.x(), end.y(), axis, at_mm);
      outline_cells_->InsertCellPoint(outline_points_->InsertNextPoint(p_mm.data()));
    }
  }
  if (is_filled) fill(segments, axis, at_mm);
}

std::vector<SectionCap::Segment> SectionCap::segmentsOf(const mesh::Triangles& triangles, const Eigen::Matrix4d& X,
                                                        int axis, double at_mm) {
  const Eigen::RowVector3d height = X.block<1, 3>(axis, 0);
  std::vector<float> over_mm;  // the plane; 0 counts as over it, so that a corner on the plane is no special case
  over_mm.reserve(triangles.p_MV.size());
  for (const Eigen::Vector3f& p_MV : triangles.p_MV)
    over_mm.push_back(static_cast<float>(height.dot(p_MV.cast<double>()) + X(axis, 3) - at_mm));
  const auto crossing = [&](std::int32_t one, std::int32_t other) -> Eigen::Vector2d {
    if (one > other) std::swap(one, other);  // the same bits from both faces of the edge
    const auto first = static_cast<std::size_t>(one), second = static_cast<std::size_t>(other);
    const double share = over_mm[first] / (static_cast<double>(over_mm[first]) - over_mm[second]);
    const Vec3 a_M = triangles.p_MV[first].cast<double>(), b_M = triangles.p_MV[second].cast<double>();
    const Vec3 p_mm = X.block<3, 3>(0, 0) * (a_M + share * (b_M - a_M)) + X.block<3, 1>(0, 3);
    return {p_mm[(axis + 1) % 3], p_mm[(axis + 2) % 3]};
  };
  std::vector<Segment> segments;
  for (const mesh::Face& face : triangles.faces) {
    std::array<bool, 3> over{};
    for (std::size_t k = 0; k < 3; ++k) over[k] = over_mm[static_cast<std::size_t>(face[k])] >= 0.0F;
    if (over[0] == over[1] && over[1] == over[2]) continue;
    Segment segment;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (over[k] != over[next]) (over[k] ? segment.from : segment.to) = crossing(face[k], face[next]);
    }
    segments.push_back(segment);
  }
  return segments;
}

void SectionCap::fill(const std::vector<Segment>& segments, int axis, double at_mm) {
  double min = std::numeric_limits<double>::infinity(), max = -min;
  for (const Segment& segment : segments) {  // each corner of a closed outline is the begin of one
    min = std::min(min, segment.from.y());
    max = std::max(max, segment.from.y());
  }
  if (!(max > min)) return;
  const double row_mm = kRow * (max - min);
  std::vector<Side> sides;
  std::vector<int> rows;  // at which a side begins or ends
  for (const Segment& segment : segments) {
    const auto from = static_cast<int>(std::lround((segment.from.y() - min) / row_mm));
    const auto to = static_cast<int>(std::lround((segment.to.y() - min) / row_mm));
    if (from < to) sides.push_back({from, to, segment.from.x(), segment.to.x(), 1});
    if (to < from) sides.push_back({to, from, segment.to.x(), segment.from.x(), -1});
    if (from != to) rows.insert(rows.end(), {from, to});
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.low < b.low; });
  std::vector<std::pair<double, Side>> there;  // sides of a row, from the left by where their middles are
  auto next = sides.cbegin();
  for (std::size_t index = 0; index + 1 < rows.size(); ++index) {
    const int low = rows[index], high = rows[index + 1];
    std::erase_if(there, [low](const auto& one) { return one.second.high <= low; });
    for (; next != sides.cend() && next->low <= low; ++next) there.emplace_back(0.0, *next);
    for (auto& [middle, side] : there) middle = side.at(low) + side.at(high);
    std::sort(there.begin(), there.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    int turns = 0;
    const Side* left = nullptr;
    for (const auto& [middle, side] : there) {
      if (turns == 0) left = &side;
      turns += side.turns;
      if (turns != 0) continue;
      const double low_mm = min + (low - kOver) * row_mm, high_mm = min + high * row_mm;
      face_cells_->InsertNextCell(4);
      for (const auto& [u_mm, v_mm] : {std::pair{left->at(low), low_mm},
                                       {side.at(low), low_mm},
                                       {side.at(high), high_mm},
                                       {left->at(high), high_mm}}) {
        const Vec3 p_mm = inSpace(u_mm, v_mm, axis, at_mm);
        face_cells_->InsertCellPoint(face_points_->InsertNextPoint(p_mm.data()));
      }
    }
  }
}

void SectionCap::done() {
  for (vtkPolyData* data : {face_.Get(), outline_.Get()}) {
    data->GetPoints()->Modified();
    data->Modified();
  }
  face_cells_->Modified();
  outline_cells_->Modified();
}

}  // namespace underact::gui
