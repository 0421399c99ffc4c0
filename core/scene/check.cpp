#include <map>
#include <string>
#include <type_traits>
#include <utility>

#include "core/arm/model.h"
#include "core/base/nearest_rotation.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/json/json.h"
#include "core/json/text.h"
#include "core/scene/fields.h"
#include "core/scene/manipulators.h"
#include "core/scene/meshes.h"
#include "core/scene/read.h"
#include "core/scene/rules.h"
#include "core/scene/scene_arm.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {
namespace {

// The half axes of a shape in the metric of the gains go with the root of the ratio.
constexpr double kSmallestGainRatio = 1e-12;

using json::numberText;

bool allSame(const Vec3& v) {
  return v.x() == v.y() && v.y() == v.z();
}

/// Checks a scene part by part, with the place and the key of each.
class Checker {
 public:
  explicit Checker(const Description& scene) : scene_(scene) {}
  Problems run();

 private:
  void add(const std::string& key, Sentence sentence) {
    if (!sentence.empty()) problems_.push_back({std::move(sentence), {scene_.file, line_, column_, key}});
  }
  void checkField(const std::string& key, Meaning meaning, double number) { add(key, valueProblem(meaning, number)); }
  void checkField(const std::string& key, Meaning meaning, const Vec3& numbers);
  void checkField(const std::string& key, Meaning meaning, const Mat3& numbers);
  void checkControl(const std::string& key, const Control& control);
  /// Checks the numbers of all its settings.
  template <class Object>
  void checkAll(const std::string& key, const Object& object) {
    checkSettings(object, [&](const std::string& its, Sentence wrong) { add(key + "." + its, std::move(wrong)); });
  }
  void checkConstraint(std::size_t index);
  void checkMetric(const std::string& key, const Control& control, const Shape& shape);
  void checkRobot(const VirtualManipulator& robot, const Constraint& constraint, const Control& control);
  void checkInfluence(const Constraint& constraint, const Control& control);
  void checkName(const std::string& key, const std::string& name);
  void checkArm();

  const Description& scene_;
  Problems problems_;
  int line_ = 0;
  int column_ = 0;
  std::string path_;                          // of the constraint
  std::map<std::string, std::string> names_;  // and the path of the first constraint of that name
};

void Checker::checkField(const std::string& key, Meaning meaning, const Vec3& numbers) {
  for (Eigen::Index index = 0; index < 3; ++index) {
    add(key + "[" + std::to_string(index) + "]", valueProblem(meaning, numbers[index]));
  }
  if (meaning == Meaning::Direction && numbers == Vec3::Zero()) {
    add(key, hasNoDirection());
  }
}

void Checker::checkField(const std::string& key, Meaning meaning, const Mat3& numbers) {
  for (Eigen::Index row = 0; row < 3; ++row) {
    checkField(key + "[" + std::to_string(row) + "]", meaning, Vec3(numbers.row(row).transpose()));
  }
  if (numbers.allFinite()) add(key, rotationProblem(numbers));
}

void Checker::checkControl(const std::string& key, const Control& control) {
  checkAll(key, control);
  Control pd;
  pd.law = LawType::PD;
  for (const SettingOf<Control>& row : rowsOf<Control>()) {
    if (row.is_used == nullptr || row.is_used(control) || std::get<Vec3>(row.get(control)) == Vec3::Zero()) continue;
    add(key + "." + row.is.key,
        phrase(TRANSLATE_NOOP(
                   "problem",
                   "The control law %1 does not use this gain; %2 does. Change the control law, or remove the gain."),
               {wordOf(kLawWords, control.law),
                row.is_used(pd) ? phrase(TRANSLATE_NOOP("problem", "PD (or PID)")) : "PID"}));
  }
  checkAll(key + ".velocity", control.velocity);
  const arm::Preset* const arm = findArm(scene_);
  if (control.space == tick::Space::Joint && arm != nullptr && !arm::solvesInTick(arm->geometry))
    add(key + ".space",
        phrase(
            TRANSLATE_NOOP("problem",
                           "The control of joints follows the closed form of the Omni's geometry, which the arm %1 has "
                           "not; \"cartesian\" works with every arm."),
            {json::shown(arm->name)}));
}

/// Checks the metric of unequal gains: zero gains flatten the shape to nothing. Source: target/target.h,
/// makeConstraint().
void Checker::checkMetric(const std::string& key, const Control& control, const Shape& shape) {
  const Vec3& kp = control.gains.kp_N_per_mm;
  if (control.space == tick::Space::Joint) return;  // gains of joints are no metric of the workspace
  if (control.anisotropy == Anisotropy::Euclidean || allSame(kp) || std::holds_alternative<Point>(shape) ||
      std::holds_alternative<Mesh>(shape) || std::holds_alternative<Curve>(shape)) {
    return;
  }
  if (!kp.allFinite() || kp.minCoeff() < 0.0 || kp.minCoeff() > kSmallestGainRatio * kp.maxCoeff()) return;
  Eigen::Index axis = 0;
  const double min = kp.minCoeff(&axis);
  add(key,
      phrase(TRANSLATE_NOOP(
                 "problem",
                 "The gain along %1 is %2 while the others are larger, so no point of the %3 is nearest in the gains' "
                 "own metric. Set \"anisotropy\" to \"euclidean\" in the control, or give every axis a gain."),
             {std::string(1, "xyz"[axis]),
              min == 0.0 ? Sentence(numberText(min))
                         : phrase(TRANSLATE_NOOP("problem", "%1, almost nothing,"), {numberText(min)}),
              typeName(shape)}));
}

void Checker::checkName(const std::string& key, const std::string& name) {
  if (name.empty()) {
    add(key, phrase(TRANSLATE_NOOP("problem", "The constraint has no name.")));
    return;
  }
  const auto [first, is_new] = names_.emplace(name, path_);
  if (!is_new)
    add(key, phrase(TRANSLATE_NOOP("problem", "The name %1 is taken by %2; names must differ."),
                    {json::shown(name), first->second}));
}

void Checker::checkInfluence(const Constraint& constraint, const Control& control) {
  const std::string key = path_ + ".influence";
  if (!takesInfluence(constraint.shape)) {
    add(key, phrase(TRANSLATE_NOOP("problem", "A %1 has no influence."), {typeName(constraint.shape)}));
  }
  checkAll(key, *constraint.influence);
  if (constraint.side != target::Side::Both) {
    add(key,
        phrase(TRANSLATE_NOOP(
            "problem",
            "A wall has no influence: where the stylus is free, nothing pulls it. Remove \"side\" or \"influence\".")));
  }
  const bool weighted = control.space == tick::Space::Cartesian && control.anisotropy == Anisotropy::Weighted;
  if (weighted && !allSame(control.gains.kp_N_per_mm)) {
    add(key, phrase(TRANSLATE_NOOP("problem",
                                   "With influence, the target is not the nearest point in the gains' own metric. Set "
                                   "\"anisotropy\" to \"euclidean\" in the control, or give every axis the same kp.")));
  }
}

void Checker::checkRobot(const VirtualManipulator& robot, const Constraint& constraint, const Control& control) {
  const auto say = [this](const std::string& key, Sentence sentence) {
    add(key.empty() ? path_ : path_ + "." + key, std::move(sentence));
  };
  if (!checkManipulator(robot, control, say)) return;
  const auto made = makeManipulator(robot, control, constraint.place);
  if (made) return;
  for (const Problem& problem : made.problems()) add(path_, problem.sentence);
}

void Checker::checkConstraint(std::size_t index) {
  const Constraint& constraint = scene_.constraints[index];
  line_ = constraint.place.line;
  column_ = constraint.place.column;
  path_ = "constraints[" + std::to_string(index) + "]";
  checkName(path_ + ".name", constraint.name);
  std::visit(
      [&](const auto& shape) {
        eachField(shape, [&](const auto& field, const auto& number) {
          checkField(path_ + "." + field.key, field.meaning, number);
        });
      },
      constraint.shape);
  if (constraint.side != target::Side::Both && !hasSides(constraint.shape)) {
    add(path_ + ".side",
        phrase(TRANSLATE_NOOP("problem", "A %1 has no inside and no outside."), {typeName(constraint.shape)}));
  }
  if (const auto* robot = std::get_if<VirtualManipulator>(&constraint.shape)) {
    checkRobot(*robot, constraint, controlOf(scene_, index));
  }
  if (const auto* mesh = std::get_if<Mesh>(&constraint.shape)) {
    checkMesh(*mesh, constraint.side, controlOf(scene_, index),
              [this](const std::string& key, Sentence sentence) { add(path_ + "." + key, std::move(sentence)); });
  }
  if (const auto* curve = std::get_if<Curve>(&constraint.shape)) {
    checkCurve(*curve, controlOf(scene_, index),
               [this](const std::string& key, Sentence sentence) { add(path_ + "." + key, std::move(sentence)); });
  }
  if (constraint.influence) checkInfluence(constraint, controlOf(scene_, index));
  if (constraint.friction) {
    if (!takesFriction(constraint.shape))
      add(path_ + ".friction", phrase(TRANSLATE_NOOP("problem", "There is nothing to slide along.")));
    checkAll(path_ + ".friction", *constraint.friction);
  }
  if (constraint.control) checkControl(path_ + ".control", *constraint.control);
  checkMetric(path_, controlOf(scene_, index), constraint.shape);
}

void Checker::checkArm() {
  if (findArm(scene_) != nullptr) return;
  if (isArmFile(scene_.arm))
    return add("arm", phrase(TRANSLATE_NOOP("problem", "The arm file %1 was not read."), {json::shown(scene_.arm)}));
  if (const arm::Model* const model = arm::findModel(scene_.arm)) {
    const Result<arm::Preset> preset = arm::presetOf(*model);
    return add("arm", phrase(TRANSLATE_NOOP("problem", "The arm %1: %2"),
                             {json::shown(scene_.arm), preset.problems().front().sentence}));
  }
  std::vector<std::string> known;
  for (const arm::Preset& preset : arm::sceneArms()) known.emplace_back(preset.name);
  const std::string nearest = json::nearestWord(scene_.arm, known);
  const Sentence listed = json::listed(known, "and");
  add("arm", nearest.empty() ? phrase(TRANSLATE_NOOP("problem",
                                                     "The arm %1 is not known. Known arms: %2; or the name of an arm "
                                                     "file, such as \"my_arm.json\"."),
                                      {json::shown(scene_.arm), listed})
                             : phrase(TRANSLATE_NOOP("problem",
                                                     "The arm %1 is not known. Did you mean \"%2\"? Known arms: %3; or "
                                                     "the name of an arm file, such as \"my_arm.json\"."),
                                      {json::shown(scene_.arm), nearest, listed}));
}

Problems Checker::run() {
  if (scene_.title.find_first_not_of(" \t\r\n") == std::string::npos) {
    add("title",
        phrase(TRANSLATE_NOOP("problem", "The title is empty; say in a few words what the scene lets you feel.")));
  }
  checkArm();
  checkControl("control", scene_.control);
  checkAll("simulation", scene_.simulation);
  const std::size_t count = scene_.constraints.size();
  if (count < 1 || count > tick::kMaxConstraints) {
    add("constraints", constraintCountProblem(count));
  }
  for (std::size_t index = 0; index < count; ++index) checkConstraint(index);
  return std::move(problems_);
}

}  // namespace

Problems check(const Description& scene) {
  return Checker(scene).run();
}

}  // namespace underact::scene
