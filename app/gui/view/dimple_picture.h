#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/view/pieces.h"
#include "core/scene/description.h"
#include "core/tick/report.h"

namespace underact::gui {

/// How a surface gives where the tip is pressed against it: a dimple from the surface down to the tip, the wider the
/// larger the force. Only of surfaces that are drawn translucent; of a mesh, see ContactPatch. mm, in W.
class DimplePicture {
 public:
  // Of an arm of the Omni's size: its radius without and with all the force that the arm can hold.
  static constexpr double kMin_mm = 3.5, kMax_mm = 12.0;
  static constexpr double kMinShare = 0.01;  // of that force: less is not shown

  DimplePicture();
  void setScene(const scene::Description& scene);
  void setTheme(const Theme& theme) { theme_ = theme; }
  void setLineWidth(double device_pixels_per_pixel);
  void show(bool shown) { shown_ = shown; }
  /// force_share: of what the arm can hold; size: ArmStand::size.
  void present(const tick::TickReport& report, const Vec3& p_WT, double force_share, double size);

  std::size_t dimples() const { return dimples_; }  // drawn
  std::vector<vtkActor*> actors() const { return {actor_, ring_actor_}; }

 private:
  void add(const Vec3& target_mm, const Vec3& tip_mm, double radius_mm);

  Theme theme_ = Theme::light();
  bool shown_ = true;
  std::vector<bool> is_surface_;  // of each constraint
  std::size_t dimples_ = 0;
  Lines faces_, rings_;
  vtkSmartPointer<vtkActor> actor_, ring_actor_;
};

}  // namespace underact::gui
