#include "core/lab/step_metrics.h"

#include <gtest/gtest.h>

#include "core/json/json.h"
#include "core/json/text_file.h"

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
  if (wanted->kind == json::Kind::Null) {
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

}  // namespace
}  // namespace underact::lab
