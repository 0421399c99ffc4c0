#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/gui/model/comparison.h"
#include "app/gui/model/session_data.h"
#include "app/gui/model/spectrum.h"
#include "app/gui/replay/thin_session.h"
#include "core/base/units.h"

namespace underact::gui::test {
namespace {

servo::TickRecord pushed(double force_N, double error_m = 0.0) {
  servo::TickRecord record;
  record.f_sent_T_W = Vec3(force_N, 0.0, 0.0);
  record.error_m = error_m;
  record.level = 1.0;
  return record;
}

device::RecordedRow recordedRow(float force_N, float error_m) {
  device::RecordedRow row;
  row.force_N = force_N;
  row.error_m = error_m;
  row.is_full = true;
  return row;
}

}  // namespace

TEST(ReplayParts, ASineStandsAtItsFrequencyWithItsAmplitude) {
  std::vector<float> values(20'000);
  for (std::size_t at = 0; at < values.size(); ++at)
    values[at] = static_cast<float>(5.0 + 0.3 * std::sin(2.0 * kPi * 62.5 * static_cast<double>(at) / 1000.0));
  const std::vector<SpectrumLine> spectrum = spectrumOf(values, 1000.0);
  ASSERT_EQ(spectrum.size(), 2049U);
  EXPECT_EQ(spectrum.back().frequency_hz, 500.0);
  const auto loudest = std::max_element(spectrum.begin(), spectrum.end(),
                                        [](const auto& a, const auto& b) { return a.amplitude < b.amplitude; });
  EXPECT_NEAR(loudest->frequency_hz, 62.5, 1e-9);
  EXPECT_NEAR(loudest->amplitude, 0.3, 1e-4);
  EXPECT_LT(spectrum.front().amplitude, 1e-3) << "what is constant is taken off";
  EXPECT_TRUE(spectrumOf(std::span(values).first(15), 1000.0).empty());
}

TEST(ReplayParts, ALongSessionIsHalvedAndKeepsItsSpikes) {
  SessionData data(1000);
  for (std::int64_t row = 0; row < 10'000; ++row) {
    servo::TickRecord record = pushed(row == 7777 ? 0.8 : 0.1);
    record.lateness_ns = 5000;
    data.add(row, 1000.0, record);
  }
  EXPECT_LE(data.rows().size(), 1000U);
  EXPECT_EQ(data.ticksPerRow(), 16);
  EXPECT_EQ(data.lateness().count(), 10'000);
  EXPECT_EQ(std::count_if(data.rows().begin(), data.rows().end(),
                          [](const SessionRow& row) { return row.plot.sent_N > 0.5F; }),
            1);
  for (std::size_t row = 1; row < data.rows().size(); ++row)
    ASSERT_LT(data.rows()[row - 1].plot.time_s, data.rows()[row].plot.time_s);
  std::vector<PlotPoint> points(4 * 102);
  const std::size_t used = thinSession(
      data.rows(), [](const SessionRow& row) { return row.plot.sent_N; }, 100, 1e9F, points);
  EXPECT_GT(used, 100U - 1U);
  EXPECT_EQ(std::count_if(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(used),
                          [](const PlotPoint& point) { return point.y > 0.5F; }),
            1);
}

TEST(ReplayParts, ThePathKeepsItsShapeAndItsGreatestForceInFewPoints) {
  std::vector<SessionRow> rows(100'000);
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const double turn_rad = 2.0 * kPi * static_cast<double>(index) / static_cast<double>(rows.size());
    rows[index].p_mm = {static_cast<float>(40.0 * std::cos(turn_rad)), static_cast<float>(40.0 * std::sin(turn_rad)),
                        0};
    rows[index].plot.sent_N = index == 54'321 ? 0.7F : 0.1F;
  }
  const std::vector<PathPoint> path = pathOf(rows, 300);
  EXPECT_LE(path.size(), 300U);
  EXPECT_GT(path.size(), 100U);
  double greatest_N = 0.0, longest_mm = 0.0;
  for (std::size_t index = 1; index < path.size(); ++index) {
    greatest_N = std::max(greatest_N, path[index].force_N);
    longest_mm = std::max(longest_mm, (path[index].p_mm - path[index - 1].p_mm).norm());
  }
  EXPECT_NEAR(greatest_N, 0.7, 1e-6);
  EXPECT_LT(longest_mm, 2.5);
}

TEST(ReplayParts, OnlyTicksThatPushedFullyBothTimesAreCompared) {
  Comparison comparison;
  EXPECT_TRUE(std::isnan(comparison.now().meanForce_N()));
  comparison.add(recordedRow(0.2F, 0.003F), pushed(0.1, 0.001));
  comparison.add(recordedRow(0.4F, 0.004F), pushed(0.5, 0.001));
  device::RecordedRow ramp = recordedRow(0.9F, 0.1F);
  ramp.is_full = false;
  comparison.add(ramp, pushed(0.9, 0.1));
  servo::TickRecord starting = pushed(0.9, 0.1);
  starting.level = 0.5;
  comparison.add(recordedRow(0.9F, 0.1F), starting);
  EXPECT_EQ(comparison.ticks(), 2);
  EXPECT_NEAR(comparison.recorded().rmsError_m(), std::sqrt(12.5e-6), 1e-9);
  EXPECT_NEAR(comparison.now().rmsError_m(), 0.001, 1e-12);
  EXPECT_NEAR(comparison.recorded().peakForce_N(), 0.4, 1e-6);
  EXPECT_NEAR(comparison.now().peakForce_N(), 0.5, 1e-12);
  EXPECT_NEAR(comparison.recorded().meanForce_N(), 0.3, 1e-6);
  EXPECT_NEAR(comparison.now().meanForce_N(), 0.3, 1e-12);
}

}  // namespace underact::gui::test
