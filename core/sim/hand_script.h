#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/sim/hand.h"

namespace underact::sim {

/// A point of a hand's path.
struct HandPoint {
  double t_s = 0.0;
  Vec3 p_WT = Vec3::Zero();  // m
  Mat3 R_WT = Mat3::Identity();
  bool turns = false;  // R_WT counts; the stylus rotates between two points that both have it
};

/// What a scripted hand does: minimum-jerk motion from point to point (the last one held), plus a tremor.
struct HandScript {
  HandModel hand;
  std::vector<HandPoint> path;  // at least one; t_s strictly rising
  double repeat_s = 0.0;        // > 0: the path starts again after so long
  double tremor_m = 0.0;        // amplitude, per axis: never further off than this
  std::uint64_t seed = 0;       // of the tremor's phases
  bool about_middle = false;    // built in: around the middle of an arm's workspace, here the origin
};

/// Where the script wants the hand at time_ns since its start; a pure function, bit-identical on every machine. Before
/// the first point it waits there. Source of the profile: Flash and Hogan 1985, 10 s^3 - 15 s^4 + 6 s^5; the stylus
/// rotates about one axis by the same profile.
HandSetpoint setpointAt(const HandScript& script, std::int64_t time_ns) noexcept UNDERACT_REAL_TIME;

/// A hand that ships with the program.
struct BuiltInHand {
  const char* name;
  const char* what;  // one sentence
};
std::span<const BuiltInHand> builtInHands();  // still, sweep, probe, tremor, stab

/// A built-in script by name. Problems: no such name (the names are in the sentence).
Result<HandScript> builtInHand(std::string_view name, std::uint64_t seed);

/// The script for an arm: a built-in one is around the middle of its workspace; any other stays as it is.
HandScript madeFor(const arm::Preset& arm, HandScript script);

/// {"underact_hand": 1, "hand": {...}, "path": [{"t_s", "p_mm", "R_WT"}, ...]}. A point without R_WT keeps the
/// orientation of the one before it (before the first that has one: that one's). Problems: all at once, with places.
Result<HandScript> readHand(std::string_view text, const std::string& file_name);
/// Reads a hand file. Problems, too: it cannot be read.
Result<HandScript> readHandFile(const std::string& path);

}  // namespace underact::sim
