#pragma once
#include <string>

#include "core/scene/fields.h"

namespace underact::scene {

// Inside the room: which numbers a scene may have. A sentence for one that it may not; empty: it may.

inline constexpr double kFarthest_mm = 1e6;
inline constexpr double kHighestGain = 1e12;  // far beyond any arm; keeps newtons finite wherever the tip is

/// Of a shape. Not finite, a length not above 0 or below 1e-100 mm, a length or position beyond kFarthest_mm.
Sentence judge(Meaning meaning, double number);
/// Not finite, below 0 or above kHighestGain.
Sentence judgeGain(double gain);
/// A value of the joint: a limit, its rest.
Sentence judgeJoint(const Joint& joint, double value);

/// Of a number or a direction that is none.
Sentence notFinite();
/// Of a direction that is zero.
Sentence pointsNowhere();

/// Of a rotation and a translation in mm.
Sentence judgePose(const Eigen::Matrix4d& X);

/// To 1e-6 of each number, as shape::makeBox.
bool isRotation(const Mat3& R);

}  // namespace underact::scene
