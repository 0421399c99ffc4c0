#pragma once
#include <string>

#include "core/arm/model.h"

namespace underact::arm {

/// The arm as a file of the form: a table in modified convention, a product of exponentials (both JSON), or URDF.
/// Reading it again gives the same arm, to the rounding of the conversion; of its own form, to the bit. Problems: what
/// the form cannot say, as the tool of a haptic device, limits that URDF has no words for, or axes that are so nearly
/// parallel that a table would lose the pose (more than 1e-9 mm or rad). to: not ClassicDh.
Result<std::string> textOf(const Model& model, ArmForm to);

}  // namespace underact::arm
