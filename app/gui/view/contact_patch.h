#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstddef>

#include "core/target/mesh_target.h"

class vtkCellArray;
class vtkPoints;

namespace underact::gui {

/// Where the stylus touches meshes: the part of the surface within 3 mm of each target, as polygons. mm, in W.
class ContactPatch {
 public:
  static constexpr double kRadius_mm = 3.0;

  ContactPatch();
  vtkPolyData* data() const { return data_; }
  std::size_t corners() const;
  void clear();
  /// The surface around p_WP (m), which lies on it. Cost: bounded, under 1 ms.
  void add(const target::MeshPlace& place, const Vec3& p_WP);
  void done();  // after the last add(): draw it

 private:
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkPoints> points_;
  vtkSmartPointer<vtkCellArray> cells_;
};

}  // namespace underact::gui
