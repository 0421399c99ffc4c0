#pragma once
#include <string>

#include "core/scene/fields.h"

namespace underact::scene {

// Inside the room: which numbers a scene may have. A sentence for one that it may not; empty: it may.

inline constexpr double kFarthest_mm = 1e6;

std::string judge(Meaning meaning, double number);
std::string judgeGain(double gain);

/// Of a rotation and a translation in mm.
std::string judgePose(const Eigen::Matrix4d& X);

/// To 1e-6 of each number, as shape::makeBox.
bool isRotation(const Mat3& R);

}  // namespace underact::scene
