#pragma once
#include <string>
#include <vector>

#include "core/shape/shape.h"

namespace underact::test {

/// tests/golden/constraints.json: numbers of 50 digits that no line of ours made. Lengths mm, forces N, as in the file.
struct GoldenShape {
  std::string name;
  std::string type;               // point, sphere, line, plane, circle, cylinder
  Vec3 place = Vec3::Zero();      // point or centre
  Vec3 direction = Vec3::Zero();  // direction, normal or axis
  double radius = 0.0;
};
struct GoldenCase {
  std::string tag;
  Vec3 P = Vec3::Zero();
  Vec3 Q = Vec3::Zero();      // NaN where degenerate
  Vec3 force = Vec3::Zero();  // NaN where degenerate
  Vec3 kp = Vec3::Zero();     // N/mm
  double distance = 0.0;
  double tol_Q = 0.0;
  double tol_F = 0.0;
  bool degenerate = false;
};
struct GoldenSet {
  GoldenShape shape;
  std::vector<GoldenCase> cases;
};
struct GoldenClamp {
  Vec3 force = Vec3::Zero();
  Vec3 clamped = Vec3::Zero();
  double max = 0.0;
};
struct ConstraintVectors {
  std::vector<GoldenSet> sets;         // without sphere_4: a radius of 0 is refused
  std::vector<GoldenSet> extreme;      // one case each
  std::vector<GoldenSet> anisotropic;  // one case each, Euclidean nearest point, kp componentwise
  std::vector<GoldenShape> invalid;
  std::vector<GoldenClamp> clamp;
};
const ConstraintVectors& constraintVectors();

/// The shape of the file with each length times unit (1: mm as they are; 1e-3: as the program has them).
Result<shape::Shape> makeShape(const GoldenShape& golden, double unit);

/// From the axis or the centre, mm; infinite for a shape that has neither.
double offAxis(const GoldenShape& golden, const Vec3& P);

}  // namespace underact::test
