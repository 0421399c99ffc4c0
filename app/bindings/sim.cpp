#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/bindings/numbers.h"
#include "app/bindings/parts.h"
#include "app/bindings/simulation.h"
#include "core/base/nearest_rotation.h"
#include "core/base/units.h"
#include "core/kinematics/units.h"
#include "core/record/tick_table.h"
#include "core/sim/arm_model.h"

namespace underact::bindings {
namespace {

std::unique_ptr<Simulation> made(const Scene& scene, const std::string& hand, const std::string& hand_text, int rate_hz,
                                 std::uint64_t seed, const std::string& arm_model, const std::string& record,
                                 const std::string& name, bool details) {
  Result<std::unique_ptr<Simulation>> simulation =
      Simulation::make(scene, {hand, hand_text, rate_hz, seed, arm_model, record, name, details});
  if (!simulation) raiseProblems(simulation.problems());
  return std::move(simulation).value();
}

Vec3 vectorOf(const py::handle& given, const char* name, double limit) {
  const Rows rows = readRows(given, name, {3}, limit);
  if (!rows.lead.empty()) throw py::value_error(std::string(name) + " must have the shape (3,).");
  const std::span<const double> row = rows.row(0);
  return {row[0], row[1], row[2]};
}

/// Says that a thread runs the simulation, also where it ends by an exception.
struct Busy {
  explicit Busy(Simulation& of) : simulation(of) { simulation.is_busy = true; }
  ~Busy() { simulation.is_busy = false; }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;
  Simulation& simulation;
};

/// Runs without the interpreter's lock.
void run(Simulation& simulation, std::int64_t ticks) {
  const Busy busy(simulation);
  const py::gil_scoped_release unlocked;  // taken again before `busy` ends
  simulation.run(ticks);
}

void checkFree(const Simulation& simulation) {
  if (simulation.is_busy) throw py::value_error("Another thread runs this simulation: a simulation is one thread's.");
}

/// A call, refused while another thread runs the simulation.
template <class Answer, class Self, class... Given>
auto alone(Answer (*call)(Self&, Given...)) {
  return [call](Self& simulation, Given... given) -> Answer {
    checkFree(simulation);
    return call(simulation, std::forward<Given>(given)...);
  };
}

template <class Answer, class... Given>
auto alone(Answer (Simulation::*call)(Given...)) {
  return [call](Simulation& simulation, Given... given) -> Answer {
    checkFree(simulation);
    return (simulation.*call)(std::forward<Given>(given)...);
  };
}

void want(Simulation& simulation, const py::handle& p_mm, const py::handle& R_WT) {
  const Vec3 p_WT = kMetrePerMillimetre * vectorOf(p_mm, "p_mm", 1e6);
  if (R_WT.is_none()) return simulation.want(p_WT, nullptr);
  const Rows rows = readRows(R_WT, "R_WT", {3, 3}, 2.0);
  const Mat3 R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows.row(0).data());
  if (!rows.lead.empty()) throw py::value_error("R_WT must be one rotation.");
  if (const std::string wrong = kinematics::rotationWrong(R); !wrong.empty()) throw py::value_error("R_WT " + wrong);
  const Mat3 meant = meantRotation(R);
  simulation.want(p_WT, &meant);
}

void push(Simulation& simulation, const py::handle& f_N, std::int64_t ticks) {
  simulation.push(vectorOf(f_N, "f_N", 1e6), ticks);
}

void close(Simulation& simulation) {
  const Problems problems = simulation.close();
  if (!problems.empty()) raiseProblems(problems);
}

void edit(Simulation& simulation, const Scene& scene) {
  const Problems problems = simulation.edit(scene);
  if (!problems.empty()) raiseProblems(problems);
}

template <class T>
py::array copied(const std::vector<py::ssize_t>& shape, const std::byte* from) {
  py::array_t<T> values(shape);
  if (values.size() > 0) std::memcpy(values.mutable_data(), from, static_cast<std::size_t>(values.size()) * sizeof(T));
  return values;
}

/// Typed, and not by the name of a type: pybind11 before 2.12 does not know how large those of numpy 2 are.
py::array columnOf(record::NumberKind kind, const std::vector<py::ssize_t>& shape, const std::byte* from) {
  switch (kind) {
    case record::NumberKind::Byte:
      return copied<std::uint8_t>(shape, from);
    case record::NumberKind::Unsigned:
      return copied<std::uint32_t>(shape, from);
    case record::NumberKind::Integer:
      return copied<std::int64_t>(shape, from);
    case record::NumberKind::Real:
      break;
  }
  return copied<double>(shape, from);
}

/// The columns of a session's ticks, by name, of the ticks that were kept.
py::dict columns(const Simulation& simulation) {
  const bool more_joints = arm::jointsOf(simulation.geometry()) > 6;
  const std::span<const record::Column> all = record::tickColumns(more_joints);
  record::Packer packer(all);
  const auto rows = static_cast<std::int64_t>(simulation.ticks().size());
  packer.begin(rows);
  for (const servo::TickRecord& one : simulation.ticks()) record::pack(one, simulation.geometry(), packer, more_joints);
  const record::Block block = packer.block();
  const std::byte* from = block.bytes.data();
  py::dict found;
  for (const record::Column& column : all) {
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
    if (column.width > 1) shape.push_back(column.width);
    found[py::str(std::string(column.name))] = columnOf(column.kind, shape, from);
    from += static_cast<std::size_t>(rows) * record::bytesOf(column);
  }
  return found;
}

py::array_t<double> arrayOf(std::span<const double> numbers, double unit) {
  py::array_t<double> array = emptyRows({}, {static_cast<py::ssize_t>(numbers.size())});
  for (std::size_t i = 0; i < numbers.size(); ++i) array.mutable_data()[i] = unit * numbers[i];
  return array;
}

/// The last tick: number, time, joints, tip, velocity, target, error, force, fault, mode.
py::tuple last(const Simulation& simulation) {
  static constexpr const char* kModes[] = {"stopped", "running", "stopping", "fault"};
  const servo::TickRecord& one = simulation.last();
  const auto vector = [](const Vec3& value, double unit) { return arrayOf({value.data(), 3}, unit); };
  return py::make_tuple(
      simulation.count(), kSecondPerNanosecond * static_cast<double>(one.time_ns),
      arrayOf(std::span(one.q_rad).first(std::max<std::size_t>(6, arm::jointsOf(simulation.geometry()))), 1.0),
      vector(one.p_WT, kMillimetrePerMetre), vector(one.v_WT, kMillimetrePerMetre),
      vector(one.p_WP, kMillimetrePerMetre), kMillimetrePerMetre * one.error_m, vector(one.f_sent_T_W, 1.0),
      std::string(name(one.fault)), kModes[static_cast<std::size_t>(one.mode)]);
}

}  // namespace

void addSim(py::module_& core) {
  core.def("hands", [] {
    py::dict all;
    for (const sim::BuiltInHand& hand : sim::builtInHands()) all[hand.name] = hand.what;
    return all;
  });
  core.def("arm_models", [] {
    py::dict all;
    for (const sim::ArmModel& model : sim::armModels()) all[py::str(model.name)] = model.title;
    return all;
  });
  core.attr("DEFAULT_ARM_MODEL") = std::string(sim::kDefaultArmModel);
  madeClass<Simulation>(core, "Simulation")
      .def(py::init(&made))
      .def("run", alone(&run))
      .def("want", alone(&want))
      .def("let_go", alone(&Simulation::letGo))
      .def("push", alone(&push))
      .def("edit", alone(&edit))
      .def("start", alone(&Simulation::startServo))
      .def("stop", alone(&Simulation::stopServo))
      .def("mark", alone(&Simulation::mark))
      .def("forget", alone(&Simulation::forget))
      .def("columns", alone(&columns))
      .def("last", alone(&last))
      .def("close", alone(&close))
      .def_readwrite("keeps", &Simulation::keeps)
      .def_property_readonly("rate_hz", &Simulation::rateHz);
}

}  // namespace underact::bindings
