#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/kinematics/solved_arm.h"

namespace underact::kinematics {

/// How the joints are found.
enum class Method : std::uint8_t { StraightLine, ClosedForm, Geometry, Iteration };

/// What is asked for besides the pose.
struct InverseOptions {
  std::string method = "auto";  // auto, closed_form, iterative
  std::uint64_t seed = 1;       // of the iteration's restarts
  int search = 0;               // of the iteration: from so many starts, all; 0: the first one of up to 101
  std::vector<double> posture;  // to begin the list near to, and the iteration; rad, m where it slides
};

/// The method that the arm has. Problems: a closed form was asked for, and it has none.
Result<Method> methodFor(const SolvedArm& arm, std::string_view method);

/// One solution, however it was found.
struct Found {
  chain::JointValues q{};                       // rad, m where the joint slides
  bool within_limits = false;                   // all joints, as they stand
  std::string family;                           // "q1 free", "q4+q6", ... of one of infinitely many; empty: isolated
  std::array<chain::BranchName, 3> branch{};    // without a name: the arm has no closed form
  std::vector<std::vector<double>> null_space;  // of an arm with more joints than the pose needs
};

/// All that were found for a pose.
struct Answer {
  bool reachable = false;
  bool singular = false;
  std::vector<Found> found;
  bool at_shoulder = false, at_elbow = false, at_wrist = false;  // where, of the straight-line code
};

/// The joints for a pose. Joints that turn are moved by full turns within their limits where these allow it, to the
/// turn nearest to the posture, else to zero; with a posture those within the limits come first, the nearest of them
/// at the head. The iteration searches within the limits, and beyond them where it finds nothing there. Not for the
/// servo thread.
Answer solve(const SolvedArm& arm, const Pose& X_WT, Method method, const InverseOptions& options);

/// Whether the arm has joints to spare, so that solutions have a null space.
bool hasSurplus(const SolvedArm& arm) noexcept;

}  // namespace underact::kinematics
