#include "core/tradeoff/front.h"

#include <algorithm>

#include "core/base/units.h"
#include "core/tradeoff/measures.h"

namespace underact::tradeoff {
namespace {

using Candidates = std::vector<Settings>;

/// All combinations of the settings with the values of one choice.
template <class Value>
Candidates times(const Candidates& candidates, std::initializer_list<Value> values, Value Settings::*field) {
  Candidates all;
  for (const Settings& candidate : candidates) {
    for (const Value& value : values) {
      Settings next = candidate;
      next.*field = value;
      all.push_back(next);
    }
  }
  return all;
}

Settings oracleOf(Settings own) {
  own.rate_hz = kOracleRate_hz;
  own.simulation = {Integrator::Trapezoidal, scene::kShortestSubstep_us};
  own.search = Search::Global;
  own.solver = kOracleSolver;
  own.velocity = scene::RawFilter{};  // for exact angles
  return own;
}

/// The result of one set of settings for all hands; none: a run ended early, or is not possible.
std::optional<Point> measured(const std::vector<Bench>& benches, const std::vector<Run>& oracles,
                              const Settings& candidate) {
  Point point;
  point.settings = candidate;
  std::vector<double> errors_mm, errors_N;
  for (std::size_t hand = 0; hand < benches.size(); ++hand) {
    const Result<Run> one = run(benches[hand], candidate);
    if (!one || one.value().faulted) return std::nullopt;
    const RunDifference off = differenceOf(one.value(), oracles[hand]);
    const double cost_ns = one.value().tick.p50_ns + one.value().arm.p50_ns;
    point.cost_us_per_s += 1e-3 * candidate.rate_hz * cost_ns / static_cast<double>(benches.size());
    errors_mm.push_back(kMillimetrePerMetre * off.rms_m);
    errors_N.push_back(off.rms_N);
  }
  point.error_mm = lab::quantile(errors_mm, 0.5);
  point.error_N = lab::quantile(errors_N, 0.5);
  return point;
}

}  // namespace

std::vector<Settings> settingsToTry(const scene::Description& scene, int rate_hz) {
  const Settings own = settingsOf(scene, rate_hz);
  Candidates candidates{own};
  candidates = times(candidates, {250, 500, 1000, 2000, 4000, 8000}, &Settings::rate_hz);
  candidates = times(candidates,
                     {scene::Simulation{Integrator::Trapezoidal, 1000.0}, scene::Simulation{},
                      scene::Simulation{Integrator::Trapezoidal, 50.0}},
                     &Settings::simulation);
  if (hasSearch(scene))
    candidates = times(candidates, {Search::Local, Search::Hybrid, Search::Global}, &Settings::search);
  if (hasSolver(scene)) {
    using scene::Solver;
    using scene::SolverMethod;
    candidates = times(candidates, {Solver{SolverMethod::Iterative, 2, 1e-10}, Solver{}}, &Settings::solver);
  }
  if (hasVelocity(scene)) {
    const scene::Velocity calm = scene::KalmanFilter{0.016, 3000.0};
    candidates = times(candidates, {calm, scene::Velocity{}}, &Settings::velocity);
  }
  if (std::find(candidates.begin(), candidates.end(), own) == candidates.end()) candidates.push_back(own);
  return candidates;
}

void markFront(std::vector<Point>& points) {
  for (Point& point : points) {
    point.on_front = std::none_of(points.begin(), points.end(), [&](const Point& other) {
      const bool no_worse = other.cost_us_per_s <= point.cost_us_per_s && other.error_mm <= point.error_mm;
      return no_worse && (other.cost_us_per_s < point.cost_us_per_s || other.error_mm < point.error_mm);
    });
  }
}

std::vector<Point> measurePoints(const scene::Description& scene, const std::vector<NamedHand>& hands, double seconds,
                                 int rate_hz, const Progress& goes_on) {
  const Settings own = settingsOf(scene, rate_hz);
  const std::vector<Settings> candidates = settingsToTry(scene, rate_hz);
  std::vector<Bench> benches;
  std::vector<Run> oracles;
  std::vector<Point> points;
  for (const NamedHand& hand : hands) {
    benches.push_back(benchOf(scene, hand.hand, seconds));
    Result<Run> oracle = run(benches.back(), oracleOf(own), true);
    if (!oracle || oracle.value().faulted || !goes_on(0.0)) return points;
    oracles.push_back(std::move(oracle).value());
  }
  for (std::size_t index = 0; index < candidates.size(); ++index) {
    if (!goes_on(static_cast<double>(index) / static_cast<double>(candidates.size()))) break;
    std::optional<Point> point = measured(benches, oracles, candidates[index]);
    if (!point) continue;
    point->is_own = candidates[index] == own;
    points.push_back(*point);
  }
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.cost_us_per_s < b.cost_us_per_s; });
  markFront(points);
  return points;
}

}  // namespace underact::tradeoff
