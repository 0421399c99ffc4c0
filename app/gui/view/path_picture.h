#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/model/session_data.h"
#include "app/gui/view/pieces.h"

namespace underact::gui {

/// The path of the tip in a recording: a line whose colour goes from grey, without force, over that of forces to that
/// of a limit, at the arm's continuous force.
class PathPicture {
 public:
  PathPicture();
  void setTheme(const Theme& theme);
  void setLineWidth(double device_pixels_per_pixel);
  void setForceLimit(double continuous_N);
  void show(bool shown);
  /// Points that are not finite break the line.
  void setPath(std::vector<PathPoint> path);
  std::size_t parts() const { return shown_ ? parts_ : 0; }  // of the line, as drawn
  std::vector<vtkActor*> lines() const { return {actor_}; }

 private:
  void build();

  Theme theme_ = Theme::light();
  double limit_N_ = 1.0;
  bool shown_ = true;
  std::size_t parts_ = 0;
  std::vector<PathPoint> path_;
  Lines lines_;
  vtkSmartPointer<vtkActor> actor_;
};

}  // namespace underact::gui
