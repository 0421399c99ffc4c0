#include <memory>
#include <string>

#include "app/cli/command.h"
#include "app/cli/json_lines.h"
#include "app/cli/pose_line.h"
#include "app/cli/scene_file.h"
#include "core/arm/inverse.h"
#include "core/base/units.h"
#include "core/safety/gate.h"
#include "core/tick/rest.h"

namespace underact::cli {
namespace {

using target::Status;

/// Target and force, with the ramps of the safety gate complete.
void addAnswer(JsonObject& object, Status status, const Vec3* p_WP, const Vec3& f_T_W, double max_force_N) {
  if (p_WP != nullptr && status == Status::Unique) {
    object.addVector("q_mm", kMillimetrePerMetre * *p_WP);
  } else {
    object.addNull("q_mm");
  }
  object.addVector("force_N", f_T_W);
  object.addVector("safe_force_N", safety::clampForce(f_T_W, max_force_N));
  object.addText("status", name(status));
}

/// The keys of a virtual robot: the z axis of its end effector, the moment, which is never sent, the solver's steps,
/// the joints.
void addRobot(JsonObject& object, const target::Robot& robot, const chain::Chain& chain) {
  object.addVector("n", robot.n_W);
  object.addVector("moment_N_mm", kMillimetrePerMetre * robot.moment_W);
  object.addInteger("steps", robot.steps);
  std::vector<double> theta;
  for (std::size_t i = 0; i < robot.joints; ++i) {
    const bool turns = chain.joints[i].type == chain::JointType::Revolute;
    theta.push_back(turns ? robot.theta[i] : kMillimetrePerMetre * robot.theta[i]);
  }
  object.addList("theta", theta);
}

JsonObject answer(const LoadedScene& loaded, const PoseLine& pose) {
  const tick::TickReport report = tick::evaluateAtRest(loaded.program, pose.p_WT, pose.R_WT);
  const double max_force_N = loaded.program.limits.max_force_N;
  std::vector<JsonObject> constraints;
  for (std::size_t index = 0; index < report.held.size(); ++index) {
    const tick::ConstraintReport& held = report.held[index];
    JsonObject& one = constraints.emplace_back();
    one.addText("name", loaded.description.constraints[index].name);
    addAnswer(one, held.status, &held.p_WP, held.f_T_W, max_force_N);
    one.addBool("acts", held.acts && held.status == Status::Unique);
    const auto* robot = std::get_if<manipulator::Manipulator>(&loaded.program.entries[index].constraint.goal);
    if (robot != nullptr) addRobot(one, held.robot, robot->chain);
  }
  JsonObject all;
  const Vec3* p_WP = report.held.size() == 1 ? &report.held[0].p_WP : nullptr;
  addAnswer(all, tick::statusOf(report.held), p_WP, report.f_T_W, max_force_N);
  const auto* only = std::get_if<manipulator::Manipulator>(&loaded.program.entries[0].constraint.goal);
  if (report.held.size() == 1 && only != nullptr) addRobot(all, report.held[0].robot, only->chain);
  all.addList("constraints", constraints);
  return all;
}

Exit answerPoses(const std::string& path, const Streams& streams) {
  const Result<LoadedScene> loaded = loadScene(path, streams);
  if (!loaded) return fail(loaded.problems(), streams);
  return answerLines(streams, [&](std::string_view line) -> Result<JsonObject> {
    const Result<PoseLine> pose = readPoseLine(line);
    if (!pose) return pose.problems();
    const tick::TickProgram& program = loaded.value().program;
    if (program.needs.joints && !arm::solvePosition(program.geometry, pose.value().p_WT).reachable) {
      return Problems{{"The arm cannot reach this position, and the scene controls it in joint space.", {}}};
    }
    return answer(loaded.value(), pose.value());
  });
}

}  // namespace

void addTarget(Command program, const Streams& streams, Exit& exit) {
  const Command command =
      program.add("target", "Where a scene pulls the stylus, and with what force, for poses read from standard input");
  command.footer(
      "Each line in is {\"p_mm\": [x, y, z], \"R_WT\": 3x3 (optional)}; each line out is {\"q_mm\", \"force_N\", "
      "\"safe_force_N\",\n"
      "\"status\", \"constraints\"}, or {\"error\", \"line\"}. The stylus is at rest; no state is kept between lines.");
  const auto path = std::make_shared<std::string>();
  command.option("scene", *path, "Scene file").required();
  command.whenChosen([path, &streams, &exit] { exit = answerPoses(*path, streams); });
}

}  // namespace underact::cli
