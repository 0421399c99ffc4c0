#pragma once
#include <vtkAssembly.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "app/gui/view/constraint_picture.h"
#include "app/gui/view/hand_picture.h"
#include "app/gui/view/influence_picture.h"
#include "app/gui/view/mesh_picture.h"
#include "app/gui/view/robot_picture.h"

namespace underact::gui {

/// The picture of a second arm beside the first: its constraints, the arm, stylus, targets, force and robots. Its own
/// workspace frame is S as seen from the first arm's W.
class SecondWorld {
 public:
  SecondWorld();
  void setScene(const scene::Description& scene);
  bool isReadingArm() const { return hand_.isReadingArm(); }
  bool takeArmRead() { return hand_.takeArmRead(); }
  void setPlace(const Pose& X_WS_mm);
  void setTheme(const Theme& theme);
  void setLayers(const Layers& layers);
  void setLineWidth(double device_pixels_per_pixel);
  /// false: it would look the same.
  bool present(const servo::Snapshot& snapshot);
  /// As seen by the camera. size: of the picture, logical pixels.
  void update(OrbitCamera camera, const QSizeF& size);
  /// Everything as one actor; a new one after a scene or a theme was set.
  vtkProp3D* prop() const { return assembly_; }
  std::vector<Label> labels() const;
  std::vector<Vec3> extent_mm() const;

 private:
  void assemble();

  Pose X_WS_mm_ = Pose::Identity();
  ConstraintPicture constraint_;
  HandPicture hand_;
  InfluencePicture influence_;
  RobotPicture robots_;
  MeshPicture meshes_;
  QColor ink_;
  std::optional<servo::Snapshot> shown_;
  vtkSmartPointer<vtkAssembly> assembly_;
};

/// Whether both look the same.
bool looksAlike(const servo::Snapshot& one, const servo::Snapshot& other);

}  // namespace underact::gui
