#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/arm/branches.h"
#include "core/arm/model.h"
#include "core/kinematics/inverse.h"

namespace underact::gui {

/// An inverse solution as the panel lists it and the view draws it.
struct NumberedSolution {
  int number = 0;        // from 1; of a closed form with named branches that of the branch, whichever others there are
  arm::JointAngles q{};  // rad, or m where the joint slides
  bool within_limits = false;
  std::string family;                         // "q1 free", "q4+q6", ... of one of infinitely many; empty: isolated
  std::array<chain::BranchName, 3> branch{};  // without a name: the arm has no closed form
  std::vector<std::vector<double>> null_space = {};  // of an arm with joints to spare
};

/// All that there are for a pose, or all that a search finds.
struct NumberedSolutions {
  std::vector<NumberedSolution> all;  // by number
  bool is_searched = false;           // from kSearchStarts starts; else there are no others
  bool has_surplus = false;           // joints to spare: infinitely many solutions, of which these are some
  bool at_shoulder = false, at_elbow = false, at_wrist = false;  // singular there, of an arm that solvesInTick()
  /// The one of that number, or null.
  const NumberedSolution* find(int number) const;
};

/// The starts of the search, for an arm without a closed form: joints at 0, then draws within the limits from seed 1,
/// as `underact-cli ik --search 16`.
inline constexpr int kSearchStarts = 16;
inline constexpr int kMaxSolutions = 16;

/// What finds the solutions of an arm, in the same way for panel and view, and as underact-cli and the Python package
/// do. Not for the servo thread.
class SolutionFinder {
 public:
  SolutionFinder() = default;
  explicit SolutionFinder(const arm::Model& model);
  NumberedSolutions at(const Pose& X_WT) const;
  const arm::Model& model() const { return arm_.model; }

 private:
  kinematics::SolvedArm arm_;
  kinematics::Method method_ = kinematics::Method::Iteration;
};

/// 1 to 8, the number of a solution that has a branch: ordered by shoulder, elbow, wrist, + before -.
int numberOf(const arm::Branch& branch);
/// number: 1 to 8.
arm::Branch branchOf(int number);

}  // namespace underact::gui
