#pragma once
#include <string>

#include "core/scene/fields.h"

namespace underact::scene {

// Internal to the room: which numbers a scene may have. Each function returns what is wrong; empty: nothing.

inline constexpr double kFarthest_mm = 1e6;
inline constexpr double kHighestGain = 1e12;  // far beyond any arm; keeps newtons finite wherever the tip is

Sentence judge(Meaning meaning, double number);
Sentence judgeGain(double gain);
/// A value of the joint: a limit or its rest position.
Sentence judgeJoint(const Joint& joint, double value);

/// For a number or a direction that is not finite.
Sentence notFinite();
Sentence pointsNowhere();

/// A rotation, and a translation in mm.
Sentence judgePose(const Eigen::Matrix4d& X);

/// To 1e-6 of each number, as shape::makeBox().
bool isRotation(const Mat3& R);

}  // namespace underact::scene
