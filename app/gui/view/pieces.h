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

// The elements of pictures: solids, tints and lines. Each is an actor; only a few in all, since each one costs time.

/// How an actor is drawn. Solid: hides what is behind it. Tint: colours what is behind it, its near side only. Body:
/// tints, too, but hides what is drawn after it; of a surface of any form only the part nearest to the eye is drawn,
/// from outside and from inside. Line: antialiased, and writes no depth, so that lines that meet leave no gaps. Mark: a
/// line that nothing hides.
enum class PieceKind { Solid, Tint, Body, Line, Mark };

/// An actor that draws data. Add solids first, then lines, then tints: translucent things are drawn over what is behind
/// them.
vtkSmartPointer<vtkActor> makeActor(vtkPolyData* data, PieceKind kind);
/// A Body by how much farther from the eye than its place: what has the same place hides it, and does not fight with
/// it.
void setBehind(vtkActor& body, double behind_mm);
void setColour(vtkActor& actor, const QColor& colour);
void place(vtkActor& actor, const Eigen::Matrix4d& X);
/// X of a unit solid (radius 1, from 0 to 1 along z): from a to b, mm.
Eigen::Matrix4d along(const Vec3& a_mm, const Vec3& b_mm, double radius_mm);
Eigen::Matrix4d at(const Vec3& p_mm, double scale);

/// Lines and faces, each point with its own colour; can be rebuilt at any time.
class Lines {
 public:
  Lines();
  vtkPolyData* data() const { return data_; }
  void clear();
  void segment(const Vec3& a_mm, const Vec3& b_mm, const QColor& colour);
  void chain(std::span<const Vec3> points_mm, const QColor& colour, bool closed);
  /// center + radius (cos u + sin v).
  void circle(const Vec3& center_mm, const Vec3& u, const Vec3& v, double radius_mm, const QColor& colour);
  /// The outline of an ellipsoid seen from outside (axes_mm: its half axes as columns), and the two sides of a round
  /// rod from a to b (exact for a cylinder, close for a slender cone).
  void outline(const Vec3& eye_mm, const Vec3& center_mm, const Mat3& axes_mm, const QColor& colour);
  void sides(const Vec3& eye_mm, const Vec3& a_mm, const Vec3& b_mm, double a_radius_mm, double b_radius_mm,
             const QColor& colour);
  /// A corner of faces, and a face with such corners.
  vtkIdType corner(const Vec3& p_mm, const QColor& colour);
  void face(std::span<const vtkIdType> corners);
  void done();  // after the last line: draw them

 private:
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkPoints> points_;
  vtkSmartPointer<vtkCellArray> cells_, faces_;
  vtkSmartPointer<vtkUnsignedCharArray> colours_;
};

/// A surface of revolution about z: (radius, z) from bottom to top.
struct Ring {
  double radius = 0.0;
  double z = 0.0;
};
vtkSmartPointer<vtkPolyData> turned(std::span<const Ring> profile, int sectors);
vtkSmartPointer<vtkPolyData> unitSphere(int sectors, int rings);
vtkSmartPointer<vtkPolyData> unitTube(int sectors, bool closed);
vtkSmartPointer<vtkPolyData> unitCube();  // edges of length 1 about 0
vtkSmartPointer<vtkPolyData> polygon(std::span<const Vec3> points_mm, const Vec3& normal);

/// The 12 edges of a box placed by X.
void addBoxEdges(Lines& lines, const Vec3& half_mm, const Vec3& center_mm, const Mat3& R, const QColor& colour);

}  // namespace underact::gui
