#pragma once
#include <cstdint>

#include "core/arm/preset.h"
#include "core/lab/stopwatch.h"
#include "core/tick/program.h"

namespace underact::lab {

/// The greatest value of a quantity over all poses, and the tip's position there.
struct Greatest {
  double value = 0.0;
  Vec3 p_WT = Vec3::Zero();
};

/// What a scene asks of its arm at poses anywhere within the joint limits, and what its ticks cost on this machine.
struct SceneExtremes {
  int poses = 0;
  int without_answer = 0;       // at which a constraint has no single nearest point
  int beyond_limit = 0;         // at which the asked force is greater than what the gate lets through
  Greatest force_N;             // asked, before the gate
  Greatest per_ulp_N;           // change of the asked force where one joint value changes by its last bit
  Greatest per_encoder_step_N;  // ... by a step of its encoder: the grain that is felt
  Cost tick;                    // of a tick after another at the same pose
};

/// Draws poses evenly within the arm's joint limits, and within a turn to either side, and ticks the program at each
/// from a fresh state. arm: that of the program's scene; poses: from 1 on. All but `tick` are the same
/// for the same arguments, on every machine.
SceneExtremes extremesOf(const tick::TickProgram& program, const arm::Preset& arm, std::uint64_t seed, int poses);

}  // namespace underact::lab
