#include "app/gui/model/numbered_solutions.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace underact::gui {
namespace {

/// The branch, where the form names all three.
std::optional<arm::Branch> namedBranch(const std::array<chain::BranchName, 3>& branch) {
  const std::array<const char*, 3> names{"shoulder", "elbow", "wrist"};
  for (std::size_t index = 0; index < names.size(); ++index) {
    if (branch[index].name == nullptr || std::strcmp(branch[index].name, names[index]) != 0) return {};
  }
  const auto sign = [&](std::size_t index) { return static_cast<std::int8_t>(branch[index].choice < 0 ? -1 : 1); };
  return arm::Branch{sign(0), sign(1), sign(2)};
}

/// By their branches, where all have one and no two the same; else in their order.
void number(std::vector<NumberedSolution>& all) {
  const bool have_branches = std::all_of(
      all.begin(), all.end(), [](const NumberedSolution& one) { return namedBranch(one.branch).has_value(); });
  for (std::size_t index = 0; index < all.size(); ++index)
    all[index].number = have_branches ? numberOf(*namedBranch(all[index].branch)) : static_cast<int>(index) + 1;
  const auto by_number = [](const NumberedSolution& a, const NumberedSolution& b) { return a.number < b.number; };
  std::stable_sort(all.begin(), all.end(), by_number);
  for (std::size_t index = 1; index < all.size(); ++index) {
    if (all[index].number <= all[index - 1].number) all[index].number = all[index - 1].number + 1;
  }
}

}  // namespace

const NumberedSolution* NumberedSolutions::find(int number) const {
  const auto found =
      std::find_if(all.begin(), all.end(), [number](const NumberedSolution& one) { return one.number == number; });
  return found == all.end() ? nullptr : &*found;
}

SolutionFinder::SolutionFinder(const arm::Model& model)
    : arm_(kinematics::solvedArm(model)), method_(kinematics::methodFor(arm_, "auto").value()) {}

NumberedSolutions SolutionFinder::at(const Pose& X_WT) const {
  kinematics::InverseOptions options;
  options.search = kSearchStarts;
  NumberedSolutions found;
  found.is_searched = method_ == kinematics::Method::Iteration;
  found.has_surplus = kinematics::hasSurplus(arm_);
  const std::size_t joints = arm_.joints();
  const kinematics::Answer answer = kinematics::solve(arm_, X_WT, method_, options);
  found.at_shoulder = answer.at_shoulder;
  found.at_elbow = answer.at_elbow;
  found.at_wrist = answer.at_wrist;
  for (const kinematics::Found& one : answer.found) {
    NumberedSolution solution{0, {}, one.within_limits, one.family, one.branch, one.null_space};
    std::copy_n(one.q.begin(), joints, solution.q.begin());
    found.all.push_back(std::move(solution));
    if (found.all.size() == kMaxSolutions) break;
  }
  number(found.all);
  return found;
}

int numberOf(const arm::Branch& branch) {
  return 1 + (branch.shoulder < 0 ? 4 : 0) + (branch.elbow < 0 ? 2 : 0) + (branch.wrist < 0 ? 1 : 0);
}

arm::Branch branchOf(int number) {
  const auto sign = [bits = number - 1](int bit) { return static_cast<std::int8_t>((bits & bit) != 0 ? -1 : 1); };
  return {sign(4), sign(2), sign(1)};
}

}  // namespace underact::gui
