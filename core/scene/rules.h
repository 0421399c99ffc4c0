#pragma once
#include <string>

#include "core/scene/fields.h"

namespace underact::scene {

// Inside the room: the allowed numbers of a scene. Each gives a sentence for one that is not allowed; empty: it is.

inline constexpr double kFarthest_mm = 1e6;
inline constexpr double kHighestGain = 1e12;  // far beyond any arm; keeps newtons finite wherever the tip is

/// Of a shape. Not finite, a length not above 0 or below 1e-100 mm, a length or position beyond kFarthest_mm.
Sentence valueProblem(Meaning meaning, double number);
/// Not finite, below 0 or above kHighestGain.
Sentence gainProblem(double gain);
/// A limit of the joint, or its rest position.
Sentence jointProblem(const Joint& joint, double value);

/// The sentence for a number of constraints that is not allowed.
Sentence constraintCountProblem(std::size_t count);
/// The sentence for a number of joints that a virtual robot cannot have.
Sentence jointCountProblem(std::size_t count);

/// The sentence for a number that is not finite.
Sentence notFinite();
/// The sentence for a direction that is zero.
Sentence hasNoDirection();

/// A pose whose translation is in mm.
Sentence poseProblem(const Eigen::Matrix4d& X);

}  // namespace underact::scene
