#include "core/lab/sampled_response.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/lab/second_order_fit.h"
#include "core/lab/unit_step.h"
#include "tests/support/property.h"

namespace underact::lab {
namespace {

SampledResponse sampled(const TransferFunction& transfer, double gain, double seconds, double period_s,
                        double start = 0.0) {
  const UnitStep step(transfer);
  SampledResponse curve{period_s, {}};
  for (double t_s = 0.0; t_s <= seconds; t_s += period_s) curve.value.push_back(start + gain * step.at(t_s));
  return curve;
}

TEST(SampledResponse, ItsMetricsAreThoseOfTheFunctionItIsSampledFrom) {
  test::Random random({20260803});
  for (int count = 0; count < test::sweep(8, 200); ++count) {
    const double omega = random.between(5.0, 50.0), zeta = random.between(0.1, 2.0);
    const TransferFunction transfer = secondOrder(omega, zeta);
    const StepMetrics exact = metricsOf(transfer);
    const double period_s = 3e-3 / omega;
    const StepMetrics found = metricsOf(sampled(transfer, 0.01, 5.0 * *exact.settling_2pct_s, period_s, 0.3));
    EXPECT_NEAR(*found.final_value, 0.01, 1e-6);
    EXPECT_NEAR(*found.rise_10_90_s, *exact.rise_10_90_s, 1e-3 * *exact.rise_10_90_s) << zeta;
    EXPECT_NEAR(*found.overshoot_fraction, *exact.overshoot_fraction, 1e-4) << zeta;
    if (*exact.overshoot_fraction > 1e-3) {
      EXPECT_NEAR(*found.peak_time_s, *exact.peak_time_s, 2.0 * period_s) << zeta;
    }
  }
}

TEST(SampledResponse, SettlingIsOnTheLineBetweenTwoSamples) {
  // 0, 0.5, 1, 1, ...: within 2 % from 0.98 on, between the second and the third.
  SampledResponse curve{1.0, std::vector<double>(20, 1.0)};
  curve.value[0] = 0.0;
  curve.value[1] = 0.5;
  const StepMetrics metrics = metricsOf(curve);
  EXPECT_NEAR(*metrics.settling_2pct_s, 1.0 + 0.48 / 0.5, 1e-12);
  EXPECT_NEAR(*metrics.rise_10_90_s, 1.8 - 0.2, 1e-12);
  EXPECT_EQ(metrics.overshoot_fraction, 0.0);
  EXPECT_FALSE(metrics.peak_time_s.has_value());
}

TEST(SampledResponse, NeverSettlesWhileItSwings) {
  const StepMetrics metrics = metricsOf(sampled(secondOrder(10.0, 0.0), 1.0, 20.0 * kPi, 1e-3));
  EXPECT_FALSE(metrics.settling_2pct_s.has_value());
  EXPECT_NEAR(*metrics.final_value, 1.0, 0.01);
}

TEST(SampledResponse, MeasuresNothingWhereNothingMoved) {
  const StepMetrics metrics = metricsOf(SampledResponse{1e-3, std::vector<double>(100, 0.25)});
  EXPECT_EQ(metrics.final_value, 0.0);
  EXPECT_FALSE(metrics.rise_10_90_s || metrics.settling_2pct_s || metrics.overshoot_fraction);
  EXPECT_FALSE(metricsOf(SampledResponse{1e-3, {0.0, 1.0}}).final_value.has_value());
  EXPECT_FALSE(metricsOf(SampledResponse{1e-3, {}}).final_value.has_value());
}

TEST(SecondOrderFit, FindsTheFunctionThatASampledCurveCameFrom) {
  test::Random random({20260804});
  for (int count = 0; count < test::sweep(6, 300); ++count) {
    const double omega = std::pow(10.0, random.between(0.5, 2.3)), zeta = random.between(0.05, 1.8);
    const double gain = random.between(-0.02, 0.02) + 0.001;
    const double seconds = 1.5 * *metricsOf(secondOrder(omega, zeta)).settling_2pct_s;
    const auto fit = fitSecondOrder(sampled(secondOrder(omega, zeta), gain, seconds, seconds / 1000.0, 0.1));
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(fit->omega_n_rad_per_s / omega, 1.0, 1e-6) << zeta;
    EXPECT_NEAR(fit->zeta / zeta, 1.0, 1e-6) << omega;
    EXPECT_NEAR(fit->gain / gain, 1.0, 1e-6);
    EXPECT_LT(fit->residual, 1e-8 * std::abs(gain));
  }
}

TEST(SecondOrderFit, NoPairOfNumbersNearItIsBetter) {
  const SampledResponse curve =
      sampled({{5.0}, {1.0, 33.0, 92.0, 60.0}}, 1.0, 8.0, 4e-3);  // third order: it does not fit exactly
  const SecondOrderFit fit = *fitSecondOrder(curve);
  EXPECT_GT(fit.residual, 1e-5);
  const auto residualOf = [&](const SecondOrderFit& tried) {
    double sum = 0.0;
    for (std::size_t index = 0; index < curve.value.size(); ++index) {
      const double y = tried.gain * secondOrderAt(tried.omega_n_rad_per_s, tried.zeta, curve.period_s * double(index));
      sum += (curve.value[index] - y) * (curve.value[index] - y);
    }
    return std::sqrt(sum / static_cast<double>(curve.value.size()));
  };
  EXPECT_NEAR(residualOf(fit), fit.residual, 1e-12);
  for (const double share : {0.999, 1.001}) {
    EXPECT_GT(residualOf({fit.omega_n_rad_per_s * share, fit.zeta, fit.gain}), fit.residual);
    EXPECT_GT(residualOf({fit.omega_n_rad_per_s, fit.zeta * share, fit.gain}), fit.residual);
    EXPECT_GT(residualOf({fit.omega_n_rad_per_s, fit.zeta, fit.gain * share}), fit.residual);
  }
}

TEST(SecondOrderFit, NothingIsFittedToNothing) {
  EXPECT_FALSE(fitSecondOrder(SampledResponse{1e-3, std::vector<double>(100, 2.0)}).has_value());
  EXPECT_FALSE(fitSecondOrder(SampledResponse{1e-3, {0.0, 1.0}}).has_value());
}

TEST(SecondOrder, ItsClosedFormIsTheExponentialOfTheStages) {
  for (const double zeta : {0.0, 0.3, 0.999999, 1.0, 1.000001, 1.5, 40.0}) {
    const UnitStep step(secondOrder(3.0, zeta));
    for (const double t_s : {0.0, 1e-6, 0.3, 2.0, 30.0, 500.0})
      EXPECT_NEAR(secondOrderAt(3.0, zeta, t_s), step.at(t_s), 2e-12) << zeta << ' ' << t_s;
  }
}

}  // namespace
}  // namespace underact::lab
