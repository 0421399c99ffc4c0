#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <span>
#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/view/arm_picture.h"

class vtkCellArray;
class vtkPoints;
class vtkUnsignedCharArray;

namespace underact::gui {

/// How dark it is at the points of a square grid on the desk, 0 to 1; row by row.
struct ShadowField {
  static constexpr int kPoints = 56;            // along each side
  Vec3 p_WCorner = Vec3::Zero();                // m
  Vec3 x_W = Vec3::Zero(), z_W = Vec3::Zero();  // the two sides, m
  std::vector<float> shade;
};

/// The soft shadow of rods under a wide light from above: sharp and dark where a rod is near the desk, wide and pale
/// where it is high. desk: D in W (y up), its origin on the desk. size: ArmStand::size. Without rods: no shade. Cost:
/// 0.2 ms for an arm of six joints, so it is made anew for each picture; a map of the light's depth would need a
/// second picture of the scene.
ShadowField shadowOf(std::span<const ShadowRod> rods, const Pose& X_WD, double size);

/// The desk that the arm stands on, a round top, and the arm's shadow on it.
class ShadowPicture {
 public:
  ShadowPicture();
  void setTheme(const Theme& theme);
  void show(bool shown) { shown_ = shown; }
  void setLineWidth(double device_pixels_per_pixel);
  void present(std::span<const ShadowRod> rods, const ArmStand& stand);
  /// From below the desk there is none.
  void update(const OrbitCamera& camera);
  std::vector<vtkActor*> actors() const { return {top_actor_, actor_}; }

 private:
  void colour();
  void buildTop();

  Theme theme_ = Theme::light();
  bool shown_ = true;
  ArmStand stand_;
  Pose X_WD_ = Pose::Identity();
  Lines top_;
  ShadowField field_;
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkPoints> points_;
  vtkSmartPointer<vtkCellArray> cells_;
  vtkSmartPointer<vtkUnsignedCharArray> colours_;
  vtkSmartPointer<vtkActor> actor_, top_actor_;
};

}  // namespace underact::gui
