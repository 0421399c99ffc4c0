#include "core/lab/step_metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/json/json.h"
#include "core/json/text.h"
#include "core/lab/unit_step.h"
#include "tests/support/property.h"

namespace underact::lab {
namespace {

const json::Value& golden() {
  static const json::Value kGolden = [] {
    const std::string path = UNDERACT_TEST_DATA "/golden/step_response.json";
    return json::parse(json::readTextFile(path, "golden vectors").value(), path).value();
  }();
  return kGolden;
}

double numberAt(const json::Value& object, const char* key) {
  return object.find(key)->number;
}

void expectNear(const std::optional<double>& found, const json::Value* wanted, const std::string& what) {
  ASSERT_NE(wanted, nullptr) << what;
  if (wanted->kind == json::JsonKind::Null) {
    EXPECT_FALSE(found.has_value()) << what;
    return;
  }
  ASSERT_TRUE(found.has_value()) << what;
  EXPECT_NEAR(*found, wanted->number, 1e-12 * std::abs(wanted->number)) << what;
}

TEST(StepMetrics, SecondOrderOfEveryDampingAgreesWithFiftyDigits) {
  for (const json::Value& one : golden().find("second_order")->items) {
    const double wn = numberAt(one, "wn"), zeta = numberAt(one, "zeta");
    const std::string what = "wn " + std::to_string(wn) + " zeta " + std::to_string(zeta);
    const StepMetrics metrics = metricsOf(secondOrder(wn, zeta));
    EXPECT_EQ(metrics.final_value, 1.0) << what;
    expectNear(metrics.rise_10_90_s, one.find("rise_10_90"), what + " rise");
    expectNear(metrics.settling_2pct_s, one.find("settling_2pct"), what + " settling");
    expectNear(metrics.peak_time_s, one.find("peak_time"), what + " peak");
    EXPECT_NEAR(*metrics.overshoot_fraction, numberAt(one, "overshoot_fraction"), 1e-14) << what;
  }
}

TEST(StepMetrics, AnUndampedResponseNeverSettlesAndSwingsAboutItsFinalValue) {
  const json::Value& one = golden().find("undamped")->items.at(0);
  const StepMetrics metrics = metricsOf(secondOrder(numberAt(one, "wn"), 0.0));
  EXPECT_EQ(metrics.final_value, 1.0);
  expectNear(metrics.rise_10_90_s, one.find("rise_10_90"), "rise");
  expectNear(metrics.peak_time_s, one.find("peak_time"), "peak");
  EXPECT_NEAR(*metrics.overshoot_fraction, 1.0, 1e-14);
  EXPECT_FALSE(metrics.settling_2pct_s.has_value());
}

TEST(StepMetrics, FirstOrderAgreesWithItsClosedForm) {
  for (const json::Value& one : golden().find("first_order")->items) {
    const double a = numberAt(one, "a"), final_value = numberAt(one, "final_value");
    const StepMetrics metrics = metricsOf(TransferFunction{{final_value * a}, {1.0, a}});
    EXPECT_NEAR(*metrics.final_value, final_value, 1e-15 * final_value);
    expectNear(metrics.rise_10_90_s, one.find("rise_10_90"), "rise");
    expectNear(metrics.settling_2pct_s, one.find("settling_2pct"), "settling");
    EXPECT_FALSE(metrics.peak_time_s.has_value());
    EXPECT_EQ(metrics.overshoot_fraction, 0.0);
  }
}

TEST(StepMetrics, GivesNoNumbersWhereTheResponseGrowsOrDrifts) {
  for (const std::vector<double>& den : {std::vector<double>{1, -1}, {1, 0}, {1, 1, 0}, {1, 0, 0}, {1, 0, 2, 0, 1}}) {
    const StepMetrics metrics = metricsOf(TransferFunction{{1.0}, den});
    EXPECT_FALSE(metrics.final_value || metrics.rise_10_90_s || metrics.settling_2pct_s || metrics.peak_time_s ||
                 metrics.overshoot_fraction);
  }
  const StepMetrics washout = metricsOf(TransferFunction{{1.0, 0.0}, {1.0, 1.0}});  // s / (s + 1) ends at 0
  EXPECT_EQ(washout.final_value, 0.0);
  EXPECT_FALSE(washout.rise_10_90_s || washout.settling_2pct_s || washout.overshoot_fraction);
}

TEST(StepMetrics, WhatGoesThroughAtOnceCounts) {
  const StepMetrics above = metricsOf(TransferFunction{{2.0, 1.0}, {1.0, 1.0}});  // 1 + e^-t
  EXPECT_EQ(above.rise_10_90_s, 0.0);
  EXPECT_EQ(above.peak_time_s, 0.0);
  EXPECT_NEAR(*above.overshoot_fraction, 1.0, 1e-15);
  EXPECT_NEAR(*above.settling_2pct_s, std::log(50.0), 1e-12);
  const StepMetrics near = metricsOf(TransferFunction{{0.99, 1.0}, {1.0, 1.0}});  // 1 - 0.01 e^-t
  EXPECT_EQ(near.settling_2pct_s, 0.0);
  const StepMetrics half = metricsOf(TransferFunction{{0.5, 1.0}, {1.0, 1.0}});  // 1 - 0.5 e^-t
  EXPECT_NEAR(*half.rise_10_90_s, std::log(5.0), 1e-12);
}

TEST(StepMetrics, AResponseThatFirstGoesTheWrongWayIsMeasuredFromWhenItComes) {
  // (1 - s) / (s + 1)^2 = 1 - e^-t (1 + 2 t) ... at 0 it falls; oracle: bisection on the closed form.
  const auto y = [](double t_s) { return 1.0 - std::exp(-t_s) * (1.0 + 2.0 * t_s); };
  const auto last = [&](double level) {
    double low_s = 1.0, high_s = 30.0;  // y rises from t = 0.5 on
    for (int n = 0; n < 100; ++n) (y(0.5 * (low_s + high_s)) < level ? low_s : high_s) = 0.5 * (low_s + high_s);
    return low_s;
  };
  const StepMetrics metrics = metricsOf(TransferFunction{{-1.0, 1.0}, {1.0, 2.0, 1.0}});
  EXPECT_NEAR(*metrics.rise_10_90_s, last(0.9) - last(0.1), 1e-12);
  EXPECT_NEAR(*metrics.settling_2pct_s, last(0.98), 1e-12);
  EXPECT_EQ(metrics.overshoot_fraction, 0.0);
}

TEST(StepMetrics, ThereIsHardlyAnyDampingThatIsTooSmall) {
  for (const double zeta : {1e-3, 1e-5, 1e-7}) {
    const StepMetrics metrics = metricsOf(secondOrder(1.0, zeta));
    ASSERT_TRUE(metrics.settling_2pct_s.has_value()) << zeta;
    EXPECT_NEAR(*metrics.settling_2pct_s * zeta, std::log(50.0), 4.0 * zeta) << zeta;  // within a turn of the envelope
    EXPECT_NEAR(*metrics.overshoot_fraction, std::exp(-kPi * zeta / std::sqrt(1.0 - zeta * zeta)), 1e-9) << zeta;
  }
}

TEST(StepMetrics, EightEqualPolesAreThoseOfTheGammaDistribution) {
  // (s + 1)^8: 1 - e^-t sum t^k / k!, without cancellation; oracle: bisection on it.
  const auto y = [](double t_s) {
    double sum = 1.0, term = 1.0;
    for (int k = 1; k < 8; ++k) sum += term *= t_s / k;
    return 1.0 - std::exp(-t_s) * sum;
  };
  const auto at = [&](double level) {
    double low_s = 0.0, high_s = 60.0;
    for (int n = 0; n < 100; ++n) (y(0.5 * (low_s + high_s)) < level ? low_s : high_s) = 0.5 * (low_s + high_s);
    return low_s;
  };
  const StepMetrics metrics = metricsOf(TransferFunction{{1.0}, {1, 8, 28, 56, 70, 56, 28, 8, 1}});
  EXPECT_NEAR(*metrics.rise_10_90_s, at(0.9) - at(0.1), 1e-9);
  EXPECT_NEAR(*metrics.settling_2pct_s, at(0.98), 1e-9);
  EXPECT_EQ(metrics.overshoot_fraction, 0.0);
}

/// A stable function of distinct poles and any numerator, from its partial fractions.
struct Drawn {
  TransferFunction transfer;
  std::vector<std::complex<double>> poles;
};

std::vector<double> times(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> product(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  }
  return product;
}

Drawn draw(test::Random& random) {
  Drawn drawn;
  std::vector<double> den{1.0};
  const std::size_t degree = 1 + random.below(6);
  while (drawn.poles.size() < degree) {
    const double re = -random.between(0.1, 3.0), im = random.between(0.5, 5.0);
    if (drawn.poles.size() + 2 <= degree && random.below(2) == 0) {
      den = times(den, {1.0, -2.0 * re, re * re + im * im});
      drawn.poles.emplace_back(re, im);
      drawn.poles.emplace_back(re, -im);
    } else {
      den = times(den, {1.0, -re});
      drawn.poles.emplace_back(re, 0.0);
    }
  }
  std::vector<double> num;
  for (std::size_t power = random.below(degree + 1) + 1; power > 0; --power) num.push_back(random.between(-2.0, 2.0));
  num.back() += num.back() < 0.0 ? -0.5 : 0.5;
  drawn.transfer = makeTransferFunction(num, den).value();
  return drawn;
}

/// y(t) by partial fractions: shares no line with UnitStep.
double partialFractions(const Drawn& drawn, double t_s) {
  std::complex<double> y = gainAtRest(drawn.transfer);
  for (const std::complex<double>& pole : drawn.poles) {
    std::complex<double> rest = drawn.transfer.den.front() * pole;
    for (const std::complex<double>& other : drawn.poles) {
      if (other != pole) rest *= pole - other;
    }
    y += valueAt(drawn.transfer.num, pole) / rest * std::exp(pole * t_s);
  }
  return y.real();
}

TEST(StepMetrics, DenseSamplesOfThePartialFractionsFindTheSame) {
  test::Random random({20260801});
  int compared = 0;
  for (int drawn_count = 0; drawn_count < test::sweep(60, 5000); ++drawn_count) {
    const Drawn drawn = draw(random);
    double nearest = kInfinity;
    for (std::size_t i = 0; i < drawn.poles.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, std::abs(drawn.poles[i] - drawn.poles[j]));
    }
    if (nearest < 0.1) continue;  // the oracle cancels
    const StepMetrics metrics = metricsOf(drawn.transfer);
    const double final_value = gainAtRest(drawn.transfer);
    ASSERT_EQ(metrics.final_value, final_value);
    constexpr double kStep_s = 1e-3, kLong_s = 120.0;
    const auto z = [&](double t_s) { return partialFractions(drawn, t_s) / final_value; };
    double low_s = -1.0, high_s = -1.0, settled_s = 0.0, max = -kInfinity, peak_s = 0.0;
    double nearest_band = kInfinity;
    for (double t_s = 0.0; t_s < kLong_s; t_s += t_s < 20.0 ? kStep_s : 20.0 * kStep_s) {
      const double now = z(t_s);
      if (low_s < 0.0 && now >= 0.1) low_s = t_s;
      if (high_s < 0.0 && now >= 0.9) high_s = t_s;
      if (std::abs(now - 1.0) >= 0.02) settled_s = t_s;
      if (now > max) max = now, peak_s = t_s;
      nearest_band = std::min(nearest_band, t_s > settled_s + 0.1 ? std::abs(std::abs(now - 1.0) - 0.02) : kInfinity);
    }
    ASSERT_TRUE(metrics.rise_10_90_s && metrics.settling_2pct_s && metrics.overshoot_fraction);
    EXPECT_NEAR(*metrics.rise_10_90_s, high_s - low_s, (high_s < 20.0 ? 2.0 : 22.0) * kStep_s) << drawn_count;
    if (nearest_band > 1e-4) {
      EXPECT_NEAR(*metrics.settling_2pct_s, settled_s, 25.0 * kStep_s) << drawn_count;
    }
    EXPECT_NEAR(*metrics.overshoot_fraction, std::max(0.0, max - 1.0), 1e-4 * std::max(1.0, max)) << drawn_count;
    if (max > 1.001) {
      EXPECT_NEAR(z(*metrics.peak_time_s), z(peak_s), 1e-4 * max) << drawn_count;
    }
    // And to the last digits: what was found is where it says.
    EXPECT_NEAR(std::abs(z(*metrics.settling_2pct_s) - 1.0), *metrics.settling_2pct_s > 0.0 ? 0.02 : 0.0,
                *metrics.settling_2pct_s > 0.0 ? 1e-9 : 0.02)
        << drawn_count;
    ++compared;
  }
  EXPECT_GT(compared, 30);
}

TEST(StepMetrics, AFasterOrLargerSystemIsTheSameInItsOwnMeasure) {
  test::Random random({20260802});
  for (int count = 0; count < test::sweep(40, 2000); ++count) {
    const Drawn drawn = draw(random);
    const double faster = std::pow(10.0, random.between(-6.0, 6.0)),
                 larger = -std::pow(10.0, random.between(-3.0, 3.0));
    TransferFunction scaled = drawn.transfer;
    for (std::size_t power = 0; power < scaled.num.size(); ++power)
      scaled.num[scaled.num.size() - 1 - power] *= larger / std::pow(faster, static_cast<double>(power));
    for (std::size_t power = 0; power < scaled.den.size(); ++power)
      scaled.den[scaled.den.size() - 1 - power] /= std::pow(faster, static_cast<double>(power));
    const StepMetrics one = metricsOf(drawn.transfer), other = metricsOf(scaled);
    EXPECT_NEAR(*other.final_value / (larger * *one.final_value), 1.0, 1e-12);
    EXPECT_NEAR(*other.rise_10_90_s * faster, *one.rise_10_90_s, 1e-8 * (1.0 + *one.rise_10_90_s)) << count;
    EXPECT_NEAR(*other.overshoot_fraction, *one.overshoot_fraction, 1e-9 * (1.0 + *one.overshoot_fraction)) << count;
  }
}

}  // namespace
}  // namespace underact::lab
