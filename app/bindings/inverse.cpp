#include "app/bindings/inverse.h"

#include <algorithm>
#include <atomic>
#include <utility>
#include <vector>

#include "app/bindings/numbers.h"
#include "core/arm/branches.h"
#include "core/kinematics/inverse.h"
#include "core/kinematics/units.h"

namespace underact::bindings {
namespace {

using kinematics::Method;
using kinematics::SolvedArm;

/// The arrays that are filled, a place for each pose and each of the most solutions that there can be.
struct Solved {
  std::size_t most = 0, joints = 0;
  py::array_t<double> q;
  py::array_t<std::int32_t> count;
  py::array_t<bool> reachable, singular, within;
  py::array_t<std::int8_t> branch;
  py::array_t<std::uint8_t> family;
};

Solved makeSolved(const std::vector<py::ssize_t>& lead, std::size_t most, std::size_t joints) {
  const auto k = static_cast<py::ssize_t>(most);
  return {most,
          joints,
          emptyRows(lead, {k, static_cast<py::ssize_t>(joints)}),
          emptyOf<std::int32_t>(lead, {}),
          emptyOf<bool>(lead, {}),
          emptyOf<bool>(lead, {}),
          emptyOf<bool>(lead, {k}),
          emptyOf<std::int8_t>(lead, {k, 3}),
          emptyOf<std::uint8_t>(lead, {k})};
}

/// The names that appeared, in the order in which they did; 0 is none.
class Names {
 public:
  std::uint8_t numberOf(const std::string& name) {
    if (name.empty()) return 0;
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found != names_.end()) return static_cast<std::uint8_t>(found - names_.begin() + 1);
    if (names_.size() == 254) return 255;  // more kinds of self-motion than an arm of sixteen joints shows
    names_.push_back(name);
    return static_cast<std::uint8_t>(names_.size());
  }
  py::list list() const {
    py::list all;
    all.append("");
    for (const std::string& name : names_) all.append(name);
    return all;
  }

 private:
  std::vector<std::string> names_;
};

/// Where the arrays' data are, for a thread without the interpreter's lock.
struct Out {
  explicit Out(Solved& to)
      : most(to.most),
        joints(to.joints),
        q(to.q.mutable_data()),
        count(to.count.mutable_data()),
        reachable(to.reachable.mutable_data()),
        singular(to.singular.mutable_data()),
        within(to.within.mutable_data()),
        branch(to.branch.mutable_data()),
        family(to.family.mutable_data()) {}

  void write(std::size_t pose, const SolvedArm& arm, const kinematics::Answer& answer, Names& families) const {
    const std::size_t found = std::min(answer.found.size(), most);
    count[pose] = static_cast<std::int32_t>(found);
    reachable[pose] = answer.reachable;
    singular[pose] = answer.singular;
    for (std::size_t k = 0; k < most; ++k) {
      const std::size_t at = pose * most + k;
      const std::span<double> joint_values(q + at * joints, joints);
      if (k >= found) {
        std::fill(joint_values.begin(), joint_values.end(), kNotANumber);
        std::fill_n(branch + 3 * at, 3, std::int8_t{0});
        within[at] = false;
        family[at] = 0;
        continue;
      }
      const kinematics::Found& one = answer.found[k];
      kinematics::writeJoints(arm.chain(), one.q, joint_values);
      within[at] = arm::isWithinLimits(arm.model, std::span(one.q).first(joints));
      family[at] = families.numberOf(one.family);
      for (std::size_t i = 0; i < 3; ++i) branch[3 * at + i] = static_cast<std::int8_t>(one.branch[i].choice);
    }
  }

  std::size_t most, joints;
  double* q;
  std::int32_t* count;
  bool *reachable, *singular, *within;
  std::int8_t* branch;
  std::uint8_t* family;
};

/// All poses, checked before any is solved.
std::vector<Pose> posesOf(const Rows& rows) {
  std::vector<Pose> poses(rows.count);
  for (std::size_t i = 0; i < rows.count; ++i) {
    const Eigen::Matrix4d X = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(rows.row(i).data());
    if (const char* const wrong = kinematics::readPose(X, poses[i]))
      throw py::value_error((rows.lead.empty() ? std::string("X ") : "Pose " + std::to_string(i) + " of X ") + wrong);
  }
  return poses;
}

std::size_t mostOf(Method method, int search) {
  if (method == Method::Geometry) return chain::InverseSolutions{}.all.size();
  if (method == Method::Iteration) return static_cast<std::size_t>(std::max(1, search));
  return arm::Solutions{}.all.size();
}

}  // namespace

py::tuple inverse(const SolvedArm& arm, const py::handle& X, const std::string& method, std::uint64_t seed, int search,
                  const py::handle& prefer) {
  constexpr std::size_t kMostNumbers = 1U << 28;
  const Result<Method> chosen = kinematics::methodFor(arm, method);
  if (!chosen) raiseProblems(chosen.problems());
  const Rows rows = readRows(X, "X", {4, 4}, kinematics::kFarthest_mm);
  kinematics::InverseOptions options{method, seed, search, {}};
  if (!prefer.is_none()) {
    const Rows posture =
        readRows(prefer, "prefer", {static_cast<py::ssize_t>(arm.joints())}, kinematics::kLargestAngle_rad);
    if (!posture.lead.empty()) throw py::value_error("prefer must be one posture.");
    const chain::JointValues values = kinematics::jointsOf(arm.chain(), posture.row(0));
    options.posture.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(arm.joints()));
  }
  const std::size_t most = mostOf(chosen.value(), search);
  if (rows.count * most * arm.joints() > kMostNumbers)
    throw py::value_error("The solutions of so many poses do not fit into one array: pass X in parts.");
  const std::vector<Pose> poses = posesOf(rows);
  Solved solved = makeSolved(rows.lead, most, arm.joints());
  const Out out(solved);
  Names families;
  std::array<const char*, 3> branch_names{};
  forAll(rows.count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const kinematics::Answer answer = kinematics::solve(arm, poses[i], chosen.value(), options);
      if (!answer.found.empty() && branch_names[0] == nullptr) {
        for (std::size_t b = 0; b < 3; ++b) branch_names[b] = answer.found[0].branch[b].name;
      }
      out.write(i, arm, answer, families);
    }
  });
  const std::int32_t* const counts = solved.count.data();
  const std::int32_t largest = rows.count == 0 ? 0 : *std::max_element(counts, counts + rows.count);
  py::list names;
  for (const char* const name : branch_names) {
    if (name != nullptr) names.append(name);
  }
  return py::make_tuple(solved.q, solved.count, solved.reachable, solved.singular, solved.within, solved.branch,
                        solved.family, names, families.list(), largest);
}

}  // namespace underact::bindings
