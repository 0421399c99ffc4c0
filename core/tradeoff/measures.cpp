#include "core/tradeoff/measures.h"

#include <algorithm>
#include <cmath>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/arm/model.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/chain/numeric_inverse.h"
#include "core/scene/scene_arm.h"

namespace underact::tradeoff {
namespace {

constexpr double kLeap_m_per_s2 = 100.0;  // above that of the hands (30): the target has jumped
constexpr double kSameTarget_m = 1e-3;    // within this it is the same target; an encoder step may select another one
constexpr double kSettled_s = 0.05;       // after a jump, or a touch: the start of a filter
constexpr double kEitherWay_s = 10e-6;    // of a difference quotient

/// The root mean square and the largest of the values added.
class Errors {
 public:
  void add(double error) {
    sum_ += error * error;
    worst_ = std::max(worst_, error);
    ++count_;
  }
  /// Problems: nothing was added, so there is no result.
  Result<Figures> figures(const lab::Cost& cost, int rate_hz) const {
    if (count_ == 0) return Problems{{phrase(TRANSLATE_NOOP("problem", "The hand never touches the constraint."))}};
    const double rms = std::sqrt(sum_ / static_cast<double>(count_));
    return Figures{cost, 1e-3 * cost.p50_ns * rate_hz, rms, worst_};
  }

 private:
  double sum_ = 0.0, worst_ = 0.0;
  std::size_t count_ = 0;
};

const Problems kEndedEarly{
    {phrase(TRANSLATE_NOOP("problem", "The run ended in a fault, so what it measured means nothing."))}};

/// The motion of the tip against that of the finest run. cost: which part of an option's own run is timed.
Measure againstRun(const Bench& bench, const Settings& finest, lab::Cost Run::*cost) {
  return [bench, fine = run(bench, finest), cost](const Settings& settings) -> Result<Figures> {
    if (!fine) return fine.problems();
    if (fine.value().faulted) return kEndedEarly;
    const Result<Run> one = run(bench, settings);
    if (!one) return one.problems();
    if (one.value().faulted) return kEndedEarly;
    const RunDifference off = differenceOf(one.value(), fine.value());
    const lab::Cost& own = one.value().*cost;
    return Figures{own, 1e-3 * own.p50_ns * settings.rate_hz, kMillimetrePerMetre * off.rms_m,
                   kMillimetrePerMetre * off.max_m};
  };
}

/// Compares the results of ticks along one path, the same for all options, with exact ones.
using Compare = Errors (*)(const Bench& bench, const Settings& settings, const Walk& found, const Walk& exact);
Measure againstWalk(const Bench& bench, JointPath path, Result<Walk> exact, Compare errorsOf) {
  return [bench, path = std::move(path), exact = std::move(exact), errorsOf](const Settings& s) -> Result<Figures> {
    if (!exact) return exact.problems();
    const Result<Walk> found = walk(bench, s, path);
    if (!found) return found.problems();
    return errorsOf(bench, s, found.value(), exact.value()).figures(found.value().tick, s.rate_hz);
  };
}

Errors fartherOff(const Bench&, const Settings&, const Walk& found, const Walk& nearest) {
  Errors errors;
  for (std::size_t index = 0; index < found.distance_m.size(); ++index) {
    const std::vector<double>&one = found.distance_m[index], &other = nearest.distance_m[index];
    for (std::size_t tick = 0; tick < std::min(one.size(), other.size()); ++tick)
      errors.add(kMillimetrePerMetre * std::max(0.0, one[tick] - other[tick]));
  }
  return errors;
}

Errors besideTarget(const Bench&, const Settings&, const Walk& one, const Walk& other) {
  Errors errors;
  for (std::size_t index = 0; index < one.p_WP.size(); ++index) {
    for (std::size_t tick = 0; tick < std::min(one.p_WP[index].size(), other.p_WP[index].size()); ++tick) {
      if (one.acts[index][tick] && other.acts[index][tick])
        errors.add(kMillimetrePerMetre * (one.p_WP[index][tick] - other.p_WP[index][tick]).norm());
    }
  }
  return errors;
}

/// exact: with two ticks around each of those of felt.
Errors besideRate(const Bench& bench, const Settings& settings, const Walk& felt, const Walk& exact) {
  const auto settled = static_cast<int>(kSettled_s * settings.rate_hz);
  Errors errors;
  for (std::size_t index = 0; index < felt.rate_W.size(); ++index) {
    const scene::Control& control = controlOf(bench.scene, index);
    // Joint rates are not rates of the tip, and a P law has none.
    if (control.space == tick::Space::Joint || control.law == scene::LawType::P) continue;
    const std::vector<Vec3>& e_W = exact.e_W[index];
    Vec3 last_W = Vec3::Zero();
    int even = 0;  // ticks of one motion, without a jump of the target
    for (std::size_t tick = 0; tick < felt.rate_W[index].size(); ++tick) {
      const bool acts = felt.acts[index][tick] && exact.acts[index][2 * tick] && exact.acts[index][2 * tick + 1];
      const Vec3 elsewhere_W = felt.p_WP[index][tick] - exact.p_WP[index][2 * tick];
      const Vec3 rate_W = (e_W[2 * tick + 1] - e_W[2 * tick]) / (2.0 * kEitherWay_s);
      even = acts && elsewhere_W.norm() < kSameTarget_m && (rate_W - last_W).norm() < kLeap_m_per_s2 / settings.rate_hz
                 ? even + 1
                 : 0;
      last_W = rate_W;
      if (even > settled) errors.add(kMillimetrePerMetre * (felt.rate_W[index][tick] - rate_W).norm());
    }
  }
  return errors;
}

}  // namespace

Measure rateOn(const Bench& bench, const Settings& base) {
  Settings finest = base;
  finest.rate_hz = kOracleRate_hz;
  return againstRun(bench, finest, &Run::tick);
}

Measure simulationOn(const Bench& bench, const Settings& base) {
  Settings finest = base;
  finest.simulation = {Integrator::Trapezoidal, kOracleSubstep_us};
  return againstRun(bench, finest, &Run::arm);
}

Measure searchOn(const Bench& bench, const Settings& base) {
  Settings exact = base;
  exact.search = Search::Global;
  const JointPath path = jointPathOf(bench, timesOf(bench, base.rate_hz), false);
  return againstWalk(bench, path, walk(bench, exact, path), fartherOff);
}

Measure solverOn(const Bench& bench, const Settings& base) {
  Settings exact = base;
  exact.solver = kOracleSolver;
  const JointPath path = jointPathOf(bench, timesOf(bench, base.rate_hz), false);
  return againstWalk(bench, path, walk(bench, exact, path), besideTarget);
}

Measure velocityOn(const Bench& bench, const Settings& base) {
  const std::vector<double> times = timesOf(bench, base.rate_hz);
  std::vector<double> around;  // before and after each of them
  for (const double time_s : times) {
    around.push_back(std::max(0.0, time_s - kEitherWay_s));
    around.push_back(time_s + kEitherWay_s);
  }
  return againstWalk(bench, jointPathOf(bench, times, true), walk(bench, base, jointPathOf(bench, around, false)),
                     besideRate);
}

Measure inverseOn(const Bench& bench, const Settings& base) {
  const arm::Preset& preset = scene::armOf(bench.scene);
  std::vector<Pose> poses;  // those that the hand wants and the arm reaches
  for (const double time_s : timesOf(bench, base.rate_hz)) {
    const sim::HandSetpoint setpoint = setpointAt(bench.hand, std::llround(1e9 * time_s));
    const arm::PositionSolution reach = arm::solvePosition(preset.geometry, setpoint.p_WT);
    if (reach.reachable) poses.push_back(arm::tipPose(preset.geometry, arm::solveWrist(reach.q_rad, setpoint.R_WT)));
  }
  const chain::Chain chain = scene::modelOf(bench.scene).chain;
  return [geometry = preset.geometry, poses = std::move(poses), chain](const Settings& settings) {
    chain::NumericOptions options;
    options.max_steps = settings.inverse_steps;
    lab::Stopwatch watch(poses.size());
    Errors errors;
    arm::JointAngles q_rad{};
    for (const Pose& X_WT : poses) {
      const bool begins = &X_WT == poses.data();
      watch.time([&] {
        if (settings.inverse_steps == 0 || begins) {
          q_rad = arm::solveWrist(arm::solvePosition(geometry, X_WT.translation()).q_rad, X_WT.linear());
        } else {
          const chain::NumericSolution solution = chain::solveNumerically(chain, X_WT, q_rad, options);
          std::copy_n(solution.q.begin(), q_rad.size(), q_rad.begin());
        }
      });
      errors.add(kMillimetrePerMetre * (arm::tipPosition(geometry, q_rad) - X_WT.translation()).norm());
    }
    return errors.figures(watch.cost(), settings.rate_hz);
  };
}

bool measureEach(const Choice& choice, const Bench& bench, const Settings& base, const std::vector<Entry>& entries,
                 const std::function<bool()>& goes_on,
                 const std::function<void(const Entry& entry, const Figures& figures)>& add) {
  Measure measure;
  for (const Entry& entry : entries) {
    if (!goes_on()) return false;
    if (!measure) measure = choice.measureOn(bench, base);  // only when the first is asked for
    const Result<Figures> figures = measure(entry.settings);
    if (figures) add(entry, figures.value());
  }
  return true;
}

}  // namespace underact::tradeoff
