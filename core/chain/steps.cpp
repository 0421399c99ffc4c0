#include "core/chain/steps.h"

#include "core/base/trig.h"

namespace underact::chain {

Pose poseOf(const Step& step) noexcept {
  const auto axis = static_cast<Eigen::Index>(step.kind) % 3;
  Pose X = Pose::Identity();
  if (!isRotationStep(step.kind)) {
    X.translation()[axis] = step.amount;
    return X;
  }
  const auto [sine, cosine] = sinCos(step.amount);
  const Eigen::Index next = (axis + 1) % 3, last = (axis + 2) % 3;
  X.linear()(next, next) = X.linear()(last, last) = cosine;
  X.linear()(next, last) = -sine;
  X.linear()(last, next) = sine;
  return X;
}

std::vector<Pose> composed(std::span<const Step> steps, Axes axes) {
  std::vector<Pose> frames;
  Pose X = Pose::Identity();
  for (const Step& step : steps) {
    X = axes == Axes::Moving ? X * poseOf(step) : poseOf(step) * X;
    frames.push_back(X);
  }
  return frames;
}

}  // namespace underact::chain
