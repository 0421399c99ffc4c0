#include "core/ghost/follow.h"

#include <algorithm>

#include "core/base/units.h"

namespace underact::ghost {
namespace {

constexpr double kLongestStep_s = 0.25;  // between two ticks; a longer one is a pause of the arm or another clock

double stepOf(const State& state, std::int64_t time_ns) {
  if (!state.tick_ns) return 0.0;
  const double step_s = kSecondPerNanosecond * static_cast<double>(time_ns - *state.tick_ns);
  return step_s > 0.0 && step_s <= kLongestStep_s ? step_s : 0.0;
}

Phase phaseAt(const Options& options, Phase phase, double distance_m) {
  if (phase == Phase::Ready && (!options.begins_near || distance_m <= kNear_m)) return Phase::Going;
  if (phase == Phase::Going && options.waits && distance_m > options.waits_beyond_m) return Phase::Waiting;
  if (phase == Phase::Waiting && (!options.waits || distance_m <= 0.5 * options.waits_beyond_m)) return Phase::Going;
  return phase;
}

void count(Tally& tally, double distance_m, double step_s) {
  tally.followed_s += step_s;
  tally.sum_m_s += distance_m * step_s;
  tally.largest_m = std::max(tally.largest_m, distance_m);
  if (distance_m <= kNear_m) tally.near_s += step_s;
}

void endRound(State& state, bool loops) {
  ++state.rounds;
  state.last_round = state.tally;
  state.phase = loops ? Phase::Ready : Phase::Ended;
  if (!loops) return;
  state.tally = {};
  state.time_s = 0.0;
}

}  // namespace

State advanced(const Trajectory& trajectory, const Options& options, State state, std::int64_t time_ns,
               const Vec3& p_WT) {
  if (!p_WT.allFinite()) return state;
  const double step_s = stepOf(state, time_ns);
  state.tick_ns = time_ns;
  state.ghost = poseAt(trajectory, state.time_s);
  state.distance_m = (p_WT - state.ghost.p_WG).norm();
  if (!options.plays) return state;
  state.phase = phaseAt(options, state.phase, state.distance_m);
  if (state.phase == Phase::Waiting) state.tally.waited_s += step_s;
  if (state.phase != Phase::Going) return state;
  state.time_s =
      std::min(state.time_s + step_s * std::clamp(options.speed, kSlowest, kFastest), trajectory.duration_s());
  state.ghost = poseAt(trajectory, state.time_s);
  state.distance_m = (p_WT - state.ghost.p_WG).norm();
  count(state.tally, state.distance_m, step_s);
  if (state.time_s >= trajectory.duration_s()) endRound(state, options.loops);
  return state;
}

}  // namespace underact::ghost
