#include "core/calibration/measurement.h"

#include <cmath>
#include <utility>

#include "core/json/json.h"

namespace underact::calibration {
namespace {

using json::numberText;

constexpr double kAt707 = 0.5450;  // where the normal distribution reaches sqrt(1/2), in standard deviations

}  // namespace

Measurement beginMeasurement(double reference_N_per_mm, std::uint64_t seed) {
  Measurement run;
  run.reference_N_per_mm = reference_N_per_mm;
  run.staircase = beginStaircase();
  run.sides = seed;
  run.trial = drawTrial(run.staircase, reference_N_per_mm, run.sides);
  return run;
}

Measurement answered(Measurement run, Beam answer) {
  Answered one{run.trial, answer};
  const std::size_t reversals = run.staircase.reversals.size();
  run.staircase = answered(std::move(run.staircase), one.isRight());
  one.turned = run.staircase.reversals.size() > reversals;
  run.answers.push_back(one);
  if (!isDone(run)) run.trial = drawTrial(run.staircase, run.reference_N_per_mm, run.sides);
  return run;
}

bool isDone(const Measurement& run) {
  return isDone(run.staircase);
}

double scatterOf(double threshold) {
  return std::log1p(threshold) / (kAt707 * std::sqrt(2.0));
}

std::string csvOf(const Measurement& run, const std::string& answered_by, std::uint64_t seed) {
  const auto threshold = thresholdOf(run.staircase);
  const auto share = [&](double Threshold::*number) { return threshold ? numberText((*threshold).*number) : "none"; };
  std::string csv = "# just-noticeable difference " + share(&Threshold::difference) + "; one standard deviation " +
                    share(&Threshold::low) + " to " + share(&Threshold::high) + "; reference " +
                    numberText(run.reference_N_per_mm) + " N/mm; trials " + std::to_string(run.answers.size()) +
                    "; answered by " + answered_by + "; seed " + std::to_string(seed) +
                    "\ntrial,difference,stiffer,answer,right\n";
  for (std::size_t index = 0; index < run.answers.size(); ++index) {
    const Answered& one = run.answers[index];
    csv += std::to_string(index + 1) + ',' + numberText(one.trial.difference) + ',' + name(one.trial.stiffer) + ',' +
           name(one.answer) + ',' + (one.isRight() ? "1" : "0") + '\n';
  }
  return csv;
}

}  // namespace underact::calibration
