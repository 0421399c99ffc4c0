#pragma once
#include <array>
#include <span>

#include "core/chain/chain.h"

namespace underact::chain {

/// The joints of a chain of three for a position, at most eight. Not polished: right to some 1e-9 of the reach, and
/// near a singularity to the root of that; an answer that reaches nothing can be among them.
struct PositionAnswers {
  std::array<std::array<double, 3>, 8> all{};
  std::size_t count = 0;
};

/// Whether three joints have the position of a point in closed form: any three, revolute or prismatic, but those that
/// move it in a plane or on a line only, or about one axis twice.
bool placesPoint(std::span<const Joint, 3> joints, const Vec3& p_home) noexcept;

/// All values of three joints that take a point from p_home to p_wanted (m, in W, both with the joints' home). Angles
/// in no certain turn. An equation of degree 1, 2 or 4 in the third joint. Joints that are free (a point on the first
/// axis) are 0. Source: Pieper 1968; Craig, Introduction to Robotics, section 4.6.
PositionAnswers solvePosition(std::span<const Joint, 3> joints, const Vec3& p_home, const Vec3& p_wanted) noexcept;

}  // namespace underact::chain
