#pragma once
#include <cstdint>

#include "core/stability/wall.h"

namespace underact::stability {

/// The outcome of a push. Rest: it decays. LimitCycle: it persists, no larger than the push. Grows: it exceeds the
/// push, or, where no steps or friction sustain an oscillation, it grows at all.
enum class Behaviour : std::uint8_t { Rest, LimitCycle, Grows };

/// "rest", "limit_cycle", "grows".
const char* name(Behaviour behaviour);

/// How one trial ended.
struct TrialResult {
  Behaviour behaviour = Behaviour::Rest;
  double amplitude_m = 0.0;  // at the end: half of the range of the oscillation; 0 for a stuck tip
  int ticks = 0;             // simulated
};

/// Linear: one oscillation, which grows or decays. Smooth: several at once, slow ones among them, which may hide each
/// other for a while. Stepped: encoder steps or friction may sustain an oscillation of bounded size.
enum class Motion : std::uint8_t { Linear, Smooth, Stepped };

/// Observes an oscillation, tick by tick, until its outcome is clear.
class SwingObserver {
 public:
  /// When the oscillation is judged, and of which kind it is.
  struct Rules {
    int min_ticks = 0;  // before the first judgement; then as many again, twice as many, ...
    int max_ticks = 0;  // then the last judgement counts
    Motion motion = Motion::Linear;
    double tells = 0.02;  // a relative change by this, from one judgement to the next, is decisive
  };
  /// push_m: the initial distance, above 0.
  SwingObserver(double push_m, const Rules& rules);
  /// off_m: the distance from rest in this tick, with or without a sign. false: the outcome is clear; see trial().
  bool goesOn(double off_m);
  const TrialResult& trial() const { return trial_; }

 private:
  struct Span {
    double min_m = kInfinity, max_m = -kInfinity;
    void add(double off_m);
    double amplitude_m() const { return 0.5 * (max_m - min_m); }
  };
  Behaviour judge() const;

  double push_m_;
  Rules rules_;
  int next_;
  Span early_, late_;    // of the second and of the last quarter of the ticks up to next_
  bool steady_ = false;  // at the last look, too
  TrialResult trial_;
};

/// Ticks before the first judgement, so that each quarter of them contains an oscillation: half a second at least.
int ticksToObserve(double mass_kg, double stiffness_N_per_m, double period_s);

/// A trial with the simulated arm under the program's own law, pushed along x by push_m: with friction the outcome
/// depends on it. Linear walls are pushed by a micrometre, and their amplitude scaled to push_m.
TrialResult tryWall(const SampledWall& wall, double stiffness_N_per_m, double push_m = 1e-3);

/// The greatest K, N/m, to `share` of itself, up to which a trial does not grow: by doubling, then by bisection. 0:
/// below 0.01; kMaxStiffness_N_per_m: all.
double simulatedLimit(const SampledWall& wall, double share = 2e-3);

/// The search for any trial at a stiffness that does not grow at the least one.
template <class IsCalm>
double limitBySearch(const IsCalm& is_calm, double min, double max, double share) {
  double calm = min, wild = 2.0 * min;
  while (is_calm(wild)) {
    calm = wild;
    wild *= 2.0;
    if (wild > max) return max;
  }
  while (wild - calm > share * wild) {
    const double middle = 0.5 * (calm + wild);
    (is_calm(middle) ? calm : wild) = middle;
  }
  return 0.5 * (calm + wild);
}

}  // namespace underact::stability
