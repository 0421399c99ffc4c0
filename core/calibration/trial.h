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

/// Two beams to be told apart: one has the reference's stiffness at its tip, the other is stiffer by the difference.
struct Trial {
  Beam stiffer = Beam::Left;
  double difference = 0.0;
  double left_N_per_mm = 0.0;
  double right_N_per_mm = 0.0;
};

/// The next trial; random: the state from which the side is drawn, left a draw further.
Trial drawTrial(const Staircase& staircase, double reference_N_per_mm, std::uint64_t& random);

/// A scene of two elastic joints, each a virtual manipulator of one revolute joint with a spring, whose tips bend for
/// so much: k = K / L^2 with L from the joint to the tip. Problems: the scene has not two such constraints.
Result<scene::Description> withStiffness(scene::Description scene, const Trial& trial);

/// The constraints that are the left and the right beam, by their place in the scene. Problems: as withStiffness().
Result<std::array<std::size_t, 2>> beamsOf(const scene::Description& scene);

/// The stiffness of the softer of the scene's two beams at its tip, N/mm. Problems: as withStiffness().
Result<double> softerOf(const scene::Description& scene);

/// Where that beam's tip rests, m. beam: of a scene that withStiffness() takes.
Vec3 tipOf(const scene::Description& scene, Beam beam);

/// "left", "right".
const char* name(Beam beam);

}  // namespace underact::calibration
