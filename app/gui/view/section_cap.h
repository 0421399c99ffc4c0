#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/triangles.h"

class vtkCellArray;
class vtkPoints;

namespace underact::gui {

/// The section of meshes by a plane across an axis of W: the outline, and for a closed mesh the filled face. mm, in W.
/// The face is everything that the mesh winds around, in either direction: bodies that overlap are one, and a cavity
/// whose triangles face inwards stays open. Linear in the triangles; each part of the outline counts once for each row
/// that it crosses.
class SectionCap {
 public:
  /// The face is exact to this share of its height, so that the finest outline asks for no more rows than a screen has.
  static constexpr double kRow = 1.0 / 4096.0;

  SectionCap();
  void clear();
  /// X: from the mesh's frame and unit to W in mm. axis: 0 x, 1 y, 2 z. is_filled: the triangles are closed.
  void add(const mesh::Triangles& triangles, const Eigen::Matrix4d& X, int axis, double at_mm, bool is_filled);
  void done();  // after the last add(): draw it

  vtkPolyData* face() const { return face_; }
  vtkPolyData* outline() const { return outline_; }

 private:
  struct Segment {  // with the body always on the same side; in the plane, mm
    Eigen::Vector2d from, to;
  };
  static std::vector<Segment> segmentsOf(const mesh::Triangles& triangles, const Eigen::Matrix4d& X, int axis,
                                         double at_mm);
  void fill(const std::vector<Segment>& segments, int axis, double at_mm);

  vtkSmartPointer<vtkPolyData> face_, outline_;
  vtkSmartPointer<vtkPoints> face_points_, outline_points_;
  vtkSmartPointer<vtkCellArray> face_cells_, outline_cells_;
};

}  // namespace underact::gui
