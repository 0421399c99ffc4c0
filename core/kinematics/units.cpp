#include "core/kinematics/units.h"

#include <cmath>
#include <string_view>

#include "core/base/nearest_rotation.h"
#include "core/base/units.h"

namespace underact::kinematics {

chain::JointValues jointsOf(const chain::Chain& chain, std::span<const double> q) noexcept {
  chain::JointValues values{};
  for (std::size_t i = 0; i < chain.joints.size(); ++i)
    values[i] = q[i] * (turns(chain.joints[i]) ? 1.0 : kMetrePerMillimetre);
  return values;
}

void writeJoints(const chain::Chain& chain, const chain::JointValues& q, std::span<double> out) noexcept {
  for (std::size_t i = 0; i < chain.joints.size(); ++i)
    out[i] = turns(chain.joints[i]) ? q[i] : kMillimetrePerMetre * q[i];
}

std::string rotationWrong(const Mat3& R) {
  const std::string sentence = rotationProblem(R);
  return sentence.empty() ? sentence : sentence.substr(std::string_view("This ").size());
}

std::string readPose(const Eigen::Matrix4d& X, Pose& pose) {
  constexpr double kRounding = 1e-14;  // of doubles: not corrected
  const Mat3 R = X.topLeftCorner<3, 3>();
  const double error = (R * R.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff();
  if (std::string wrong = rotationWrong(R); !wrong.empty()) return wrong;
  if (X.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) return "must end with the row 0, 0, 0, 1.";
  pose.linear() = error > kRounding ? nearestRotation(R) : R;
  pose.translation() = kMetrePerMillimetre * X.topRightCorner<3, 1>();
  pose.makeAffine();
  return {};
}

Eigen::Matrix4d matrixOf(const Pose& X) noexcept {
  Eigen::Matrix4d matrix = X.matrix();
  matrix.topRightCorner<3, 1>() *= kMillimetrePerMetre;
  return matrix;
}

}  // namespace underact::kinematics
