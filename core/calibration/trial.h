#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/result.h"
#include "core/calibration/staircase.h"
#include "core/scene/description.h"

namespace underact::calibration {

/// Left: the one at smaller x.
enum class Beam : std::uint8_t { Left, Right };

/// Two beams to be compared: one has the reference's stiffness at its tip, the other is stiffer by the difference.
struct Trial {
  Beam stiffer = Beam::Left;
  double difference = 0.0;
  double left_N_per_mm = 0.0;
  double right_N_per_mm = 0.0;
};

/// Draws the next trial. random: the state for the stiffer side, which is advanced.
Trial drawTrial(const Staircase& staircase, double reference_N_per_mm, std::uint64_t& random);

/// Sets the stiffness of a scene with two elastic joints, each a virtual robot of one revolute joint with a spring: k =
/// K / L^2 at the tip, with L from the joint to the tip. Problems: the scene does not have two such constraints.
Result<scene::Description> withStiffness(scene::Description scene, const Trial& trial);

/// The indexes of the constraints that are the left and the right beam. Problems: as withStiffness().
Result<std::array<std::size_t, 2>> beamsOf(const scene::Description& scene);

/// The stiffness of the softer of the scene's two beams at its tip, N/mm. Problems: as withStiffness().
Result<double> softerOf(const scene::Description& scene);

/// The rest position of that beam's tip, m. scene: one that withStiffness() accepts.
Vec3 tipOf(const scene::Description& scene, Beam beam);

/// "left", "right".
const char* name(Beam beam);

}  // namespace underact::calibration
