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

/// The world of a second arm, beside that of the first in the same picture: what it is held to, the arm, stylus,
/// targets, force and robots. Its own frame W stands elsewhere: S, seen from the first one's.
class SecondWorld {
 public:
  SecondWorld();
  void setScene(const scene::Description& scene);
  void setPlace(const Pose& X_WS_mm);
  void setTheme(const Theme& theme);
  void setLayers(const Layers& layers);
  void setLineWidth(double device_pixels_per_pixel);
  /// false: it would look the same.
  bool present(const servo::Snapshot& snapshot);
  /// As the camera sees it. size: of the picture, logical pixels.
  void update(OrbitCamera camera, const QSizeF& size);
  /// All of it, as one thing to draw; another one after a scene or a theme was set.
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

/// Nothing that can be seen is another.
bool looksAlike(const servo::Snapshot& one, const servo::Snapshot& other);

}  // namespace underact::gui
