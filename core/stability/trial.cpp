#include "core/stability/trial.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/arm/forward.h"
#include "core/base/units.h"
#include "core/control/law.h"
#include "core/stability/exact.h"

namespace underact::stability {
namespace {

constexpr double kLinearPush_m = 1e-6;  // large against rounding, small enough for the arm to be a mass
constexpr double kBeyond = 5.0;         // pushes: it will not return
constexpr double kAtRest = 1e-4;        // of the push
constexpr double kSeconds = 0.5;        // before the first judgement, at least
constexpr double kSwings = 6.0;         // periods before the first judgement: more than one in a quarter
constexpr double kMaxTicks = 4e6;       // before the first judgement; slower motions are judged too early
constexpr double kMin_N_per_m = 1e-2, kDefaultLeast_N_per_m = 1.0;  // the start of the search
constexpr int kLinearLooks = 256, kOtherLooks = 16;  // times as long at most, while hardly anything changes

}  // namespace

const char* name(Behaviour behaviour) {
  constexpr std::array<const char*, 3> kNames{"rest", "limit_cycle", "grows"};
  return kNames[static_cast<std::size_t>(behaviour)];
}

int ticksToObserve(double mass_kg, double stiffness_N_per_m, double period_s) {
  const double swing_s = 2.0 * kPi * std::sqrt(mass_kg / stiffness_N_per_m);
  return static_cast<int>(std::min(std::max(kSeconds, kSwings * swing_s) / period_s, kMaxTicks));
}

SwingObserver::SwingObserver(double push_m, const Rules& rules)
    : push_m_(push_m), rules_(rules), next_(std::max(rules.min_ticks, 16)) {}

void SwingObserver::Span::add(double off_m) {
  min_m = std::min(min_m, off_m);
  max_m = std::max(max_m, off_m);
}

Behaviour SwingObserver::judge() const {
  const double early_m = early_.amplitude_m(), late_m = late_.amplitude_m();
  if (late_m <= kAtRest * push_m_) return Behaviour::Rest;
  if (rules_.motion == Motion::Linear) return late_m < early_m ? Behaviour::Rest : Behaviour::Grows;
  if (late_m < (1.0 - rules_.tells) * early_m) return Behaviour::Rest;
  const bool may_last = rules_.motion == Motion::Stepped || late_m <= (1.0 + rules_.tells) * early_m;
  return may_last && late_m <= push_m_ ? Behaviour::LimitCycle : Behaviour::Grows;
}

bool SwingObserver::goesOn(double off_m) {
  const int tick = trial_.ticks++;
  if (!(std::abs(off_m) <= kBeyond * push_m_)) {
    trial_.behaviour = Behaviour::Grows;
    trial_.amplitude_m = std::abs(off_m);
    return false;
  }
  if (tick >= next_ / 4 && tick < next_ / 2) early_.add(off_m);
  if (tick >= next_ / 4 * 3) late_.add(off_m);
  if (trial_.ticks < next_) return true;
  const double early_m = early_.amplitude_m(), late_m = late_.amplitude_m();
  const bool tells = std::abs(late_m - early_m) > rules_.tells * early_m;
  const bool was_steady = steady_;
  steady_ = !tells && rules_.motion != Motion::Linear;
  const bool told = late_m <= kAtRest * push_m_ || (rules_.motion == Motion::Linear && tells) ||
                    (steady_ && was_steady) || next_ > rules_.max_ticks / 2;
  trial_.behaviour = judge();
  trial_.amplitude_m = late_m;
  if (told) return false;
  early_ = late_;  // the last quarter becomes the end of the second quarter of twice as many ticks
  late_ = {};
  next_ *= 2;
  return true;
}

TrialResult tryWall(const SampledWall& wall, double stiffness_N_per_m, double push_m) {
  const bool linear = wall.isLinear();
  const double off_m = linear ? kLinearPush_m : push_m;
  const int min = ticksToObserve(wall.mass_kg, stiffness_N_per_m + wall.hand_stiffness_N_per_m, wall.period_s());
  SwingObserver observer(off_m,
                         {min, min * (linear ? kLinearLooks : kOtherLooks), linear ? Motion::Linear : Motion::Stepped});
  const sim::Plant plant = plantOf(wall);
  const Vec3 p_WP(0.0, 0.0, 0.03);
  const control::Law law =
      control::PD{Vec3::Constant(stiffness_N_per_m), Vec3::Constant(wall.kd_N_s_per_m), wall.velocity};
  control::LawState memory;
  sim::PlantState state = restingState(plant, p_WP);
  state.p_WT.x() += off_m;
  sim::HandSetpoint setpoint;
  setpoint.p_WT = p_WP;
  std::array<Vec3, kMaxDelay + 1> asked;
  asked.fill(Vec3::Zero());
  const auto late = static_cast<std::size_t>(std::clamp(wall.delay_ticks, 0, kMaxDelay));
  for (std::size_t tick = 0;; ++tick) {
    const Vec3 p_WSeen =
        plant.model.encoders ? arm::tipPosition(plant.arm.geometry, shownAngles(plant, state)) : state.p_WT;
    asked[tick % (late + 1)] = control::force(law, memory, p_WP - p_WSeen, {wall.period_s(), false, false});
    state = advance(plant, state, asked[(tick + 1) % (late + 1)], setpoint, wall.period_ns);
    if (observer.goesOn(state.p_WT.x() - p_WP.x())) continue;
    TrialResult trial = observer.trial();
    trial.amplitude_m *= push_m / off_m;  // of a linear wall it is proportional to the push
    return trial;
  }
}

double simulatedLimit(const SampledWall& wall, double share) {
  const auto is_calm = [&](double K) { return tryWall(wall, K).behaviour != Behaviour::Grows; };
  const bool is_default = is_calm(kDefaultLeast_N_per_m);
  if (!is_default && !is_calm(kMin_N_per_m)) return 0.0;
  return limitBySearch(is_calm, is_default ? kDefaultLeast_N_per_m : kMin_N_per_m, kMaxStiffness_N_per_m, share);
}

}  // namespace underact::stability
