#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/view/pieces.h"
#include "core/scene/description.h"

namespace underact::gui {

/// The constraints as drawn: surfaces filled at 25 %, edges and outlines solid; a wall has short hatch lines on its
/// solid side, as mechanical drawings mark the ground. Unbounded shapes are clipped to a region somewhat larger than
/// the workspace. mm, in W.
class ConstraintPicture {
 public:
  ConstraintPicture();
  void setScene(const scene::Description& scene);
  void setTheme(const Theme& theme);
  /// The outlines as seen by the eye.
  void update(const Vec3& eye_mm);
  void setLineWidth(double device_pixels_per_pixel);

  /// Points that a picture of the whole constraint must contain.
  const std::vector<Vec3>& extent_mm() const { return extent_mm_; }
  std::vector<vtkActor*> lines() const;
  /// New with each scene.
  const std::vector<vtkSmartPointer<vtkActor>>& tints() const { return tints_; }

 private:
  struct Ball {
    Vec3 center_mm;
    Mat3 axes_mm;  // half axes as columns
  };
  struct Tube {
    Vec3 a_mm, b_mm;
    double radius_mm;
  };
  void build();
  template <class Shape>
  void add(const Shape& shape);  // one specialisation a type
  void addBall(const Vec3& center_mm, const Mat3& axes_mm);
  vtkActor& addTint(vtkPolyData* data);
  /// At a point of a wall's surface, given its outer normal; nothing if the shape is not a wall.
  void addHair(const Vec3& p_mm, const Vec3& outwards);
  /// Around a ring of a ball, u and v in its half axes.
  void addHairs(const Vec3& center_mm, const Vec3& u, const Vec3& v, const Mat3& axes_mm);

  struct Held {
    scene::Shape shape;
    target::Side side;
  };
  std::vector<Held> held_;
  target::Side side_ = target::Side::Both;  // of the shape that is being added
  Theme theme_ = Theme::light();
  Lines bold_, fine_, outlines_;
  vtkSmartPointer<vtkActor> bold_actor_, fine_actor_, outline_actor_;
  std::vector<vtkSmartPointer<vtkActor>> tints_;
  std::vector<Ball> balls_;
  std::vector<Tube> tubes_;
  std::vector<Vec3> extent_mm_;
  Vec3 middle_mm_ = Vec3::Zero();  // of the region: the origin, or where the tip of another arm rests
  Vec3 eye_mm_ = Vec3::Constant(kNotANumber);
};

}  // namespace underact::gui
