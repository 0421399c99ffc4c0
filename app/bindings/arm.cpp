#include <algorithm>
#include <string>
#include <vector>

#include "app/bindings/inverse.h"
#include "app/bindings/numbers.h"
#include "app/bindings/parts.h"
#include "core/arm/arm_text.h"
#include "core/chain/redundancy.h"
#include "core/kinematics/forward.h"
#include "core/kinematics/solved_arm.h"
#include "core/kinematics/statics.h"
#include "core/kinematics/units.h"

namespace underact::bindings {
namespace {

using kinematics::kLargestAngle_rad;
using kinematics::SolvedArm;

constexpr double kLargestWrench = 1e6;

py::ssize_t jointsOf(const SolvedArm& arm) {
  return static_cast<py::ssize_t>(arm.joints());
}

Rows readJoints(const SolvedArm& arm, const py::handle& q) {
  return readRows(q, "q", {jointsOf(arm)}, kLargestAngle_rad);
}

template <class Matrix>
void writeMatrix(const Matrix& from, double* out) {
  for (Eigen::Index row = 0; row < from.rows(); ++row) {
    for (Eigen::Index column = 0; column < from.cols(); ++column) *out++ = from(row, column);
  }
}

py::object forward(const SolvedArm& arm, const py::handle& q) {
  const Rows rows = readJoints(arm, q);
  py::array_t<double> X_WT = emptyRows(rows.lead, {4, 4});
  double* const out = X_WT.mutable_data();
  forAll(rows.count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      writeMatrix(kinematics::poseOf(arm, kinematics::jointsOf(arm.chain(), rows.row(i))), out + 16 * i);
  });
  return X_WT;
}

py::object jacobian(const SolvedArm& arm, const py::handle& q) {
  const Rows rows = readJoints(arm, q);
  py::array_t<double> J = emptyRows(rows.lead, {6, jointsOf(arm)});
  double* const out = J.mutable_data();
  forAll(rows.count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      writeMatrix(kinematics::jacobianOf(arm, kinematics::jointsOf(arm.chain(), rows.row(i))),
                  out + 6 * arm.joints() * i);
  });
  return J;
}

/// det, manipulability, condition; and a list of the names of singularities for each pose.
py::tuple dexterity(const SolvedArm& arm, const py::handle& q) {
  const Rows rows = readJoints(arm, q);
  py::array_t<double> det = emptyRows(rows.lead, {}), manipulability = emptyRows(rows.lead, {});
  py::array_t<double> condition = emptyRows(rows.lead, {});
  double *const dets = det.mutable_data(), *const manipulabilities = manipulability.mutable_data();
  double* const conditions = condition.mutable_data();
  std::vector<std::vector<const char*>> singular(rows.count);
  forAll(rows.count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      kinematics::Dexterity one = kinematics::dexterityOf(arm, kinematics::jointsOf(arm.chain(), rows.row(i)));
      dets[i] = one.det_mm3, manipulabilities[i] = one.manipulability, conditions[i] = one.condition;
      singular[i] = std::move(one.singular);
    }
  });
  py::list names;
  for (const std::vector<const char*>& one : singular) {
    py::tuple all(one.size());
    for (std::size_t i = 0; i < one.size(); ++i) all[i] = py::str(one[i]);
    names.append(all);
  }
  return py::make_tuple(det, manipulability, condition, names);
}

/// A wrench's vector for each pose: as many as there are, or one for all.
Rows readVectors(const py::handle& given, const char* name, const Rows& poses) {
  Rows rows = readRows(given, name, {3}, kLargestWrench);
  if (rows.lead != poses.lead && !rows.lead.empty())
    throw py::value_error(std::string(name) + " must have the shape (3,), or one vector for each pose of q.");
  return rows;
}

Vec3 vectorAt(const Rows& rows, std::size_t index) {
  const std::span<const double> row = rows.row(rows.lead.empty() ? 0 : index);
  return {row[0], row[1], row[2]};
}

/// torque, holding (None: no masses), gains, axes.
py::tuple statics(const SolvedArm& arm, const py::handle& q, const py::handle& force, const py::handle& moment) {
  const Rows rows = readJoints(arm, q);
  const Rows f_N = readVectors(force, "f_N", rows), moment_N_mm = readVectors(moment, "moment_N_mm", rows);
  const std::size_t joints = arm.joints();
  py::array_t<double> torque = emptyRows(rows.lead, {jointsOf(arm)}), holding = emptyRows(rows.lead, {jointsOf(arm)});
  py::array_t<double> gains = emptyRows(rows.lead, {3}), axes = emptyRows(rows.lead, {3, 3});
  double *const torques = torque.mutable_data(), *const holdings = holding.mutable_data();
  double *const all_gains = gains.mutable_data(), *const all_axes = axes.mutable_data();
  forAll(rows.count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const kinematics::Statics one = kinematics::staticsOf(arm, kinematics::jointsOf(arm.chain(), rows.row(i)),
                                                            vectorAt(f_N, i), vectorAt(moment_N_mm, i));
      std::copy(one.torque.begin(), one.torque.end(), torques + joints * i);
      std::copy(one.holding.begin(), one.holding.end(), holdings + joints * i);
      std::copy(one.gains_mm.begin(), one.gains_mm.end(), all_gains + 3 * i);
      writeMatrix(one.axes_W, all_axes + 9 * i);
    }
  });
  return py::make_tuple(torque, arm.model.masses.empty() ? py::object(py::none()) : py::object(holding), gains, axes);
}

py::object nullSpace(const SolvedArm& arm, const py::handle& q) {
  constexpr double kRelative = 1e-6;  // arm::kSingularSine, as of the command line
  const Rows rows = readJoints(arm, q);
  if (!rows.lead.empty())
    throw py::value_error("q must have the shape (" + std::to_string(arm.joints()) + ",): one pose.");
  const chain::JointValues values = kinematics::jointsOf(arm.chain(), rows.row(0));
  const auto basis = chain::nullSpace(arm.chain(), std::span(values).first(arm.joints()), arm.inverse.asks, kRelative);
  py::array_t<double> all = emptyRows({static_cast<py::ssize_t>(basis.size())}, {jointsOf(arm)});
  double* out = all.mutable_data();
  for (const std::vector<double>& one : basis) out = std::copy(one.begin(), one.end(), out);
  return all;
}

/// The points of a drawing of the arm: its base, each joint's axis and the tip, mm.
py::object skeleton(const SolvedArm& arm, const py::handle& q) {
  const Rows rows = readJoints(arm, q);
  const py::ssize_t points = jointsOf(arm) + 2;
  py::array_t<double> all = emptyRows(rows.lead, {points, 3});
  double* const out = all.mutable_data();
  forAll(rows.count, [&](std::size_t first, std::size_t last) {
    std::vector<Pose> X_WLinks(arm.joints());
    for (std::size_t i = first; i < last; ++i) {
      const chain::JointValues values = kinematics::jointsOf(arm.chain(), rows.row(i));
      const Pose X_WT = chain::forward(arm.chain(), std::span(values).first(arm.joints()), X_WLinks);
      Eigen::Map<Eigen::Matrix<double, 3, Eigen::Dynamic>> at(out + static_cast<std::size_t>(3 * points) * i, 3,
                                                              points);
      at.col(0) = 1e3 * arm.model.X_WB.translation();
      for (std::size_t joint = 0; joint < arm.joints(); ++joint)
        at.col(static_cast<Eigen::Index>(joint) + 1) = 1e3 * (X_WLinks[joint] * arm.chain().joints[joint].p_WJ);
      at.col(points - 1) = 1e3 * X_WT.translation();
    }
  });
  return all;
}

py::list jointFacts(const SolvedArm& arm) {
  py::list all;
  for (std::size_t i = 0; i < arm.joints(); ++i) {
    const arm::JointFacts& facts = arm.model.joints[i];
    const chain::Joint& joint = arm.chain().joints[i];
    const double unit = kinematics::turns(joint) ? 1.0 : 1e3;
    all.append(py::make_tuple(facts.name, kinematics::turns(joint), unit * joint.min, unit * joint.max, facts.driven,
                              facts.sensed));
  }
  return all;
}

std::string textOf(const SolvedArm& arm, const std::string& form) {
  const bool is_known = form == "dh" || form == "poe" || form == "urdf";
  if (!is_known) throw py::value_error("form must be \"dh\", \"poe\" or \"urdf\".");
  const Result<std::string> text = arm::textOf(arm.model, form == "urdf"  ? arm::ArmForm::Urdf
                                                          : form == "poe" ? arm::ArmForm::Exponentials
                                                                          : arm::ArmForm::ModifiedDh);
  if (!text) raiseProblems(text.problems());
  return text.value();
}

py::object withinLimits(const SolvedArm& arm, const py::handle& q) {
  const Rows rows = readJoints(arm, q);
  py::array_t<bool> within = emptyOf<bool>(rows.lead, {});
  bool* const out = within.mutable_data();
  forAll(rows.count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const chain::JointValues values = kinematics::jointsOf(arm.chain(), rows.row(i));
      out[i] = arm::isWithinLimits(arm.model, std::span(values).first(arm.joints()));
    }
  });
  return within;
}

py::list names() {
  py::list all;
  for (const arm::Model& model : arm::models()) all.append(model.name);
  return all;
}

SolvedArm load(const std::string& name, const std::string& base, const std::string& tip) {
  Result<SolvedArm> arm = kinematics::chooseArm(name, {base, tip});
  if (!arm) raiseProblems(arm.problems());
  return std::move(arm).value();
}

}  // namespace

void addArm(py::module_& core) {
  core.def("arm_names", &names);
  madeClass<SolvedArm>(core, "Arm")
      .def(py::init(&load), py::arg("name"), py::arg("base") = "", py::arg("tip") = "")
      .def("fk", &forward, py::arg("q"), "The pose of the stylus or tool, (..., 4, 4), translation in mm. q: (..., n).")
      .def("jacobian", &jacobian, py::arg("q"), "The Jacobian, (..., 6, n): v in mm/rad above w, in W. q: (..., n).")
      .def("within_limits", &withinLimits, py::arg("q"),
           "Whether all joints are within their limits, (...). q: (..., n).")
      .def("null_space", &nullSpace, py::arg("q"),
           "(m, n): motions of the joints that leave the tip where it is, a row each. q: (n,).")
      .def("skeleton", &skeleton, py::arg("q"),
           "(..., n + 2, 3), mm: the base, a point on each joint's axis, the tip. q: (..., n).")
      .def("_dexterity", &dexterity)
      .def("_statics", &statics)
      .def("_ik", &inverse)
      .def("_text", &textOf)
      .def("_joints", &jointFacts)
      .def_property_readonly("name", [](const SolvedArm& arm) { return arm.model.name; })
      .def_property_readonly("title", [](const SolvedArm& arm) { return arm.model.title; })
      .def_property_readonly("provenance", [](const SolvedArm& arm) { return arm.model.provenance; })
      .def_property_readonly("n", &jointsOf)
      .def_property_readonly("haptic", [](const SolvedArm& arm) { return arm.model.device.has_value(); })
      .def_property_readonly("reach_mm", [](const SolvedArm& arm) { return 1e3 * chain::reachOf(arm.flange); });
}

}  // namespace underact::bindings
