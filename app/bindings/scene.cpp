#include "app/bindings/scene.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "app/bindings/numbers.h"
#include "app/bindings/parts.h"
#include "core/arm/inverse.h"
#include "core/base/nearest_rotation.h"
#include "core/base/units.h"
#include "core/kinematics/units.h"
#include "core/manipulator/energy.h"
#include "core/safety/gate.h"
#include "core/scene/compile.h"
#include "core/scene/load_meshes.h"
#include "core/scene/mesh_notes.h"
#include "core/scene/read.h"
#include "core/scene/settings.h"
#include "core/scene/write.h"
#include "core/tick/rest.h"

namespace underact::bindings {
namespace {

constexpr double kFarthestTip_mm =
    1e100;  // beyond it the squares of coordinates in m could leave the range of a double

py::list problemList(const Problems& problems) {
  py::list all;
  for (const Problem& problem : problems) {
    const SourceLocation& place = problem.place;
    all.append(py::make_tuple(std::string(problem.sentence), place.file, place.line, place.column, place.key));
  }
  return all;
}

/// A scene, or the list of its problems.
py::object madeOf(Result<scene::Description> description) {
  if (!description) return problemList(description.problems());
  Result<tick::TickProgram> program = [&] {
    const py::gil_scoped_release unlocked;  // meshes may take seconds
    return scene::loadAndCompile(description.value());
  }();
  if (!program) return problemList(program.problems());
  return py::cast(Scene{std::move(description).value(), std::move(program).value()});
}

py::object readText(const std::string& text, const std::string& file) {
  return madeOf(scene::readScene(text, file));
}

py::object readFile(const std::string& path) {
  return madeOf(scene::readSceneFile(path));
}

/// The stylus at each pose; R_WT may be None.
struct Stylus {
  Rows p_mm, R_WT;
  bool turns = false;
  Vec3 position(std::size_t i) const {
    const std::span<const double> p = p_mm.row(i);
    return kMetrePerMillimetre * Vec3(p[0], p[1], p[2]);
  }
  Mat3 orientation(std::size_t i) const {
    if (!turns) return Mat3::Identity();
    return meantRotation(given(i));
  }
  Mat3 given(std::size_t i) const {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(R_WT.row(R_WT.lead.empty() ? 0 : i).data());
  }
};

Stylus readStylus(const py::handle& p_mm, const py::handle& R_WT) {
  Stylus stylus{readRows(p_mm, "p_mm", {3}, kFarthestTip_mm), {}, !R_WT.is_none()};
  if (!stylus.turns) return stylus;
  stylus.R_WT = readRows(R_WT, "R_WT", {3, 3}, 2.0);
  if (!stylus.R_WT.lead.empty() && stylus.R_WT.lead != stylus.p_mm.lead)
    throw py::value_error("R_WT must have the shape (3, 3), or one matrix for each position.");
  for (std::size_t i = 0; i < stylus.R_WT.count; ++i) {
    const Mat3 R = stylus.given(i);
    if (const std::string wrong = kinematics::rotationWrong(R); !wrong.empty()) throw py::value_error("R_WT " + wrong);
  }
  return stylus;
}

/// Where the results of target() go: of all constraints together, and of each.
struct Targets {
  Targets(const std::vector<py::ssize_t>& lead, py::ssize_t held)
      : force(emptyRows(lead, {3})),
        safe(emptyRows(lead, {3})),
        status(emptyOf<std::uint8_t>(lead, {})),
        each_q(emptyRows(lead, {held, 3})),
        each_force(emptyRows(lead, {held, 3})),
        each_distance(emptyRows(lead, {held})),
        each_status(emptyOf<std::uint8_t>(lead, {held})),
        each_acts(emptyOf<bool>(lead, {held})) {}
  py::tuple tuple() const {
    return py::make_tuple(force, safe, status, each_q, each_force, each_distance, each_status, each_acts);
  }
  py::array_t<double> force, safe;
  py::array_t<std::uint8_t> status;
  py::array_t<double> each_q, each_force, each_distance;
  py::array_t<std::uint8_t> each_status;
  py::array_t<bool> each_acts;
};

/// Writes three numbers at the place of a row.
void put(double* to, std::size_t row, const Vec3& value) {
  std::copy_n(value.data(), 3, to + 3 * row);
}

py::tuple targets(const Scene& scene, const py::handle& p_mm, const py::handle& R_WT) {
  const Stylus stylus = readStylus(p_mm, R_WT);
  const std::size_t held = scene.program.entries.size();
  const double max_force_N = scene.program.limits.max_force_N;
  Targets to(stylus.p_mm.lead, static_cast<py::ssize_t>(held));
  double *const force = to.force.mutable_data(), *const safe = to.safe.mutable_data();
  double *const each_q = to.each_q.mutable_data(), *const each_force = to.each_force.mutable_data();
  double* const each_distance = to.each_distance.mutable_data();
  std::uint8_t *const status = to.status.mutable_data(), *const each_status = to.each_status.mutable_data();
  bool* const each_acts = to.each_acts.mutable_data();
  std::size_t unreached = stylus.p_mm.count;
  forAll(stylus.p_mm.count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Vec3 p_WT = stylus.position(i);
      if (scene.program.needs.joints && !arm::solvePosition(scene.program.geometry, p_WT).reachable) {
        unreached = i;
        return;
      }
      const tick::TickReport report = tick::evaluateAtRest(scene.program, p_WT, stylus.orientation(i));
      put(force, i, report.f_T_W);
      put(safe, i, safety::clampForce(report.f_T_W, max_force_N));
      status[i] = static_cast<std::uint8_t>(tick::statusOf(report.held));
      for (std::size_t c = 0; c < held; ++c) {
        const tick::ConstraintReport& one = report.held[c];
        const bool is_unique = one.status == target::Status::Unique;
        const std::size_t at = i * held + c;
        put(each_q, at, is_unique ? Vec3(kMillimetrePerMetre * one.p_WP) : Vec3(Vec3::Constant(kNotANumber)));
        put(each_force, at, one.f_T_W);
        each_distance[at] = kMillimetrePerMetre * one.distance_m;
        each_status[at] = static_cast<std::uint8_t>(one.status);
        each_acts[at] = one.acts && is_unique;
      }
    }
  });
  if (unreached < stylus.p_mm.count)
    throw py::value_error("The arm cannot reach position " + std::to_string(unreached) +
                          ", and the scene controls it in joint space.");
  return to.tuple();
}

py::object valueOf(const scene::SettingValue& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return py::bool_(*flag);
  if (const auto* number = std::get_if<double>(&value)) return py::float_(*number);
  if (const auto* text = std::get_if<std::string>(&value)) return py::str(*text);
  if (const auto* vector = std::get_if<Vec3>(&value)) return py::make_tuple((*vector)[0], (*vector)[1], (*vector)[2]);
  return py::none();
}

py::object settingValue(const Scene& scene, const std::string& path) {
  const Result<scene::SettingValue> value = scene::valueAt(scene.description, path);
  if (!value) raiseProblems(value.problems());
  return valueOf(value.value());
}

/// The scene with other values, as text, all at once; or the list of problems.
py::object withValues(const Scene& scene, const std::vector<std::pair<std::string, std::string>>& values) {
  scene::Description changed = scene.description;
  for (const auto& [path, text] : values) {
    Result<scene::Description> next = scene::withText(changed, path, text);
    if (!next) return problemList(next.problems());
    changed = std::move(next).value();
  }
  const Problems problems = scene::check(changed);
  if (!problems.empty()) return problemList(problems);
  return madeOf(std::move(changed));
}

py::list settings() {
  py::list all;
  for (const scene::Setting& one : scene::settings()) {
    py::object words = py::none();
    if (one.words != nullptr) words = py::cast(one.words());
    all.append(py::make_tuple(scene::pathOf(one), one.label, one.tip, one.unit, one.min, one.max, words));
  }
  return all;
}

const manipulator::Manipulator& robotOf(const Scene& scene, std::size_t index) {
  if (index >= scene.program.entries.size()) throw py::index_error("The scene has no such constraint.");
  const auto* robot = std::get_if<manipulator::Manipulator>(&scene.program.entries[index].constraint.goal);
  if (robot == nullptr) throw py::value_error("This constraint is no virtual manipulator.");
  return *robot;
}

/// energy_J, slope, force, moment of the virtual manipulator at joint values theta.
py::tuple energy(const Scene& scene, std::size_t index, const py::handle& X, const py::handle& theta) {
  const manipulator::Manipulator& robot = robotOf(scene, index);
  const std::size_t joints = robot.chain.joints.size();
  const Rows poses = readRows(X, "X_WT", {4, 4}, kinematics::kFarthest_mm);
  const Rows values = readRows(theta, "theta", {static_cast<py::ssize_t>(joints)}, kinematics::kLargestAngle_rad);
  if (!poses.lead.empty() && poses.lead != values.lead)
    throw py::value_error("X_WT must have the shape (4, 4), or one pose for each theta.");
  std::vector<Pose> stylus(poses.count);
  for (std::size_t i = 0; i < poses.count; ++i) {
    const Eigen::Matrix4d matrix = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(poses.row(i).data());
    if (const std::string wrong = kinematics::readPose(matrix, stylus[i]); !wrong.empty())
      throw py::value_error(std::string("X_WT ") + wrong);
  }
  py::array_t<double> energy_J = emptyRows(values.lead, {});
  py::array_t<double> slope = emptyRows(values.lead, {static_cast<py::ssize_t>(joints)});
  py::array_t<double> force = emptyRows(values.lead, {3}), moment = emptyRows(values.lead, {3});
  double *const energies = energy_J.mutable_data(), *const slopes = slope.mutable_data();
  double *const forces = force.mutable_data(), *const moments = moment.mutable_data();
  forAll(values.count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const chain::JointValues q = kinematics::jointsOf(robot.chain, values.row(i));
      manipulator::Values at{};
      std::copy_n(q.begin(), at.size(), at.begin());
      manipulator::Energy found;
      manipulator::evaluate(robot, stylus[poses.lead.empty() ? 0 : i], at, found);
      energies[i] = found.energy_J;
      for (std::size_t j = 0; j < joints; ++j) {  // N mm/rad, or N
        const double unit = kinematics::turns(robot.chain.joints[j]) ? kMillimetrePerMetre : 1.0;
        slopes[i * joints + j] = unit * found.slope[j];
      }
      put(forces, i, found.f_W);
      put(moments, i, kMillimetrePerMetre * found.m_W);
    }
  });
  return py::make_tuple(energy_J, slope, force, moment);
}

/// The joints of least energy of a virtual manipulator for each pose of the stylus, as target() finds them.
py::tuple minEnergy(const Scene& scene, std::size_t index, const py::handle& p_mm, const py::handle& R_WT) {
  const manipulator::Manipulator& robot = robotOf(scene, index);
  const std::size_t joints = robot.chain.joints.size();
  const Stylus stylus = readStylus(p_mm, R_WT);
  py::array_t<double> theta = emptyRows(stylus.p_mm.lead, {static_cast<py::ssize_t>(joints)});
  py::array_t<double> normal = emptyRows(stylus.p_mm.lead, {3}), moment = emptyRows(stylus.p_mm.lead, {3});
  double *const thetas = theta.mutable_data(), *const normals = normal.mutable_data();
  double* const moments = moment.mutable_data();
  forAll(stylus.p_mm.count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const tick::TickReport report = tick::evaluateAtRest(scene.program, stylus.position(i), stylus.orientation(i));
      const target::Robot& found = report.held[index].robot;
      for (std::size_t j = 0; j < joints; ++j)
        thetas[i * joints + j] =
            kinematics::turns(robot.chain.joints[j]) ? found.theta[j] : kMillimetrePerMetre * found.theta[j];
      put(normals, i, found.n_W);
      put(moments, i, kMillimetrePerMetre * found.moment_W);
    }
  });
  return py::make_tuple(theta, normal, moment);
}

/// Corners in W, mm, (m, 3), and faces, (k, 3), of the mesh at index, as it is felt.
py::tuple meshOf(const Scene& scene, std::size_t index) {
  if (index >= scene.description.constraints.size()) throw py::index_error("The scene has no such constraint.");
  const auto* const mesh = std::get_if<scene::Mesh>(&scene.description.constraints[index].shape);
  if (mesh == nullptr) throw py::value_error("This constraint is no mesh.");
  const mesh::Surface& surface = *mesh->surface;
  const std::vector<Eigen::Vector3f>& from = surface.triangles.p_MV;
  const std::vector<mesh::Face>& triangles = surface.triangles.faces;
  py::array_t<double> corners = emptyRows({static_cast<py::ssize_t>(from.size())}, {3});
  py::array_t<std::int32_t> faces = emptyOf<std::int32_t>({static_cast<py::ssize_t>(triangles.size())}, {3});
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec3 p_mm = mesh->scale_mm_per_unit * (from[i].cast<double>() + surface.origin_M);
    put(corners.mutable_data(), i, mesh->X_WM.topLeftCorner<3, 3>() * p_mm + mesh->X_WM.topRightCorner<3, 1>());
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) std::copy_n(triangles[i].begin(), 3, faces.mutable_data() + 3 * i);
  return py::make_tuple(corners, faces);
}

py::list constraintFacts(const Scene& scene) {
  py::list all;
  for (const scene::Constraint& one : scene.description.constraints)
    all.append(py::make_tuple(one.name, scene::typeName(one.shape)));
  return all;
}

}  // namespace

void addScene(py::module_& core) {
  core.def("read_scene_text", &readText);
  core.def("read_scene_file", &readFile);
  core.def("settings", &settings);
  madeClass<Scene>(core, "Scene")
      .def("_targets", &targets)
      .def("_value", &settingValue)
      .def("_with", &withValues)
      .def("_energy", &energy)
      .def("_least_energy", &minEnergy)
      .def("_mesh", &meshOf)
      .def("_constraints", &constraintFacts)
      .def("_notes", [](const Scene& scene) { return problemList(scene::meshNotes(scene.description)); })
      .def_property_readonly("title", [](const Scene& scene) { return scene.description.title; })
      .def_property_readonly("about", [](const Scene& scene) { return scene.description.about; })
      .def_property_readonly("arm", [](const Scene& scene) { return scene.description.arm; })
      .def_property_readonly("file", [](const Scene& scene) { return scene.description.file; })
      .def_property_readonly("max_force_N", [](const Scene& scene) { return scene.program.limits.max_force_N; })
      .def_property_readonly("text", [](const Scene& scene) { return scene::writeScene(scene.description); });
}

}  // namespace underact::bindings
