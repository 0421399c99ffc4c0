#include "core/tradeoff/settings.h"

#include <algorithm>

#include "core/json/json.h"
#include "core/scene/fields.h"
#include "core/scene/setting_rows.h"

namespace underact::tradeoff {
namespace {

using json::numberText;

/// Calls visit(control) for the scene's own and each constraint's.
template <class Visit>
void eachControl(scene::Description& scene, const Visit& visit) {
  visit(scene.control);
  for (scene::Constraint& constraint : scene.constraints) {
    if (constraint.control) visit(*constraint.control);
  }
}

/// The control of the first constraint for which is_meant holds; null: of none.
template <class IsMeant>
const scene::Control* firstControl(const scene::Description& scene, const IsMeant& is_meant) {
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    const scene::Control& control = controlOf(scene, index);
    if (is_meant(control)) return &control;
  }
  return nullptr;
}

/// Whether there is a search: a wall's proxy follows the surface of a mesh without one.
bool isSought(const scene::Constraint& one) {
  return std::holds_alternative<scene::Curve>(one.shape) ||
         (std::holds_alternative<scene::Mesh>(one.shape) && one.side == target::Side::Both);
}

bool damps(const scene::Control& control) {
  return control.law != scene::LawType::P;
}

std::string textOf(const scene::Solver& solver) {
  if (solver.method == scene::SolverMethod::ClosedForm) return "closed form";
  const std::string steps = std::to_string(solver.max_steps) + (solver.max_steps == 1 ? " step" : " steps");
  return solver.method == scene::SolverMethod::Auto ? "closed form where there is one, else " + steps : steps;
}

std::string textOf(const scene::Velocity& velocity) {
  std::string text = filterName(velocity);
  for (const auto& row : scene::rowsOf<scene::Velocity>().subspan(1)) {
    if (isThere(row, velocity)) text += std::string(", ") + row.is.key + " " + scene::fileTextOf(row.get(velocity));
  }
  return text;
}

std::string textOf(const scene::Simulation& simulation) {
  return std::string(wordOf(scene::kIntegratorWords, simulation.integrator)) + ", " +
         numberText(simulation.substep_us) + " us";
}

}  // namespace

bool hasSearch(const scene::Description& scene) {
  return std::any_of(scene.constraints.begin(), scene.constraints.end(), isSought);
}

bool hasSolver(const scene::Description& scene) {
  return std::any_of(scene.constraints.begin(), scene.constraints.end(), [](const scene::Constraint& one) {
    const auto* robot = std::get_if<scene::VirtualManipulator>(&one.shape);
    return robot != nullptr && robot->force_law == manipulator::ForceLaw::Energy;
  });
}

bool hasVelocity(const scene::Description& scene) {
  return firstControl(scene, damps) != nullptr;
}

Settings settingsOf(const scene::Description& scene, int rate_hz) {
  Settings settings;
  settings.rate_hz = rate_hz;
  settings.simulation = scene.simulation;
  for (auto one = scene.constraints.rbegin(); one != scene.constraints.rend(); ++one) {
    const auto* mesh = std::get_if<scene::Mesh>(&one->shape);
    if (mesh != nullptr && isSought(*one)) settings.search = mesh->search;
    if (const auto* curve = std::get_if<scene::Curve>(&one->shape)) settings.search = curve->search;
    if (const auto* robot = std::get_if<scene::VirtualManipulator>(&one->shape)) settings.solver = robot->solver;
  }
  if (const scene::Control* control = firstControl(scene, damps)) settings.velocity = control->velocity;
  return settings;
}

scene::Description withSettings(scene::Description scene, const Settings& settings) {
  scene.simulation = settings.simulation;
  eachControl(scene, [&](scene::Control& control) {
    if (damps(control)) control.velocity = settings.velocity;
  });
  for (scene::Constraint& constraint : scene.constraints) {
    auto* mesh = std::get_if<scene::Mesh>(&constraint.shape);
    if (mesh != nullptr && isSought(constraint)) mesh->search = settings.search;
    if (auto* curve = std::get_if<scene::Curve>(&constraint.shape)) curve->search = settings.search;
    auto* robot = std::get_if<scene::VirtualManipulator>(&constraint.shape);
    if (robot != nullptr && robot->force_law == manipulator::ForceLaw::Energy) robot->solver = settings.solver;
  }
  return scene;
}

std::vector<Difference> differences(const scene::Description& scene, const Settings& before, const Settings& after) {
  std::vector<Difference> all;
  const auto add = [&](const char* what, std::string one, std::string other) {
    if (one != other) all.push_back({what, std::move(one), std::move(other)});
  };
  add("servo rate", std::to_string(before.rate_hz) + " Hz", std::to_string(after.rate_hz) + " Hz");
  if (hasSearch(scene))
    add("search", wordOf(scene::kSearchWords, before.search), wordOf(scene::kSearchWords, after.search));
  if (hasSolver(scene)) add("solver", textOf(before.solver), textOf(after.solver));
  if (hasVelocity(scene)) add("velocity filter", textOf(before.velocity), textOf(after.velocity));
  add("simulated arm", textOf(before.simulation), textOf(after.simulation));
  add("recording's blocks", numberText(before.block_s) + " s", numberText(after.block_s) + " s");
  return all;
}

}  // namespace underact::tradeoff
