#include "core/identify/identified.h"

#include <algorithm>
#include <cmath>

#include "core/arm/sample.h"
#include "core/base/translate.h"
#include "core/base/units.h"

namespace underact::identify {
namespace {

const Problems kStopped{{phrase(TRANSLATE_NOOP("problem", "The evaluation was cancelled."))}};

/// The rows of all stages of that kind, in order.
template <class Chosen>
std::vector<MotionRow> rowsOf(const Plan& plan, const std::vector<Recorded>& recorded, const Chosen& chosen) {
  std::vector<MotionRow> rows;
  for (const Recorded& one : recorded) {
    if (chosen(plan.stages[one.stage])) rows.insert(rows.end(), one.rows.begin(), one.rows.end());
  }
  return rows;
}

/// The sentence, preceded by the swing that it is about.
Sentence at(std::size_t place, int axis, const Sentence& sentence) {
  return phrase(TRANSLATE_NOOP("problem", "Along %1 at position %2: %3"),
                {std::string(1, "xyz"[axis]), std::to_string(place + 1), sentence});
}

Result<AxisSwings> swingsOf(const std::vector<MotionRow>& rows, std::size_t place, int axis, double period_s,
                            const std::function<bool()>& stops) {
  AxisSwings swings;
  swings.place = place;
  swings.axis = axis;
  swings.windows = windowsOf(rows, Vec3::Unit(axis), period_s);
  Result<BodyFit> fit = fitBody(swings.windows, stops);
  if (!fit) {
    Problems problems = fit.problems();
    for (Problem& problem : problems) problem.sentence = at(place, axis, problem.sentence);
    return problems;
  }
  swings.fit = std::move(fit).value();
  swings.stiffness =
      stiffnessFromSwing(rows, Vec3::Unit(axis), period_s, swings.fit.body, kNewtonPerMetre * kSwing_N_per_mm);
  return swings;
}

/// All swings, axis by axis at each position. stops: true ends it; the result is incomplete then.
Problems addSwings(const Plan& plan, const std::vector<Recorded>& recorded, const std::function<bool()>& stops,
                   Identified& found) {
  Problems problems;
  for (std::size_t place = 0; place < plan.places_W.size(); ++place) {
    for (int axis = 0; axis < 3; ++axis) {
      if (stops()) return problems;
      const auto isOne = [&](const Stage& stage) {
        return stage.kind == StageKind::Swing && stage.place == place && stage.axis == axis;
      };
      Result<AxisSwings> swings = swingsOf(rowsOf(plan, recorded, isOne), place, axis, 1.0 / found.rate_hz, stops);
      if (swings)
        found.swings.push_back(std::move(swings).value());
      else
        problems.insert(problems.end(), swings.problems().begin(), swings.problems().end());
    }
  }
  return problems;
}

/// The counts of the encoders. stops: true ends it; the result is incomplete then.
std::array<std::optional<Estimate>, 6> countsOf(const std::vector<Recorded>& recorded,
                                                const std::function<bool()>& stops) {
  std::array<std::vector<double>, 6> angles_rad;
  for (const Recorded& one : recorded) {
    if (stops()) return {};
    for (const MotionRow& row : one.rows) {
      const arm::JointAngles device_rad = arm::deviceFromDh(row.q_rad);
      for (std::size_t joint = 0; joint < 6; ++joint) angles_rad[joint].push_back(device_rad[joint]);
    }
  }
  std::array<std::optional<Estimate>, 6> counts;
  for (std::size_t joint = 0; joint < 6 && !stops(); ++joint) counts[joint] = countOf(angles_rad[joint]);
  return counts;
}

// What a body that moves in one direction misses of one that moves in three, in deviations of a fit: found over 500
// arms (the guide's page identify.md). All fits have it in common, so that no mean over them makes it smaller.
constexpr double kCommon = 0.4;

/// The mean over all positions along an axis, or (axis below 0) over all swings.
Estimate meanOver(const std::vector<AxisSwings>& all, int axis, double Body::*what) {
  std::vector<Estimate> estimates;
  double deviations = 0.0;
  for (const AxisSwings& one : all) {
    if (axis >= 0 && one.axis != axis) continue;
    estimates.push_back({one.fit.body.*what, one.fit.uncertainty.*what});
    deviations += one.fit.uncertainty.*what;
  }
  const double common = kCommon * deviations / static_cast<double>(std::max<std::size_t>(1, estimates.size()));
  const Estimate mean = meanOf(estimates);
  return {mean.value, std::hypot(mean.uncertainty, common)};
}

void average(Identified& found) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto index = static_cast<std::size_t>(axis);
    found.mass_kg[index] = meanOver(found.swings, axis, &Body::mass_kg);
    found.friction_N[index] = meanOver(found.swings, axis, &Body::friction_N);
    found.damping_N_s_per_m[index] = meanOver(found.swings, axis, &Body::damping_N_s_per_m);
  }
  found.mean_mass_kg = meanOver(found.swings, -1, &Body::mass_kg);
  found.mean_friction_N = meanOver(found.swings, -1, &Body::friction_N);
  found.mean_damping_N_s_per_m = meanOver(found.swings, -1, &Body::damping_N_s_per_m);
}

/// What chi^2 / free exceeds in 1 of 20 cases (Wilson and Hilferty 1931; within 1 % from two degrees of freedom on).
double maxByChance(double free) {
  const double variance = 2.0 / (9.0 * free);
  return std::pow(1.0 - variance + 1.645 * std::sqrt(variance), 3);
}

}  // namespace

Estimate meanOf(const std::vector<Estimate>& estimates) {
  const double count = static_cast<double>(estimates.size()), free = count - 1.0;
  double sum = 0.0, variances = 0.0, weights = 0.0, weighted = 0.0, squares = 0.0, chi_squares = 0.0;
  const auto weightOf = [](const Estimate& one) { return 1.0 / std::max(one.uncertainty * one.uncertainty, 1e-300); };
  for (const Estimate& one : estimates) {
    sum += one.value;
    variances += one.uncertainty * one.uncertainty;
    weights += weightOf(one);
    weighted += weightOf(one) * one.value;
  }
  const double mean = sum / count;
  for (const Estimate& one : estimates) {
    squares += std::pow(one.value - mean, 2);
    chi_squares += weightOf(one) * std::pow(one.value - weighted / weights, 2);
  }
  const bool scatters = free > 0.0 && chi_squares > free * maxByChance(free);
  return {mean, std::sqrt(std::max(variances, scatters ? squares * count / free : 0.0)) / count};
}

Result<Identified> evaluate(const Plan& plan, const std::vector<Recorded>& recorded, int rate_hz,
                            const std::function<bool()>& stop) {
  bool is_stopped = false;
  const std::function<bool()> stops = [&] { return is_stopped = is_stopped || (stop && stop()); };
  Identified found;
  const double period_s = 1.0 / rate_hz;
  found.rate_hz = rate_hz;
  found.arm = plan.stages.front().scene.arm;
  found.places_W = plan.places_W;
  const Problems problems = addSwings(plan, recorded, stops, found);
  if (is_stopped) return kStopped;
  if (!problems.empty()) return problems;
  average(found);
  const auto rowsOfKind = [&](StageKind kind) {
    return rowsOf(plan, recorded, [kind](const Stage& stage) { return stage.kind == kind; });
  };
  found.counts_per_turn = countsOf(recorded, stops);
  if (stops()) return kStopped;
  found.rest_noise_m = restNoise(rowsOfKind(StageKind::Rest));
  const std::vector<MotionRow> pressed = rowsOfKind(StageKind::Press);
  found.slow_noise_m = slowNoise(pressed, period_s);
  if (stops()) return kStopped;
  Result<Press> press = pressOf(pressed, kPressAlong_W, period_s);
  if (press)
    found.press = std::move(press).value();
  else
    found.notes = press.problems();
  return found;
}

}  // namespace underact::identify
