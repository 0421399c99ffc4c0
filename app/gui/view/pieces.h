#pragma once
#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <span>
#include <vector>

#include "core/base/types.h"

class vtkCellArray;
class vtkPoints;
class vtkUnsignedCharArray;

namespace underact::gui {

// What pictures are made of: solids, tints and lines; each an actor, a few of them in all, since each one costs.

/// How an actor is drawn. Solid: hides what is behind it. Tint: colours what is behind it, its near side only. Body:
/// colours what is behind it, too, and hides what is drawn after it; of a surface of any form only what is nearest to
/// the eye, from outside and from inside. Line: smooth, and writes no depth, so that lines that meet leave no gaps.
/// Mark: a line that nothing hides.
enum class Kind { Solid, Tint, Body, Line, Mark };

/// An actor that draws data. Add solids first, then lines, then tints: see-through things come over what is behind
/// them.
vtkSmartPointer<vtkActor> makeActor(vtkPolyData* data, Kind kind);
void setColour(vtkActor& actor, const QColor& colour);
void place(vtkActor& actor, const Eigen::Matrix4d& X);
/// X of a unit solid (radius 1, from 0 to 1 along z): from a to b, mm.
Eigen::Matrix4d along(const Vec3& a_mm, const Vec3& b_mm, double radius_mm);
Eigen::Matrix4d at(const Vec3& p_mm, double scale);

/// Lines, each point with its own colour: filled in anew as often as need be.
class Lines {
 public:
  Lines();
  vtkPolyData* data() const { return data_; }
  void clear();
  void segment(const Vec3& a_mm, const Vec3& b_mm, const QColor& colour);
  void chain(std::span<const Vec3> points_mm, const QColor& colour, bool closed);
  /// center + radius (cos u + sin v).
  void circle(const Vec3& center_mm, const Vec3& u, const Vec3& v, double radius_mm, const QColor& colour);
  /// The outline that a sphere shows to an eye outside it, and the two sides that a round rod from a to b shows (a
  /// cylinder; a slender cone nearly so).
  void outline(const Vec3& eye_mm, const Vec3& center_mm, double radius_mm, const QColor& colour);
  void sides(const Vec3& eye_mm, const Vec3& a_mm, const Vec3& b_mm, double a_radius_mm, double b_radius_mm,
             const QColor& colour);
  void done();  // what was filled in is to be drawn

 private:
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkPoints> points_;
  vtkSmartPointer<vtkCellArray> cells_;
  vtkSmartPointer<vtkUnsignedCharArray> colours_;
};

/// A surface turned around z: (radius, z) from bottom to top.
struct Ring {
  double radius = 0.0;
  double z = 0.0;
};
vtkSmartPointer<vtkPolyData> turned(std::span<const Ring> profile, int sectors);
vtkSmartPointer<vtkPolyData> unitSphere(int sectors, int rings);
vtkSmartPointer<vtkPolyData> unitTube(int sectors, bool closed);
vtkSmartPointer<vtkPolyData> unitCube();  // edges of length 1 about 0
vtkSmartPointer<vtkPolyData> polygon(std::span<const Vec3> points_mm, const Vec3& normal);

/// The 12 edges of a box that X places.
void addBoxEdges(Lines& lines, const Vec3& half_mm, const Vec3& center_mm, const Mat3& R, const QColor& colour);

}  // namespace underact::gui
