#include "app/bindings/inverse.h"

#include <algorithm>
#include <cstring>
#include <functional>
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

/// Where each fact of a pose stands in its record, bytes. `_FACTS` in underact/arm.py says the same to numpy.
struct Record {
  explicit Record(std::size_t solutions)
      : max(solutions), branch(within + max), family(branch + 3 * max), size((family + max + 3) / 4 * 4) {}
  static constexpr std::size_t count = 0, reachable = 4, singular = 5, within = 6;
  std::size_t max, branch, family, size;
};

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

/// Where the answers go, for a thread without the interpreter's lock: joint values and a record for each pose. Two
/// arrays and not one for each fact: making an array takes a tenth of the time in which a pose is solved.
struct Out {
  Record record;
  std::size_t joints;
  double* q;
  std::uint8_t* facts;

  void write(std::size_t pose, const SolvedArm& arm, const kinematics::Answer& answer, Names& families) const {
    const std::size_t found = std::min(answer.found.size(), record.max);
    const auto count = static_cast<std::int32_t>(found);
    std::uint8_t* const to = facts + pose * record.size;
    std::fill_n(to, record.size, std::uint8_t{0});
    std::memcpy(to + Record::count, &count, sizeof count);
    to[Record::reachable] = answer.reachable;
    to[Record::singular] = answer.singular;
    double* const first = q + pose * record.max * joints;
    std::fill(first + found * joints, first + record.max * joints, kNotANumber);
    for (std::size_t k = 0; k < found; ++k) {
      const kinematics::Found& one = answer.found[k];
      kinematics::writeJoints(arm.chain(), one.q, std::span(first + k * joints, joints));
      to[Record::within + k] = one.within_limits;
      to[record.family + k] = families.numberOf(one.family);
      for (std::size_t i = 0; i < 3; ++i)
        to[record.branch + 3 * k + i] = static_cast<std::uint8_t>(static_cast<std::int8_t>(one.branch[i].choice));
    }
  }
};

/// All poses, checked before any is solved.
std::vector<Pose> posesOf(const Rows& rows) {
  std::vector<Pose> poses(rows.count);
  for (std::size_t i = 0; i < rows.count; ++i) {
    const Eigen::Matrix4d X = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(rows.row(i).data());
    if (const std::string wrong = kinematics::readPose(X, poses[i]); !wrong.empty())
      throw py::value_error((rows.lead.empty() ? std::string("X ") : "Pose " + std::to_string(i) + " of X ") + wrong);
  }
  return poses;
}

std::size_t maxOf(Method method, int search) {
  if (method == Method::Geometry) return chain::InverseSolutions{}.all.size();
  if (method == Method::Iteration) return static_cast<std::size_t>(std::max(1, search));
  return arm::Solutions{}.all.size();
}

py::tuple namesOf(const std::array<const char*, 3>& branches) {
  const auto named = static_cast<std::size_t>(std::count_if(branches.begin(), branches.end(), std::identity{}));
  py::tuple names(named);
  for (std::size_t i = 0, at = 0; i < branches.size(); ++i) {
    if (branches[i] != nullptr) names[at++] = py::str(branches[i]);
  }
  return names;
}

}  // namespace

py::tuple inverse(const SolvedArm& arm, const py::handle& X, const std::string& method, std::uint64_t seed, int search,
                  const py::handle& prefer) {
  constexpr std::size_t kMaxNumbers = 1U << 28;
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
  const std::size_t max = maxOf(chosen.value(), search);
  if (rows.count * max * arm.joints() > kMaxNumbers)
    throw py::value_error("The solutions of so many poses do not fit into one array: pass X in parts.");
  const std::vector<Pose> poses = posesOf(rows);
  const Record record(max);
  const auto solutions = static_cast<py::ssize_t>(max), joints = static_cast<py::ssize_t>(arm.joints());
  py::array_t<double> q = emptyRows(rows.lead, {solutions, joints});
  py::array_t<std::uint8_t> facts = emptyOf<std::uint8_t>(rows.lead, {static_cast<py::ssize_t>(record.size)});
  const Out out{record, arm.joints(), q.mutable_data(), facts.mutable_data()};
  Names families;
  std::array<const char*, 3> branch_names{};
  std::size_t largest = 0;
  forAll(rows.count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const kinematics::Answer answer = kinematics::solve(arm, poses[i], chosen.value(), options);
      if (!answer.found.empty() && branch_names[0] == nullptr) {
        for (std::size_t b = 0; b < 3; ++b) branch_names[b] = answer.found[0].branch[b].name;
      }
      largest = std::max(largest, std::min(answer.found.size(), max));
      out.write(i, arm, answer, families);
    }
  });
  return py::make_tuple(q, facts, largest, namesOf(branch_names), families.list());
}

}  // namespace underact::bindings
