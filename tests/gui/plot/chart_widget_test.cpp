#include "app/gui/plot/chart_widget.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "app/gui/model/plot_columns.h"
#include "app/gui/plot/chart.h"
#include "app/gui/plot/column_button.h"
#include "app/gui/plot/live_plot.h"

namespace underact::gui {
namespace {

servo::TickRecord tickAt(std::int64_t tick, double error_m) {
  servo::TickRecord record;
  record.tick = tick;
  record.time_ns = tick * 1'000'000;
  record.error_m = error_m;
  record.v_WT = Vec3(0.0, 0.02, 0.0);
  record.heat = Vec3(0.1, 0.2, 0.3);
  record.input = 5;
  return record;
}

/// A window of plots with ten seconds, in which the error is 1 mm but for one tick.
struct Plots {
  explicit Plots(std::int64_t spike = 5000) {
    plot.resize(1200, 240);
    plot.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&plot));
    for (std::int64_t tick = 0; tick < 10'000; ++tick) plot.add(tickAt(tick, tick == spike ? 0.009 : 0.001));
    plot.picture();
  }
  /// In the middle of the chart of the error, which is the first.
  QPointF middle() { return {150.0, 120.0}; }
  LivePlot plot;
};

std::size_t lineCount(const QString& text) {
  return static_cast<std::size_t>(text.count('\n'));
}

TEST(ChartWidget, ThePointerReadsTheValuesThere) {
  Plots plots;
  EXPECT_TRUE(plots.plot.readingsAt({2.0, 2.0}).isEmpty()) << "beside the axes";
  EXPECT_EQ(plots.plot.readingsAt(plots.middle()).section('\n', 0, 0), "Error [mm]: 1");
  QTest::mouseMove(&plots.plot, plots.middle().toPoint());
  QTest::qWait(30);
  EXPECT_FALSE(plots.plot.grab().isNull());
}

TEST(ChartWidget, WhatIsEnlargedIsAsFineAsTheWholeAndAllComesBack) {
  Plots plots;
  const std::size_t before = lineCount(plots.plot.dataText('\t'));
  EXPECT_FALSE(plots.plot.showsPart());
  plots.plot.enlarge(plots.middle(), 20.0, 1.0);
  plots.plot.picture();
  EXPECT_TRUE(plots.plot.showsPart());
  const QString part = plots.plot.dataText('\t');
  // Half a second of ten in each chart against time, but tick by tick: as many points as before within it, not a
  // twentieth of them.
  EXPECT_GT(lineCount(part), before / 4);
  const QStringList rows = part.split('\n');
  double min_s = 0.0, greatest_s = -10.0;
  for (const QString& row : rows.mid(1)) {
    if (row.isEmpty()) break;
    min_s = std::min(min_s, row.section('\t', 0, 0).toDouble());
    greatest_s = std::max(greatest_s, row.section('\t', 0, 0).toDouble());
  }
  EXPECT_NEAR(greatest_s - min_s, 0.5, 0.05);
  plots.plot.showAll();
  plots.plot.picture();
  EXPECT_FALSE(plots.plot.showsPart());
  EXPECT_NEAR(static_cast<double>(lineCount(plots.plot.dataText('\t'))), static_cast<double>(before), 4.0);
}

TEST(ChartWidget, WheelMouseAndKeysDoIt) {
  Plots plots;
  LivePlot& plot = plots.plot;
  const QPointF at = plots.middle();
  const auto wheel = [&](int turn, Qt::KeyboardModifiers modifiers) {
    QWheelEvent event(at, plot.mapToGlobal(at), {}, {0, turn}, Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&plot, &event);
  };
  wheel(360, {});
  EXPECT_TRUE(plot.showsPart());
  const QString before = plot.dataText('\t');
  QTest::mousePress(&plot, Qt::LeftButton, {}, at.toPoint());
  QTest::mouseMove(&plot, (at + QPointF(40, 0)).toPoint());
  QTest::mouseRelease(&plot, Qt::LeftButton, {}, (at + QPointF(40, 0)).toPoint());
  plot.picture();
  EXPECT_NE(plot.dataText('\t'), before) << "moved";
  QTest::mouseDClick(&plot, Qt::LeftButton, {}, at.toPoint());
  EXPECT_FALSE(plot.showsPart());
  QTest::mousePress(&plot, Qt::LeftButton, Qt::ShiftModifier, (at - QPointF(30, 30)).toPoint());
  QTest::mouseMove(&plot, (at + QPointF(30, 30)).toPoint());
  QTest::mouseRelease(&plot, Qt::LeftButton, Qt::ShiftModifier, (at + QPointF(30, 30)).toPoint());
  EXPECT_TRUE(plot.showsPart()) << "a rectangle";
  QTest::keyClick(&plot, Qt::Key_Home);
  EXPECT_FALSE(plot.showsPart());
  QTest::keyClick(&plot, Qt::Key_Plus);
  EXPECT_TRUE(plot.showsPart());
  QTest::keyClick(&plot, Qt::Key_Minus);
  EXPECT_FALSE(plot.showsPart()) << "as much as there is";
}

TEST(ChartWidget, PictureAndDataAreCopied) {
  Plots plots;
  plots.plot.copyData();
  const QString text = QApplication::clipboard()->text();
  EXPECT_TRUE(text.startsWith("time [s]\tError [mm]\n")) << text.left(60).toStdString();
  EXPECT_TRUE(text.contains("\t9\n")) << "the spike of one tick";
  plots.plot.copyPicture();
  EXPECT_EQ(QApplication::clipboard()->image().size(), plots.plot.picture().size());
}

TEST(LivePlotHold, StandsStillWhileTicksGoOn) {
  Plots plots;
  plots.plot.hold(true);
  const QString before = plots.plot.dataText('\t');
  for (std::int64_t tick = 10'000; tick < 15'000; ++tick) plots.plot.add(tickAt(tick, 0.004));
  plots.plot.redraw();
  plots.plot.picture();
  EXPECT_EQ(plots.plot.dataText('\t'), before);
  plots.plot.hold(false);
  plots.plot.picture();
  EXPECT_NE(plots.plot.dataText('\t'), before);
}

TEST(PlotColumns, HaveTheNumbersOfATickInTheOrderOfTheirNames) {
  std::vector<float> values(plotColumns().size());
  fillColumns(tickAt(7, 0.002), arm::findPreset(arm::kDefaultArm)->geometry, values);
  const auto of = [&](const char* name) {
    const int index = findPlotColumn(name);
    EXPECT_GE(index, 0) << name;
    return index < 0 ? 0.0F : values[static_cast<std::size_t>(index)];
  };
  EXPECT_EQ(of("tick"), 7.0F);
  EXPECT_FLOAT_EQ(of("time_s"), 0.007F);
  EXPECT_FLOAT_EQ(of("error_mm"), 2.0F);
  EXPECT_FLOAT_EQ(of("v_WT_mm_per_s_y"), 20.0F);
  EXPECT_FLOAT_EQ(of("heat_3"), 0.3F);
  EXPECT_EQ(of("input"), 5.0F);
  EXPECT_EQ(findPlotColumn("nonsense"), -1);
}

/// The turn of the stylus as the columns say it, with joint 1 at that angle, in rad.
Eigen::Quaterniond turnAt(double q1_rad, const ColumnRows& like) {
  ColumnRows rows = like;
  servo::TickRecord record = tickAt(0, 0.001);
  record.q_rad = {q1_rad, 0.6, 0.3, 0.2, 1.2, -0.4};
  rows.add(0.0, record);
  const auto part = [&](std::size_t index) { return static_cast<double>(rows.value(0, index)); };
  return {part(0), part(1), part(2), part(3)};
}

TEST(PlotColumns, SayHowTheStylusIsTurned) {
  ColumnRows rows({findPlotColumn("quat_WT_w"), findPlotColumn("quat_WT_x"), findPlotColumn("quat_WT_y"),
                   findPlotColumn("quat_WT_z")});
  const Eigen::Quaterniond before = turnAt(0.0, rows), after = turnAt(0.5, rows);
  EXPECT_NEAR(before.norm(), 1.0, 1e-6);
  const Eigen::AngleAxisd between(after * before.inverse());  // joint 1 turns all that follows, about the upright axis
  EXPECT_NEAR(between.angle(), 0.5, 1e-6);
  EXPECT_NEAR(std::abs(between.axis().y()), 1.0, 1e-6);
  rows.setGeometry(arm::findPreset("puma-560")->geometry);
  EXPECT_GT(turnAt(0.0, rows).angularDistance(before), 0.1) << "the same angles of another arm";
  servo::TickRecord without = tickAt(0, 0.001);
  without.input = 0;
  rows.add(0.0, without);
  EXPECT_TRUE(std::isnan(rows.value(0, 0))) << "the arm gave no sample";
}

TEST(PlotColumns, RowsAreHalvedAndOldOnesDropped) {
  ColumnRows rows({findPlotColumn("error_mm")}, 1000);
  for (std::int64_t tick = 0; tick < 5000; ++tick) rows.add(1e-3 * static_cast<double>(tick), tickAt(tick, 0.001));
  EXPECT_LT(rows.size(), 1000U);
  EXPECT_GE(rows.size(), 500U);
  EXPECT_EQ(rows.time_s(0), 0.0);
  EXPECT_FLOAT_EQ(rows.value(rows.size() - 1, 0), 1.0F);
  rows.dropBefore(4.0);
  EXPECT_GE(rows.time_s(0), 4.0);
}

TEST(ColumnButton, ChoosesByNameAndNoMoreThanCanBeToldApart) {
  ColumnButton button("columns", nullptr);
  button.choose({"error_mm", "q1_rad", "nonsense"});
  EXPECT_EQ(button.names(), (QStringList{"q1_rad", "error_mm"}));
  QStringList all;
  for (const PlotColumn& column : plotColumns()) all << column.name;
  button.choose(all);
  EXPECT_EQ(button.chosen().size(), static_cast<std::size_t>(ColumnButton::kMax));
  Plots plots;
  plots.plot.showColumns({findPlotColumn("heat_2")});
  for (std::int64_t tick = 10'000; tick < 12'000; ++tick) plots.plot.add(tickAt(tick, 0.001));
  plots.plot.picture();
  EXPECT_TRUE(plots.plot.dataText('\t').contains("heat_2"));
}

}  // namespace
}  // namespace underact::gui
