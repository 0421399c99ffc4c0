#include "core/trade/measures.h"

#include <algorithm>
#include <cmath>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/arm/model.h"
#include "core/base/units.h"
#include "core/chain/numeric_inverse.h"

namespace underact::trade {
namespace {

constexpr int kOracleRate_hz = 16'000;  // a multiple of every rate that is compared with it
constexpr double kOracleSubstep_us = 5.0;
constexpr double kLeap_m_per_s2 = 100.0;  // above what the hands do (30): the target leapt
constexpr double kSameTarget_m = 1e-3;    // so near that it is the same one; a step of the encoders may choose another
constexpr double kSettled_s = 0.05;       // after a leap, or a touch: a filter's own beginning
constexpr double kEitherWay_s = 10e-6;    // of a difference that stands for a derivative

/// Root of the mean square, and the largest, of what is added.
class Errors {
 public:
  void add(double error) {
    sum_ += error * error;
    worst_ = std::max(worst_, error);
    ++count_;
  }
  /// Problems: nothing was added, so that nothing can be said.
  Result<Figures> figures(const Cost& cost, int rate_hz) const {
    if (count_ == 0) return Problems{{"The hand never touches what this is about."}};
    const double rms = std::sqrt(sum_ / static_cast<double>(count_));
    return Figures{cost, 1e-3 * cost.p50_ns * rate_hz, rms, worst_};
  }

 private:
  double sum_ = 0.0, worst_ = 0.0;
  std::size_t count_ = 0;
};

const Problems kEndedEarly{{"The run ended in a fault, and what it did before says nothing."}};

Figures figuresOf(const Apart& apart, const Cost& cost, int rate_hz) {
  return {cost, 1e-3 * cost.p50_ns * rate_hz, kMillimetrePerMetre * apart.rms_m, kMillimetrePerMetre * apart.most_m};
}

}  // namespace

Result<Figures> measureRate(const Bench& bench, const Settings& settings) {
  Settings best = settings;
  best.rate_hz = kOracleRate_hz;
  const Result<Run> fine = run(bench, best);
  const Result<Run> coarse = run(bench, settings);
  if (!fine) return fine.problems();
  if (!coarse) return coarse.problems();
  if (fine.value().faulted || coarse.value().faulted) return kEndedEarly;
  return figuresOf(apart(coarse.value(), fine.value()), coarse.value().tick, settings.rate_hz);
}

Result<Figures> measureSimulation(const Bench& bench, const Settings& settings) {
  Settings best = settings;
  best.simulation = {Integrator::Trapezoidal, kOracleSubstep_us};
  const Result<Run> fine = run(bench, best);
  const Result<Run> coarse = run(bench, settings);
  if (!fine) return fine.problems();
  if (!coarse) return coarse.problems();
  if (fine.value().faulted || coarse.value().faulted) return kEndedEarly;
  return figuresOf(apart(coarse.value(), fine.value()), coarse.value().arm, settings.rate_hz);
}

Result<Figures> measureSearch(const Bench& bench, const Settings& settings) {
  Settings best = settings;
  best.search = Search::Global;
  const std::vector<double> times = timesOf(bench, settings.rate_hz);
  const Result<Walk> found = walk(bench, settings, times, false), nearest = walk(bench, best, times, false);
  if (!found) return found.problems();
  if (!nearest) return nearest.problems();
  Errors errors;
  for (std::size_t index = 0; index < found.value().distance_m.size(); ++index) {
    const std::vector<double>&one = found.value().distance_m[index], &other = nearest.value().distance_m[index];
    for (std::size_t tick = 0; tick < std::min(one.size(), other.size()); ++tick)
      errors.add(kMillimetrePerMetre * std::max(0.0, one[tick] - other[tick]));
  }
  return errors.figures(found.value().tick, settings.rate_hz);
}

Result<Figures> measureSolver(const Bench& bench, const Settings& settings) {
  Settings best = settings;
  best.solver = {scene::SolverMethod::Iterative, 100, 1e-14};
  const std::vector<double> times = timesOf(bench, settings.rate_hz);
  const Result<Walk> found = walk(bench, settings, times, false), solved = walk(bench, best, times, false);
  if (!found) return found.problems();
  if (!solved) return solved.problems();
  Errors errors;
  for (std::size_t index = 0; index < found.value().p_WP.size(); ++index) {
    const Walk &one = found.value(), &other = solved.value();
    for (std::size_t tick = 0; tick < std::min(one.p_WP[index].size(), other.p_WP[index].size()); ++tick) {
      if (one.acts[index][tick] && other.acts[index][tick])
        errors.add(kMillimetrePerMetre * (one.p_WP[index][tick] - other.p_WP[index][tick]).norm());
    }
  }
  return errors.figures(found.value().tick, settings.rate_hz);
}

Result<Figures> measureVelocity(const Bench& bench, const Settings& settings) {
  const std::vector<double> times = timesOf(bench, settings.rate_hz);
  std::vector<double> around;  // before and after each of them
  for (const double time_s : times) {
    around.push_back(std::max(0.0, time_s - kEitherWay_s));
    around.push_back(time_s + kEitherWay_s);
  }
  const Result<Walk> felt = walk(bench, settings, times, true), exact = walk(bench, settings, around, false);
  if (!felt) return felt.problems();
  if (!exact) return exact.problems();
  const auto settled = static_cast<int>(kSettled_s * settings.rate_hz);
  Errors errors;
  for (std::size_t index = 0; index < felt.value().rate_W.size(); ++index) {
    const scene::Control& control = controlOf(bench.scene, index);
    // Rates of joints are no rates of the tip, and a P law finds none.
    if (control.space == tick::Space::Joint || control.law == scene::LawType::P) continue;
    const std::vector<Vec3>& e_W = exact.value().e_W[index];
    Vec3 last_W = Vec3::Zero();
    int even = 0;  // ticks of one motion, without a leap of the target
    for (std::size_t tick = 0; tick < felt.value().rate_W[index].size(); ++tick) {
      const bool acts = felt.value().acts[index][tick] && exact.value().acts[index][2 * tick] &&
                        exact.value().acts[index][2 * tick + 1];
      const Vec3 elsewhere_W = felt.value().p_WP[index][tick] - exact.value().p_WP[index][2 * tick];
      const Vec3 rate_W = (e_W[2 * tick + 1] - e_W[2 * tick]) / (2.0 * kEitherWay_s);
      even = acts && elsewhere_W.norm() < kSameTarget_m && (rate_W - last_W).norm() < kLeap_m_per_s2 / settings.rate_hz
                 ? even + 1
                 : 0;
      last_W = rate_W;
      if (even > settled) errors.add(kMillimetrePerMetre * (felt.value().rate_W[index][tick] - rate_W).norm());
    }
  }
  return errors.figures(felt.value().tick, settings.rate_hz);
}

Result<Figures> measureInverse(const Bench& bench, const Settings& settings) {
  const arm::Preset& preset = *arm::findPreset(bench.scene.arm);
  const chain::Chain chain = arm::chainOf(*arm::findModel(bench.scene.arm));
  chain::NumericOptions options;
  options.max_steps = settings.inverse_steps;
  const std::vector<double> times = timesOf(bench, settings.rate_hz);
  Stopwatch watch(times.size());
  Errors errors;
  arm::JointAngles q_rad{};
  for (const double time_s : times) {
    const sim::HandWish wish = wishAt(bench.hand, std::llround(1e9 * time_s));
    const arm::Reach reach = arm::reach(preset.geometry, wish.p_WT);
    if (!reach.reachable) continue;
    const Pose X_WT = arm::tipPose(preset.geometry, arm::withWrist(reach.q_rad, wish.R_WT));
    const bool begins = time_s == times.front();
    watch.time([&] {
      if (settings.inverse_steps == 0 || begins) {
        q_rad = arm::withWrist(arm::reach(preset.geometry, X_WT.translation()).q_rad, X_WT.linear());
      } else {
        const chain::NumericSolution solution = chain::solveNumerically(chain, X_WT, q_rad, options);
        std::copy_n(solution.q.begin(), q_rad.size(), q_rad.begin());
      }
    });
    errors.add(kMillimetrePerMetre * (arm::tipPosition(preset.geometry, q_rad) - X_WT.translation()).norm());
  }
  return errors.figures(watch.cost(), settings.rate_hz);
}

}  // namespace underact::trade
