#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/view/orbit_camera.h"
#include "app/gui/view/pieces.h"
#include "app/gui/view/workspace_picture.h"
#include "core/tick/report.h"

namespace underact::gui {

/// Thesis figure 5.8, live: of each influenced constraint the orientation- and the position-nearest point (rings o and
/// p), the arc from one to the other, stronger up to the target, and the tangent there. A function of the tick's report
/// and the theme.
class InfluencePicture {
 public:
  InfluencePicture();
  void setTheme(const Theme& theme) { theme_ = theme; }
  void setLineWidth(double device_pixels_per_pixel);
  void show(bool shown) { shown_ = shown; }
  void present(const tick::TickReport& report);
  /// As the camera sees it; builds lines and labels. size: of the picture, logical pixels.
  void update(const OrbitCamera& camera, const QSizeF& size);

  std::vector<vtkActor*> lines() const { return {thin_actor_, bold_actor_}; }
  vtkActor* rings() const { return ring_actor_; }  // drawn over everything
  const std::vector<Label>& labels() const { return labels_; }
  bool isSeen() const { return shown_ && !drawn_.empty(); }

 private:
  struct Drawn {
    target::Arc arc;  // m
    Vec3 p_WP = Vec3::Zero();
  };
  void addArc(const Drawn& drawn);
  void addRing(const Drawn& drawn, const Vec3& p_W, const QColor& colour, const QString& letter,
               const OrbitCamera& camera, const QSizeF& size);

  Theme theme_ = Theme::light();
  bool shown_ = true;
  std::vector<Drawn> drawn_;
  std::vector<Label> labels_;
  Lines thin_, bold_, rings_;
  vtkSmartPointer<vtkActor> thin_actor_, bold_actor_, ring_actor_;
};

}  // namespace underact::gui
