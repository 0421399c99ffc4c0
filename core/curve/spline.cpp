#include "core/curve/spline.h"

#include <cmath>

#include "core/curve/cubic.h"

namespace underact::curve {
namespace {

constexpr double kLengthError = 1e-9;  // of the length of the piece between two points

/// A third of the derivative by the piece's own parameter at the point between two chords, for the piece of the second
/// chord: the handle of its Bezier form.
Vec3 handle(const Vec3& before, const Vec3& own) {
  const double d1 = std::sqrt(before.norm()), d2 = std::sqrt(own.norm());
  return (before.normalized() + own.normalized()) * (d1 * d2 * d2 / (3.0 * (d1 + d2)));
}

/// Appends the controls of the cubic after its first one, in as many pieces as its length needs. length_m: by
/// quadrature.
void append(const Cubic& cubic, double length_m, double error_m, int halvings, std::vector<Vec3>& controls_W) {
  const Halves halves = halvesOf(cubic);
  const double first_m = lengthUpTo(halves.first, 1.0), second_m = lengthUpTo(halves.second, 1.0);
  if (halvings == kMaxHalvings || std::abs(length_m - (first_m + second_m)) <= error_m) {
    controls_W.insert(controls_W.end(), cubic.begin() + 1, cubic.end());
    return;
  }
  append(halves.first, first_m, error_m, halvings + 1, controls_W);
  append(halves.second, second_m, error_m, halvings + 1, controls_W);
}

}  // namespace

std::vector<Vec3> splineControls(const std::vector<Vec3>& points_W, bool closed) {
  const std::size_t count = points_W.size(), pieces = closed ? count : count - 1;
  const auto at = [&](std::size_t i) -> const Vec3& { return points_W[i % count]; };
  std::vector<Vec3> controls_W{points_W.front()};
  controls_W.reserve(1 + 3 * pieces);
  for (std::size_t i = 0; i < pieces; ++i) {
    const Vec3 chord = at(i + 1) - at(i);
    const bool begins = !closed && i == 0, ends = !closed && i + 1 == pieces;
    const Vec3 first = begins ? Vec3(chord / 3.0) : handle(at(i) - at(i + count - 1), chord);
    const Vec3 last = ends ? Vec3(-chord / 3.0) : handle(at(i + 1) - at(i + 2), -chord);
    const Cubic cubic{at(i), at(i) + first, at(i + 1) + last, at(i + 1)};
    append(cubic, lengthUpTo(cubic, 1.0), kLengthError * chord.norm(), 0, controls_W);
  }
  controls_W.shrink_to_fit();
  return controls_W;
}

}  // namespace underact::curve
