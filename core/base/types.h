#pragma once
#include <Eigen/Geometry>
#include <limits>

namespace underact {

// Vectors carry their frames in their names: p_WT is the position of T in W, f_T_W the force on T expressed in W.
// Frames: W workspace (the arm maker's), B base (frame 0 of the DH table), T stylus tip (frame 6), P the nearest point
// or target. SI throughout core; millimetres and degrees live in scene files, on screen and at device borders.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Pose = Eigen::Isometry3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;  // of twists and wrenches: the linear part first
using Mat6 = Eigen::Matrix<double, 6, 6>;

inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace underact
