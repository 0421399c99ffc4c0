#include "core/scene/rules.h"

#include <cmath>

#include "core/base/nearest_rotation.h"
#include "core/base/translate.h"
#include "core/json/json.h"

namespace underact::scene {

using json::numberText;

constexpr double kSmallest_mm = 1e-100;  // the tick squares lengths in metres: far above underflow
constexpr double kFarthestTurn_rad = 1e3;

Sentence constraintCountProblem(std::size_t count) {
  return phrase(TRANSLATE_NOOP("problem", "A scene has 1 to %1 constraints; this one has %2."),
                {std::to_string(tick::kMaxConstraints), std::to_string(count)});
}

Sentence jointCountProblem(std::size_t count) {
  return phrase(TRANSLATE_NOOP("problem", "A virtual robot has 1 to %1 joints; this one has %2."),
                {std::to_string(manipulator::kMaxJoints), std::to_string(count)});
}

Sentence notFinite() {
  return phrase(TRANSLATE_NOOP("problem", "This is not a finite number; the largest is about 1.8e308."));
}

Sentence hasNoDirection() {
  return phrase(TRANSLATE_NOOP("problem", "A direction must not be [0, 0, 0]; any other length will do."));
}

Sentence valueProblem(Meaning meaning, double number) {
  if (!std::isfinite(number)) return notFinite();
  if (meaning == Meaning::Length && number <= 0.0)
    return phrase(TRANSLATE_NOOP("problem", "This must be above 0 mm; here it is %1."), {numberText(number)});
  if (meaning == Meaning::Length && number < kSmallest_mm)
    return phrase(TRANSLATE_NOOP("problem", "This is too close to 0 mm; the smallest value is 1e-100 mm."));
  if ((meaning == Meaning::Length || meaning == Meaning::Position) && std::abs(number) > kFarthest_mm) {
    return phrase(TRANSLATE_NOOP("problem", "This must lie within 1e6 mm (1 km); here it is %1."),
                  {numberText(number)});
  }
  return {};
}

Sentence gainProblem(double gain) {
  if (!std::isfinite(gain)) return notFinite();
  if (gain < 0.0)
    return phrase(TRANSLATE_NOOP("problem", "A gain must be 0 or above, otherwise the arm pushes away; here it is %1."),
                  {numberText(gain)});
  if (gain > kHighestGain)
    return phrase(TRANSLATE_NOOP("problem", "A gain must be at most 1e12; here it is %1."), {numberText(gain)});
  return {};
}

Sentence jointProblem(const Joint& joint, double value) {
  const bool turns = joint.type == chain::JointType::Revolute;
  if (!std::isfinite(value)) return notFinite();
  if (std::abs(value) <= (turns ? kFarthestTurn_rad : kFarthest_mm)) return {};
  return phrase(TRANSLATE_NOOP("problem", "This must lie within %1; here it is %2."),
                {turns ? "1000 rad" : "1e6 mm", numberText(value)});
}

Sentence poseProblem(const Eigen::Matrix4d& X) {
  if (!X.allFinite())
    return phrase(TRANSLATE_NOOP("problem", "This is not a finite pose; the largest number is about 1.8e308."));
  if (X.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0))
    return phrase(TRANSLATE_NOOP("problem", "The last row of a pose must be [0, 0, 0, 1]."));
  if (Sentence sentence = rotationProblem(X.topLeftCorner<3, 3>()); !sentence.empty()) return sentence;
  if (X.topRightCorner<3, 1>().cwiseAbs().maxCoeff() > kFarthest_mm)
    return phrase(TRANSLATE_NOOP("problem", "The position must lie within 1e6 mm (1 km)."));
  return {};
}

}  // namespace underact::scene
