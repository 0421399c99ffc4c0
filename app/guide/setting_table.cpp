#include "app/guide/setting_table.h"

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "app/guide/markdown.h"
#include "core/scene/fields.h"
#include "core/scene/settings.h"

namespace underact::guide {
namespace {

using scene::Setting;

/// A scene with what its name says.
struct Sample {
  std::string name;
  scene::Description scene;
};

/// Of each shape; or, for a filter's own settings, of each filter.
std::vector<Sample> samplesFor(const std::string& path) {
  std::vector<Sample> all;
  const auto add = [&all](const std::string& name, scene::Shape shape, scene::Velocity velocity = {}) {
    Sample sample{name, {}};
    sample.scene.control.velocity = std::move(velocity);
    scene::Constraint& constraint = sample.scene.constraints.emplace_back();
    constraint.shape = std::move(shape);
    // All different, so that a setting that depends on it is seen to have no default.
    if (takesFriction(constraint.shape)) constraint.friction = {{0.1 * static_cast<double>(all.size()), 0.0}};
    all.push_back(std::move(sample));
  };
  if (path.starts_with("/control/velocity/")) {
    for (const scene::Velocity& filter : std::initializer_list<scene::Velocity>{
             scene::KalmanFilter{}, scene::LowPassFilter{}, scene::AdaptiveWindowFilter{}, scene::RawFilter{}})
      add(scene::filterName(filter), scene::Point{}, filter);
    return all;
  }
  const bool is_of_joint = path.find("/joints/") != std::string::npos;
  scene::eachShape([&]<class Shape>(Shape shape) {
    if constexpr (std::is_same_v<Shape, scene::VirtualManipulator>) {
      shape.joints.emplace_back().type = chain::JointType::Prismatic;
      scene::VirtualManipulator turning = shape;
      turning.joints[0].type = chain::JointType::Revolute;
      add(is_of_joint ? "revolute" : scene::typeName(turning), turning);
      if (is_of_joint) add("prismatic", shape);
    } else {
      add(scene::typeName(shape), shape);
    }
  });
  return all;
}

std::string firstPlace(std::string path) {
  for (std::size_t star = path.find('*'); star != std::string::npos; star = path.find('*')) path[star] = '0';
  return path;
}

std::string rowOf(const Setting& setting) {
  const SettingUse use = useOf(setting);
  const auto* const word = std::get_if<std::string>(&use.default_value);
  const std::string default_value = word != nullptr ? *word : scene::fileTextOf(use.default_value);
  return "| " + inCode(pathOf(setting)) + " | " + (scene::isNone(use.default_value) ? "" : inCode(default_value)) +
         " | " + (use.is_of_all ? "" : listedInCode(use.of)) + " |\n";
}

}  // namespace

SettingUse useOf(const Setting& setting) {
  const std::string path = pathOf(setting), place = firstPlace(path);
  SettingUse use;
  std::vector<scene::SettingValue> default_value;
  const std::vector<Sample> samples = samplesFor(path);
  for (const Sample& one : samples) {
    const Result<Setting> found = settingAt(one.scene, place);
    if (!found || found.value().tip != setting.tip || found.value().unit != setting.unit) continue;
    use.of.push_back(one.name);
    default_value.push_back(defaultAt(one.scene, place).value());
  }
  use.is_of_all = use.of.size() == samples.size();
  const bool is_one = std::count(default_value.begin(), default_value.end(), default_value.front()) ==
                      static_cast<std::ptrdiff_t>(default_value.size());
  if (is_one) use.default_value = default_value.front();
  return use;
}

std::string settingTable() {
  std::ostringstream out;
  out << "## Settings by path\n\n"
         "All settings that can be changed while the scene runs, by the path that `--set` takes; the tables above have "
         "their values. A star stands for all "
         "constraints or joints; a number, counted from 0, stands for one of them. A constraint's own control has the "
         "same settings as `/control`, as in `/constraints/0/control/law`.\n\n"
         "| path | default | applies to |\n|---|---|---|\n";
  std::vector<std::string> rows;
  for (const Setting& setting : scene::settings()) {
    // Those of meshes and of curves may be the same.
    if (const std::string row = rowOf(setting); std::find(rows.begin(), rows.end(), row) == rows.end())
      rows.push_back(row);
  }
  for (const std::string& row : rows) out << row;
  return out.str();
}

}  // namespace underact::guide
