#include "app/gui/plot/live_plot.h"

#include <gtest/gtest.h>

#include <QTest>
#include <cmath>

#include "app/gui/model/plot_history.h"
#include "app/gui/plot/plot_range.h"
#include "core/base/units.h"
#include "tests/gui/example.h"

namespace underact::gui {
namespace {

using test::count;

servo::TickRecord recordAt(std::int64_t tick, double error_m, double force_N) {
  servo::TickRecord record;
  record.tick = tick;
  record.time_ns = tick * 1'000'000;
  record.error_m = error_m;
  record.p_WT = Vec3(error_m, 0, 0);
  record.f_asked_T_W = record.f_sent_T_W = Vec3(-force_N, 0, 0);
  return record;
}

TEST(PlotHistory, ThinningKeepsASpikeOfOneTick) {
  for (const std::int64_t spike : {0, 1, 4999, 5000, 7777, 9999}) {
    PlotHistory history;
    for (std::int64_t tick = 0; tick < 10'000; ++tick) history.add(recordAt(tick, tick == spike ? 0.009 : 0.001, 0.1));
    std::vector<PlotPoint> points(2 * (300 + 2));
    const std::size_t used = thinByTime(history, &PlotRow::error_mm, 300, points);
    EXPECT_LE(used, points.size());
    const auto found = std::find_if(points.begin(), points.end(), [](const PlotPoint& p) { return p.y == 9.0F; });
    ASSERT_NE(found, points.end()) << spike;
    EXPECT_NEAR(static_cast<double>(found->x), 1e-3 * static_cast<double>(spike - 9999), 1e-5);
    EXPECT_TRUE(std::is_sorted(points.begin(), points.end(), [](auto a, auto b) { return a.x < b.x; }));
  }
}

TEST(PlotHistory, ThinningShowsADipToo) {
  PlotHistory history;
  for (std::int64_t tick = 0; tick < 10'000; ++tick) history.add(recordAt(tick, tick == 1234 ? 0.0 : 0.001, 0.1));
  std::vector<PlotPoint> points(2 * (300 + 2));
  thinByTime(history, &PlotRow::error_mm, 300, points);
  EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](const PlotPoint& p) { return p.y == 0.0F; }));
}

TEST(PlotHistory, ColumnsKeepTheirTicksAsTimeGoesOn) {
  PlotHistory history;
  std::vector<PlotPoint> before(2 * (100 + 2)), after(2 * (100 + 2));
  for (std::int64_t tick = 0; tick < 9'000; ++tick)
    history.add(recordAt(tick, 1e-3 * std::sin(0.37 * static_cast<double>(tick)), 0));
  thinByTime(history, &PlotRow::error_mm, 100, before);
  for (std::int64_t tick = 9'000; tick < 9'017; ++tick) history.add(recordAt(tick, 0, 0));
  thinByTime(history, &PlotRow::error_mm, 100, after);
  for (std::size_t point = 0; point < 150; ++point) {
    EXPECT_EQ(after[point].y, before[point].y);
    EXPECT_NEAR(static_cast<double>(after[point].x), static_cast<double>(before[point].x) - 0.017, 1e-5);
  }
}

TEST(PlotHistory, HoldsTenSecondsAtTenThousandTicks) {
  PlotHistory history;
  for (std::int64_t tick = 0; tick < 150'000; ++tick) {
    servo::TickRecord record = recordAt(tick, 0.001, 0);
    record.time_ns = tick * 100'000;
    history.add(record);
  }
  EXPECT_EQ(history.size(), PlotHistory::kCapacity);
  EXPECT_NEAR(history.newest_s() - history.row(0).time_s, 10.0, 0.001);
  history.add(recordAt(1, 0, 0));  // the clock went back: another device
  EXPECT_EQ(history.size(), 1U);
}

TEST(PlotHistory, TakesTheRoomThatItsRateNeedsAndNoMore) {
  PlotHistory history;
  EXPECT_EQ(history.room(), 0U);
  for (std::int64_t tick = 0; tick < 40'000; ++tick) {
    history.add(recordAt(tick, 1e-3 * static_cast<double>(tick), 0));
    ASSERT_GE(history.size(), static_cast<std::size_t>(std::min<std::int64_t>(tick + 1, 10'000)));
    for (const std::size_t back : {std::size_t{0}, history.size() / 2, history.size() - 1}) {  // also where it grew
      const auto then = static_cast<float>(tick - static_cast<std::int64_t>(back));
      ASSERT_NEAR(history.row(history.size() - 1 - back).error_mm, then, 0.01F);
    }
  }
  EXPECT_LE(history.room(), 16'384U);  // 1.2 MB
}

TEST(PlotHistory, PathKeepsTheExtremesAndLeavesOutWhatIsNoNumber) {
  PlotHistory history;
  for (std::int64_t tick = 0; tick < 10'000; ++tick) {
    servo::TickRecord record = recordAt(tick, 0.001, 0.1);
    if (tick == 3333) record.p_WT.x() = 0.02;
    if (tick == 4444) record.f_sent_T_W.x() = 0.8;
    if (tick % 7 == 0) record.p_WP = Vec3::Constant(kNotANumber);
    history.add(record);
  }
  std::vector<PlotPoint> points(4 * (250 + 2));
  thinPath(history, 0, 250, points);
  EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](const PlotPoint& p) { return p.x == 20.0F; }));
  EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](const PlotPoint& p) { return p.y == 0.8F; }));
  EXPECT_TRUE(std::all_of(points.begin(), points.end(), [](const PlotPoint& p) { return std::isfinite(p.x); }));
}

servo::TickRecord angleAt(std::int64_t tick, double angle_rad) {
  servo::TickRecord record = recordAt(tick, 0.001, 0.1);
  record.angles = {angle_rad, angle_rad, angle_rad};
  return record;
}

bool drawsALongStep(const std::vector<PlotPoint>& points, std::size_t used) {
  for (std::size_t point = 1; point < used; ++point) {
    if (std::abs(points[point].y - points[point - 1].y) > 180.0F) return true;  // false beside what is no number
  }
  return false;
}

TEST(PlotHistory, AnAngleThatGoesRoundIsBrokenAtTheWrapAndNowhereElse) {
  PlotHistory round, still, trembling;
  for (std::int64_t tick = 0; tick < 10'000; ++tick) {
    const double travel_rad = 0.002 * static_cast<double>(tick);  // three times round
    round.add(angleAt(tick, std::remainder(travel_rad, 2.0 * kPi)));
    still.add(angleAt(tick, 3.0 * std::sin(travel_rad)));
    trembling.add(angleAt(tick, tick % 2 == 0 ? 3.14 : -3.14));
  }
  const auto gapsOf = [](const PlotHistory& history) {
    std::vector<PlotPoint> points(4 * (300 + 2));
    const std::size_t used = thinAngle(history, &PlotRow::theta_deg, 300, points);
    EXPECT_FALSE(drawsALongStep(points, used));
    EXPECT_TRUE(std::isfinite(points.back().y));
    EXPECT_NEAR(static_cast<double>(points.back().x), 0.0, 0.04);  // none was lost for want of room
    return std::count_if(points.begin(), points.end(), [](const PlotPoint& p) { return std::isnan(p.y); });
  };
  EXPECT_EQ(gapsOf(round), 3);
  EXPECT_EQ(gapsOf(still), 0);
  EXPECT_GT(gapsOf(trembling), 0);
}

TEST(PlotHistory, WhatWasRecordedStandsBesideItWhileSomethingIsReplayed) {
  PlotHistory history;
  for (std::int64_t tick = 0; tick < 200; ++tick) {
    const bool is_replayed = tick >= 100;
    history.add(recordAt(tick, 0.001, 0.1), is_replayed ? RecordedBeside{2.5F, 0.3F} : RecordedBeside{});
  }
  std::vector<PlotPoint> points(2 * (300 + 2));
  const std::size_t used = thinByTime(history, &PlotRow::recorded_N, 300, points);
  ASSERT_GT(used, 0U);
  EXPECT_EQ(points[0].y, 0.3F);
  EXPECT_NEAR(static_cast<double>(points[0].x), -0.099, 1e-6) << "nothing before it was replayed";
  EXPECT_EQ(history.row(150).recorded_error_mm, 2.5F);
  EXPECT_TRUE(std::isnan(history.row(50).recorded_error_mm));
}

TEST(PlotHistory, AnAngleThatIsNotThereIsLeftOut) {
  PlotHistory history;
  for (std::int64_t tick = 0; tick < 100; ++tick) history.add(recordAt(tick, 0.001, 0.1));
  std::vector<PlotPoint> points(4 * (300 + 2));
  EXPECT_EQ(thinAngle(history, &PlotRow::alpha_deg, 300, points), 0U);
}

TEST(PlotHistory, WhatIsBelowZeroIsFilledStrokeByStroke) {
  const std::vector<PlotPoint> line{{-4, 2}, {-3, -1}, {-2, 0}, {-1, -3}};
  std::vector<PlotPoint> points(3 * line.size());
  ASSERT_EQ(strokesBelowZero(line, points), 6U);
  EXPECT_EQ(points[0].x, -3.0F);
  EXPECT_EQ(points[0].y, 0.0F);
  EXPECT_EQ(points[1].y, -1.0F);
  EXPECT_TRUE(std::isnan(points[2].y));
  EXPECT_EQ(points[3].x, -1.0F);
  EXPECT_EQ(points[4].y, -3.0F);
  EXPECT_EQ(strokesBelowZero(std::vector<PlotPoint>{{-1, 1}}, points), 0U);
}

TEST(PlotRange, GrowsAtOnceAndShrinksLater) {
  PlotRange range(1.0);
  EXPECT_EQ(range.update(0.2, 0.0), 1.0);
  EXPECT_EQ(range.update(3.0, 0.1), 5.0);
  EXPECT_EQ(range.update(0.9, 0.2), 5.0);
  EXPECT_EQ(range.update(4.0, 1.9), 5.0);  // used again: the wait starts anew
  EXPECT_EQ(range.update(0.9, 2.3), 5.0);
  EXPECT_EQ(range.update(0.9, 4.2), 5.0);  // 1.9 s are too few
  EXPECT_EQ(range.update(0.9, 4.4), 1.0);
  EXPECT_EQ(range.update(std::nan(""), 4.5), 1.0);
  EXPECT_EQ(ticks(-10.0, 0.0, 6).size(), 6U);
  EXPECT_EQ(decimalsOf(0.5), 1);
  EXPECT_EQ(decimalsOf(20.0), 0);
  EXPECT_EQ(multiples(-180.0, 180.0, 45.0, 8), (std::vector<double>{-180, -135, -90, -45, 0, 45, 90, 135, 180}));
  EXPECT_EQ(multiples(-180.0, 180.0, 45.0, 3), (std::vector<double>{-180, 0, 180}));
}

TEST(LivePlot, TheAnglesHaveAChartOnlyWhenTheyAreAskedFor) {
  LivePlot plot;
  plot.resize(1190, 180);
  plot.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&plot));
  for (std::int64_t tick = 0; tick < 10'000; ++tick) {
    servo::TickRecord record = recordAt(tick, 0.001, 0.3);
    record.angles = {0.5, 1.5, 1.0};
    plot.add(record);
  }
  plot.showEnergy(false);  // of a blue that is near to it
  const auto isSkyBlue = [](const QColor& c) { return c.saturation() > 100 && c.hue() > 195 && c.hue() < 208; };
  const auto isPurple = [](const QColor& c) { return c.saturation() > 60 && c.hue() > 315 && c.hue() < 340; };
  const QPointF middle(595, 90);
  for (const bool shown : {false, true, false}) {
    plot.showAngles(shown);
    const QImage picture = plot.picture();
    EXPECT_EQ(count(picture, middle, 600.0, isSkyBlue) > 100, shown);
    EXPECT_EQ(count(picture, middle, 600.0, isPurple) > 100, shown);
  }
}

TEST(LivePlot, EnergyBelowZeroIsMarkedAndThePassiveForceIsBesideIt) {
  LivePlot plot;
  plot.resize(1190, 180);
  plot.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&plot));
  const auto isVermillion = [](const QColor& c) { return c.saturation() > 200 && c.hue() > 20 && c.hue() < 32; };
  const auto isBlue = [](const QColor& c) { return c.saturation() > 200 && c.hue() > 198 && c.hue() < 206; };
  struct Seen {
    int active, blue_of_force;
  };
  const auto see = [&](double energy_J, double passive_N) {
    plot.clear();
    for (std::int64_t tick = 0; tick < 10'000; ++tick) {
      servo::TickRecord record = recordAt(tick, 0.0, 0.3);
      record.energy_J = energy_J * std::sin(0.002 * static_cast<double>(tick));
      record.passive_N = passive_N;
      plot.add(record);
    }
    const QImage picture = plot.picture();
    return Seen{count(picture, {735, 100}, 130.0, isVermillion), count(picture, {440, 60}, 140.0, isBlue)};
  };
  const Seen quiet = see(0.0, 0.0), active = see(0.004, 0.2);
  EXPECT_GT(active.active, quiet.active + 1000);  // filled, not only a line
  EXPECT_GT(active.blue_of_force, quiet.blue_of_force + 100);
  EXPECT_TRUE(plot.showsEnergy());
  plot.showEnergy(false);
}

TEST(LivePlot, WhereAllWouldBeTooNarrowThePathLeavesItsRoomAndSaysSo) {
  LivePlot plot;
  std::vector<bool> given;
  QObject::connect(&plot, &LivePlot::pathShown, [&given](bool shown) { given.push_back(shown); });
  const int line = plot.fontMetrics().lineSpacing();
  plot.resize(28 * line, 12 * line);  // three charts of nine lines, and no more
  plot.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&plot));
  plot.picture();
  EXPECT_TRUE(QTest::qWaitFor([&] { return given == std::vector<bool>{false}; }));
  plot.showEnergy(false);
  plot.picture();
  EXPECT_TRUE(QTest::qWaitFor([&] { return given == std::vector<bool>{false, true}; }));
  plot.showEnergy(true);
  plot.resize(60 * line, 12 * line);
  plot.picture();
  QTest::qWait(20);
  EXPECT_TRUE(given.back());
}

TEST(LivePlot, DrawsWhatWasAddedAndOnlyThen) {
  LivePlot plot;
  plot.resize(1190, 180);
  plot.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&plot));
  for (std::int64_t tick = 0; tick < 10'000; ++tick)
    plot.add(recordAt(tick, 0.0005 + 0.0004 * std::sin(0.001 * static_cast<double>(tick)), 0.3));
  plot.redraw();
  const auto isPlotGreen = [](const QColor& c) { return c.saturation() > 150 && c.hue() > 150 && c.hue() < 180; };
  EXPECT_GT(test::count(plot.picture(), {200, 90}, 90.0, isPlotGreen), 200);
  QTest::qWait(50);
  const qint64 before = plot.framesDrawn();
  for (int again = 0; again < 5; ++again) {
    plot.redraw();
    QTest::qWait(10);
  }
  EXPECT_EQ(plot.framesDrawn(), before);
  plot.add(recordAt(10'000, 0.001, 0.3));
  plot.redraw();
  EXPECT_TRUE(QTest::qWaitFor([&] { return plot.framesDrawn() > before; }));
  plot.setTheme(Theme::dark_theme());
  plot.setAxis(2);
  EXPECT_EQ(plot.axis(), 2);
  const QImage picture = plot.picture();
  EXPECT_EQ(picture.pixelColor(2, picture.height() - 2).name(), Theme::dark_theme().background.name());
}

TEST(LivePlot, LivesOnInAnotherWindowAndAtAnySize) {
  QWidget first, second;
  auto* plot = new LivePlot;
  for (QWidget* window : {&first, &second}) {
    plot->setParent(window);
    window->resize(600, 200);
    window->show();
    plot->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window));
    for (const QSize& size : {QSize(600, 200), QSize(30, 20), QSize(500, 150)}) {
      plot->resize(size);
      for (std::int64_t tick = 0; tick < 100; ++tick) plot->add(recordAt(tick, 0.001, 0.3));
      plot->redraw();
      EXPECT_FALSE(plot->picture().isNull());
    }
  }
}

}  // namespace
}  // namespace underact::gui
