#pragma once
#include <string>

#include "core/arm/model.h"

namespace underact::arm {

/// The arm as a file of the form: a table in modified convention, a product of exponentials (both JSON), or URDF.
/// Reading it again gives the same arm, to some roundings of its numbers. Problems: what the form cannot express, as a
/// haptic device without a table, limits that URDF has no words for, or axes that are so nearly parallel that a table
/// would lose digits of the pose (more than 1e-12 m or rad). to: not ClassicDh.
Result<std::string> textOf(const Model& model, ArmForm to);

}  // namespace underact::arm
