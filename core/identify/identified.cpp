#include "core/identify/identified.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace underact::identify {
namespace {

/// The rows of all stages of that kind, in order.
template <class Chosen>
std::vector<Row> rowsOf(const Plan& plan, const std::vector<Recorded>& recorded, const Chosen& chosen) {
  std::vector<Row> rows;
  for (const Recorded& one : recorded) {
    if (chosen(plan.stages[one.stage])) rows.insert(rows.end(), one.rows.begin(), one.rows.end());
  }
  return rows;
}

std::string placeWords(std::size_t place, int axis) {
  return std::string("Along ") + "xyz"[axis] + " at place " + std::to_string(place + 1) + ": ";
}

Result<AxisSwings> swingsOf(const std::vector<Row>& rows, std::size_t place, int axis, double period_s) {
  AxisSwings swings;
  swings.place = place;
  swings.axis = axis;
  swings.windows = windowsOf(rows, Vec3::Unit(axis), period_s);
  Result<BodyFit> fit = fitBody(swings.windows);
  if (!fit) {
    Problems problems = fit.problems();
    for (Problem& problem : problems) problem.sentence = placeWords(place, axis) + problem.sentence;
    return problems;
  }
  swings.fit = std::move(fit).value();
  swings.stiffness =
      swingStiffness(rows, Vec3::Unit(axis), period_s, swings.fit.body, kNewtonPerMetre * kSwing_N_per_mm);
  return swings;
}

/// Over all places along an axis, or (axis below 0) over all there is.
Estimate meanOver(const std::vector<AxisSwings>& all, int axis, double Body::*what) {
  std::vector<Estimate> estimates;
  for (const AxisSwings& one : all) {
    if (axis < 0 || one.axis == axis) estimates.push_back({one.fit.body.*what, one.fit.uncertainty.*what});
  }
  return meanOf(estimates);
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

}  // namespace

Estimate meanOf(const std::vector<Estimate>& estimates) {
  double weights = 0.0, sum = 0.0, squares = 0.0;
  const auto weightOf = [](const Estimate& one) { return 1.0 / std::max(one.uncertainty * one.uncertainty, 1e-300); };
  for (const Estimate& one : estimates) {
    weights += weightOf(one);
    sum += weightOf(one) * one.value;
  }
  const double mean = sum / weights;
  for (const Estimate& one : estimates) squares += weightOf(one) * std::pow(one.value - mean, 2);
  const double count = static_cast<double>(estimates.size());
  const double scatter = count > 1.0 ? squares / ((count - 1.0) * weights) : 0.0;
  return {mean, std::sqrt(std::max(1.0 / weights, scatter))};
}

Result<Identified> evaluate(const Plan& plan, const std::vector<Recorded>& recorded, int rate_hz) {
  Identified found;
  Problems problems;
  const double period_s = 1.0 / rate_hz;
  found.rate_hz = rate_hz;
  found.arm = plan.stages.front().scene.arm;
  found.places_W = plan.places_W;
  for (std::size_t place = 0; place < plan.places_W.size(); ++place) {
    for (int axis = 0; axis < 3; ++axis) {
      Result<AxisSwings> swings =
          swingsOf(rowsOf(plan, recorded,
                          [&](const Stage& stage) {
                            return stage.kind == StageKind::Swing && stage.place == place && stage.axis == axis;
                          }),
                   place, axis, period_s);
      if (swings)
        found.swings.push_back(std::move(swings).value());
      else
        problems.insert(problems.end(), swings.problems().begin(), swings.problems().end());
    }
  }
  if (!problems.empty()) return problems;
  average(found);
  const auto rowsOfKind = [&](StageKind kind) {
    return rowsOf(plan, recorded, [kind](const Stage& stage) { return stage.kind == kind; });
  };
  found.counts_per_turn = countsOf(rowsOf(plan, recorded, [](const Stage&) { return true; }));
  found.rest_noise_m = restNoise(rowsOfKind(StageKind::Rest));
  const std::vector<Row> pressed = rowsOfKind(StageKind::Press);
  found.slow_noise_m = slowNoise(pressed, period_s);
  Result<Press> press = pressOf(pressed, kPressAlong_W, period_s);
  if (press)
    found.press = std::move(press).value();
  else
    found.notes = press.problems();
  return found;
}

}  // namespace underact::identify
