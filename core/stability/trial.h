#pragma once
#include <cstdint>

#include "core/stability/wall.h"

namespace underact::stability {

/// What becomes of a push. Rest: it dies out. LimitCycle: it goes on, no larger than the push. Grows: it goes beyond
/// the push; where no steps or friction sustain a swing: it grows at all.
enum class Behaviour : std::uint8_t { Rest, LimitCycle, Grows };

/// "rest", "limit_cycle", "grows".
const char* name(Behaviour behaviour);

/// How one trial ended.
struct Trial {
  Behaviour behaviour = Behaviour::Rest;
  double amplitude_m = 0.0;  // at the end: half of the span that is swung over; a tip that is stuck swings over none
  int ticks = 0;             // simulated
};

/// Linear: one swing, that grows for good or dies out. Smooth: several at once, slow ones among them, of which one may
/// hide another for a while. Stepped: steps of encoders or friction may sustain a swing, up to some size.
enum class Motion : std::uint8_t { Linear, Smooth, Stepped };

/// Follows the swings of anything, tick by tick, until it can tell what becomes of them.
class Watch {
 public:
  /// When the watch looks, and what it is looking at.
  struct Rules {
    int least_ticks = 0;  // before the first look; then as many again, twice as many, ...
    int most_ticks = 0;   // then the last look decides
    Motion motion = Motion::Linear;
    double tells = 0.02;  // a change by this share, from one look to the next, says where it goes
  };
  /// push_m: how far off it starts, above 0.
  Watch(double push_m, const Rules& rules);
  /// off_m: how far it is from where it should rest, this tick, with or without a sign. false: it is told; see trial().
  bool goesOn(double off_m);
  const Trial& trial() const { return trial_; }

 private:
  struct Span {
    double least_m = kInfinity, most_m = -kInfinity;
    void add(double off_m);
    double amplitude_m() const { return 0.5 * (most_m - least_m); }
  };
  Behaviour judge() const;

  double push_m_;
  Rules rules_;
  int next_;
  Span early_, late_;    // of the second and of the last quarter of the ticks up to next_
  bool steady_ = false;  // at the last look, too
  Trial trial_;
};

/// Ticks before the first look, so that each quarter of them holds a swing: half a second at least.
int ticksToSee(double mass_kg, double stiffness_N_per_m, double period_s);

/// A trial in the simulated loop: the simulated arm under the program's own law, pushed along x by push_m: with
/// friction the answer depends on it. Linear walls are pushed by a micrometre, and their amplitude told as of push_m.
Trial tryWall(const SampledWall& wall, double stiffness_N_per_m, double push_m = 1e-3);

/// The greatest K, N/m, to `share` of itself, up to which a trial does not grow: by doubling, then by halving. 0: below
/// 0.01; kMostStiffness_N_per_m: all.
double simulatedLimit(const SampledWall& wall, double share = 2e-3);

/// The same search over anything that can be tried at a stiffness, and is calm at the least.
template <class IsCalm>
double limitBySearch(const IsCalm& is_calm, double least, double most, double share) {
  double calm = least, wild = 2.0 * least;
  while (is_calm(wild)) {
    calm = wild;
    wild *= 2.0;
    if (wild > most) return most;
  }
  while (wild - calm > share * wild) {
    const double middle = 0.5 * (calm + wild);
    (is_calm(middle) ? calm : wild) = middle;
  }
  return 0.5 * (calm + wild);
}

}  // namespace underact::stability
