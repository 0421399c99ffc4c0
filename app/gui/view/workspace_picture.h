#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <QString>
#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/view/orbit_camera.h"
#include "app/gui/view/pieces.h"
#include "core/arm/model.h"

namespace underact::gui {

/// A text at a point of W, for the painter.
struct Label {
  QString text;
  Vec3 p_mm = Vec3::Zero();
  QColor colour;
  bool strong = false;
  bool large = false;  // larger by half, one line below its point, on the background of the view
};

/// Half of the workspace stated by the manufacturer, mm: 160 x 120 x 70 about W.
const Vec3& workspaceHalf_mm();

/// The workspace as a thin box with ticks every 20 mm, and the triads of W and B.
class WorkspacePicture {
 public:
  WorkspacePicture();
  void setTheme(const Theme& theme);
  /// The box is that of haptic devices of the Omni's form; of other arms only the triads are drawn.
  void setArm(const arm::Model& model);
  void show(bool workspace, bool triads);
  void setLineWidth(double device_pixels_per_pixel);
  /// Ticks are placed where the camera sees them best.
  void update(const OrbitCamera& camera);

  std::vector<vtkActor*> lines() const { return {box_actor_}; }
  vtkActor* mark() const { return triad_actor_; }
  const std::vector<Label>& labels() const { return labels_; }
  /// Half of the box; 0 where the arm has none.
  Vec3 half_mm() const { return has_box_ ? workspaceHalf_mm() : Vec3(Vec3::Zero()); }

 private:
  void build();
  void addTicks(int axis, const Vec3& edge_mm, const Vec3& outward);
  void addTriad(const Vec3& p_mm, const Mat3& R, const QString& name, double length_mm);

  Theme theme_ = Theme::light();
  Pose X_WB_mm_ = Pose::Identity();
  bool has_box_ = true;
  double size_ = 1.0;  // of the arm, relative to the Omni
  bool workspace_ = true, triads_ = true;
  // Of the last update(): on which side the eye is, which axes of W point at it, and where the vertical ticks are.
  Vec3 sign_ = Vec3::Ones();
  Vec3 end_on_ = Vec3::Zero();
  Vec3 upright_mm_ = Vec3::Zero();
  Lines box_, triad_;
  vtkSmartPointer<vtkActor> box_actor_, triad_actor_;
  std::vector<Label> labels_;
};

}  // namespace underact::gui
