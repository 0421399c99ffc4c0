#include <array>
#include <cmath>
#include <iomanip>
#include <memory>
#include <ostream>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/scene_file.h"
#include "core/base/printed.h"
#include "core/tick/cost.h"
#include "core/tick/state.h"

namespace underact::cli {
namespace {

Exit checkSceneFiles(const std::vector<std::string>& paths, const Streams& streams) {
  Exit exit = Exit::Success;
  for (const std::string& path : paths) {
    const Result<LoadedScene> loaded = loadScene(path, streams);
    if (loaded) {
      printNotes(loaded.value(), streams.err);
      continue;
    }
    const Exit now = exitOf(loaded.problems());
    print(loaded.problems(), now == Exit::File ? streams.err : streams.out);
    if (exit != Exit::File) exit = now;
  }
  return exit;
}

/// The quantities that a tick may need, in the words of scene show.
std::array<std::pair<const char*, bool>, 12> needsOf(const tick::Needs& needs) {
  return {{{"position", true},
           {"orientation", needs.orientation},
           {"error_rate", needs.rate},
           {"error_integral", needs.integral},
           {"gain_metric", needs.metric},
           {"nearest_choice", needs.choice},
           {"joint_targets", needs.joints},
           {"virtual_robots", needs.robots},
           {"meshes", needs.meshes},
           {"curves", needs.curves},
           {"friction", needs.friction},
           {"energy", needs.energy}}};
}

const char* lawName(const scene::Control& control) {
  switch (control.law) {
    case scene::LawType::P:
      return "P";
    case scene::LawType::PD:
      return "PD";
    case scene::LawType::PID:
      return "PID";
  }
  return "P";
}

/// How a virtual robot's joints are found; null for other constraints.
const char* solverOf(const tick::Entry& entry) {
  const auto* robot = std::get_if<manipulator::Manipulator>(&entry.constraint.goal);
  if (robot == nullptr) return nullptr;
  if (robot->law == manipulator::ForceLaw::Thesis52) return "thesis-5.2";
  return robot->closed ? "closed_form" : "iterative";
}

JsonObject describedAsJson(const LoadedScene& loaded) {
  JsonObject object;
  object.addText("title", loaded.description.title);
  object.addText("arm", loaded.description.arm);
  std::vector<JsonObject> constraints;
  for (std::size_t index = 0; index < loaded.description.constraints.size(); ++index) {
    const scene::Constraint& constraint = loaded.description.constraints[index];
    JsonObject& one = constraints.emplace_back();
    one.addText("name", constraint.name);
    one.addText("type", scene::typeName(constraint.shape));
    one.addText("law", lawName(scene::controlOf(loaded.description, index)));
    if (const char* solver = solverOf(loaded.program.entries[index])) one.addText("solver", solver);
  }
  object.addList("constraints", constraints);
  JsonObject needs;
  for (const auto& [word, needed] : needsOf(loaded.program.needs)) needs.addBool(word, needed);
  object.addObject("needs", needs);
  object.addInteger("state_bytes", tick::bytesOf(tick::makeState(loaded.program)));
  object.addNumber("predicted_ns", std::round(tick::predictedCost_ns(loaded.program)));
  return object;
}

void describeAsTable(const LoadedScene& loaded, std::ostream& out) {
  const auto row = [&out](const std::string& what) -> std::ostream& {
    return out << std::left << std::setw(24) << what;
  };
  row("title") << printed(loaded.description.title) << '\n';
  row("arm") << printed(loaded.description.arm) << '\n';
  for (std::size_t index = 0; index < loaded.description.constraints.size(); ++index) {
    const scene::Constraint& constraint = loaded.description.constraints[index];
    row("constraint") << printed(constraint.name) << ": " << scene::typeName(constraint.shape) << ", "
                      << lawName(scene::controlOf(loaded.description, index));
    if (const char* solver = solverOf(loaded.program.entries[index])) out << ", " << solver;
    out << '\n';
  }
  for (const auto& [word, needed] : needsOf(loaded.program.needs)) {
    row(std::string("needs ") + word) << (needed ? "yes" : "no") << '\n';
  }
  row("state") << tick::bytesOf(tick::makeState(loaded.program)) << " bytes\n";
  row("predicted") << std::llround(tick::predictedCost_ns(loaded.program)) << " ns per tick\n";
}

Exit showScene(const std::string& path, bool json, const Streams& streams) {
  const Result<LoadedScene> loaded = loadScene(path, streams);
  if (!loaded) return fail(loaded.problems(), streams);
  if (json) {
    streams.out << describedAsJson(loaded.value()).text() << '\n';
  } else {
    describeAsTable(loaded.value(), streams.out);
  }
  return Exit::Success;
}

}  // namespace

void addScene(Command program, const Streams& streams, Exit& exit) {
  const Command command = program.add("scene", "Check scene files, or show what one compiles to");
  command.mustChoose();

  const Command checking = command.add(
      "check", "Print all problems in scene files, nothing if there are none; on stderr, notes on their meshes");
  const auto paths = std::make_shared<std::vector<std::string>>();
  checking.option("files", *paths, "Scene files").required();
  checking.whenChosen([paths, &streams, &exit] { exit = checkSceneFiles(*paths, streams); });

  const Command showing = command.add(
      "show", "Show what a scene compiles to: the quantities that its tick needs, bytes of state, predicted ns");
  const auto path = std::make_shared<std::string>();
  const auto json = std::make_shared<bool>(false);
  showing.option("file", *path, "Scene file").required();
  showing.flag("--json", *json, "One JSON object instead of a table");
  showing.whenChosen([path, json, &streams, &exit] { exit = showScene(*path, *json, streams); });
}

}  // namespace underact::cli
