#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/view/pieces.h"
#include "app/gui/view/workspace_picture.h"

namespace underact::gui {

/// The desk as the arm sees it, and the marks on it, m.
struct Desk {
  Pose X_WD = Pose::Identity();
  std::vector<Vec3> points_D;
};

/// The sheet on the desk with the reference points by which the arm was registered, each with its number.
class DeskPicture {
 public:
  DeskPicture();
  void setTheme(const Theme& theme);
  void setLineWidth(double device_pixels_per_pixel);
  void setDesk(const std::optional<Desk>& desk);
  void show(bool shown);
  bool isKnown() const { return desk_.has_value(); }
  /// The identity if there is no desk.
  Mat3 R_WD() const { return desk_ ? Mat3(desk_->X_WD.linear()) : Mat3(Mat3::Identity()); }
  std::size_t marks() const { return shown_ && desk_ ? desk_->points_D.size() : 0; }  // drawn
  std::vector<vtkActor*> lines() const { return {actor_}; }
  const std::vector<Label>& labels() const { return labels_; }
  const std::vector<Vec3>& extent_mm() const { return corners_mm_; }

 private:
  void build();

  Theme theme_ = Theme::light();
  std::optional<Desk> desk_;
  bool shown_ = true;
  Lines lines_;
  vtkSmartPointer<vtkActor> actor_;
  std::vector<Label> labels_;
  std::vector<Vec3> corners_mm_;
};

}  // namespace underact::gui
