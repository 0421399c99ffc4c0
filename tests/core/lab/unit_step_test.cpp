#include "core/lab/unit_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/json/json.h"
#include "core/json/text.h"
#include "core/lab/step_metrics.h"
#include "core/lab/thesis_steps.h"

namespace underact::lab {
namespace {

TEST(UnitStep, FirstOrderIsItsExponential) {
  const UnitStep step({{3.0}, {1.0, 2.0}});
  for (const double t_s : {0.0, 1e-9, 0.1, 1.0, 10.0, 1000.0})
    EXPECT_NEAR(step.at(t_s), -1.5 * std::expm1(-2.0 * t_s), 1e-15) << t_s;
}

TEST(UnitStep, IntegratorsAndGrowthGoOn) {
  EXPECT_NEAR(UnitStep({{1.0}, {1.0, 0.0}}).at(7.0), 7.0, 1e-13);
  EXPECT_NEAR(UnitStep({{1.0}, {1.0, 0.0, 0.0}}).at(7.0), 24.5, 1e-12);
  EXPECT_NEAR(UnitStep({{1.0}, {1.0, 1.0, 0.0}}).at(7.0), 6.0 + std::exp(-7.0), 1e-13);
  EXPECT_NEAR(UnitStep({{1.0}, {1.0, -1.0}}).at(7.0) / std::expm1(7.0), 1.0, 1e-13);
  EXPECT_NEAR(UnitStep({{1.0}, {1.0, 0.0, 1.0}}).at(1000.0), 1.0 - std::cos(1000.0), 1e-11);
}

TEST(UnitStep, EqualPolesAndPolesFarApartAreNoSpecialCase) {
  const UnitStep triple({{1.0}, {1.0, 3.0, 3.0, 1.0}});
  const UnitStep stiff({{1e6}, {1.0, 1e6 + 1.0, 1e6}});
  for (const double t_s : {0.01, 0.5, 3.0, 20.0}) {
    EXPECT_NEAR(triple.at(t_s), 1.0 - std::exp(-t_s) * (1.0 + t_s + 0.5 * t_s * t_s), 1e-14) << t_s;
    EXPECT_NEAR(stiff.at(t_s), 1.0 - (1e6 * std::exp(-t_s) - std::exp(-1e6 * t_s)) / (1e6 - 1.0), 1e-13) << t_s;
  }
}

TEST(UnitStep, ThesisFigureB3IsTheOneOfFiftyDigits) {
  const std::string path = UNDERACT_TEST_DATA "/golden/step_response.json";
  const json::Value root = json::parse(json::readTextFile(path, "golden vectors").value(), path).value();
  const json::Value& b10 = *root.find("B10");
  const ThesisStep& figure = thesisSteps()[2];
  const UnitStep full(figure.responses[0].transfer), left_out(figure.responses[1].transfer),
      matched(figure.responses[2].transfer);
  for (const json::Value& sample : b10.find("samples")->items) {
    const double t_s = sample.find("t")->number;
    EXPECT_NEAR(full.at(t_s), sample.find("y_full")->number, 1e-15) << t_s;
    EXPECT_NEAR(left_out.at(t_s), sample.find("y_B12_corrected")->number, 1e-15) << t_s;
    EXPECT_NEAR(matched.at(t_s), sample.find("y_dc_matched")->number, 1e-15) << t_s;
  }
  // The thesis's claim, at most 3e-3 apart, and where the worst of it is.
  const json::Value& worst = *b10.find("step_error_dc_matched");
  const double at_s = worst.find("at_t")->number;
  EXPECT_NEAR(matched.at(at_s) - full.at(at_s), worst.find("max")->number, 1e-15);
}

TEST(ThesisSteps, EndWhereTheThesisSaysTheyDo) {
  const auto steps = thesisSteps();
  ASSERT_EQ(steps.size(), 5U);
  EXPECT_EQ(gainAtRest(steps[0].responses[0].transfer), 1.0);
  EXPECT_EQ(gainAtRest(steps[0].responses[1].transfer), 0.5);  // 1 / a
  EXPECT_EQ(gainAtRest(steps[0].responses[2].transfer), 3.0);
  EXPECT_NEAR(*metricsOf(steps[4].responses[0].transfer).overshoot_fraction, 0.38, 1e-4);
  for (const ThesisStep& step : steps) {
    for (const ThesisStep::Response& one : step.responses) {
      EXPECT_TRUE(makeTransferFunction(one.transfer.num, one.transfer.den)) << step.key << ' ' << one.name;
    }
  }
}

}  // namespace
}  // namespace underact::lab
