#pragma once
#include <functional>
#include <vector>

#include "core/shape/shape.h"
#include "tests/support/property.h"

namespace underact::test {

/// A piece of a shape by two parameters; held: the parameters end at the range (a face), else they go on (an angle);
/// straight: each line of constant a is one, so that its nearest b is a projection.
struct Patch {
  std::function<Vec3(double, double)> at;
  double a_half = 0.0;
  double b_half = 0.0;
  bool held = false;
  bool straight = false;
};

/// What a shape is, said a second time and in other words: points of it by parameters, and how far off it a point is. A
/// scaled shape is the plain one with its coordinates multiplied. Shares no line with core/shape.
struct ShapeOracle {
  const char* name = "";
  shape::Shape shape;  // under test: one of every alternative, scaled where scale is not one
  shape::Shape plain;  // before scaling
  Vec3 scale = Vec3::Ones();
  std::vector<Patch> patches;              // of the scaled shape
  std::function<double(const Vec3&)> off;  // of the plain shape, m; negative on its inner side, 0 on it
  bool has_sides = false;
  double middle_m = 0.0;  // where a centre or axis is: size of the region whose points are nearly degenerate
};

/// One of each alternative of Shape, at random; every Shape is in it (checked as it is compiled).
std::vector<ShapeOracle> everyShape(Random& random);

/// The smallest distance of p_WT from the shape that a grid and a search by ever smaller steps find. Never too small.
double searchDistance(const ShapeOracle& oracle, const Vec3& p_WT);

}  // namespace underact::test
