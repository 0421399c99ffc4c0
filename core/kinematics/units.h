#pragma once
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/chain/chain.h"

namespace underact::kinematics {

/// The largest joint value, and the largest entry of a pose, mm, that are answered.
inline constexpr double kLargestAngle_rad = 1e6, kFarthest_mm = 1e9;

/// Whether the joint turns; its values are rad then, and otherwise mm outside core and m inside.
inline bool turns(const chain::Joint& joint) noexcept {
  return joint.type == chain::JointType::Revolute;
}

/// The joint values, rad and m, of as many numbers as the chain has joints, rad and mm.
chain::JointValues jointsOf(const chain::Chain& chain, std::span<const double> q) noexcept;

/// Joint values back to the numbers of a file, to out, which has room for as many as the chain has joints.
void writeJoints(const chain::Chain& chain, const chain::JointValues& q, std::span<double> out) noexcept;

/// The pose of a matrix in mm, brought to the nearest rotation where its decimals leave it beside one. X: entries of at
/// most kFarthest_mm. Gives nothing, or what is wrong as the end of a sentence that begins with the name of the matrix.
std::string readPose(const Eigen::Matrix4d& X, Pose& pose);

/// The end of such a sentence where R is no rotation, and none is near.
std::string rotationWrong(const Mat3& R);

/// The matrix of a pose, in mm.
Eigen::Matrix4d matrixOf(const Pose& X) noexcept;

}  // namespace underact::kinematics
