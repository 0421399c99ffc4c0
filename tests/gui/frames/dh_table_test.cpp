#include "app/gui/frames/dh_table.h"

#include <gtest/gtest.h>

#include <QTableWidget>

#include "core/arm/model.h"
#include "core/base/units.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow framesFeature();
}

namespace underact::gui::test {

TEST(DhTable, WhatIsTypedIsInMillimetresAndDegreesAndReadBackTheSame) {
  const DhTable start = dhStarts().front().make();
  const DhTable longer = withField(start, 1, DhField::A, "120").value();
  EXPECT_DOUBLE_EQ(longer.rows[1].a_m, 0.12);
  EXPECT_EQ(shownText(longer, 1, DhField::A), QString("120.0"));
  const DhTable twisted = withField(start, 1, DhField::Alpha, QString(QChar(0x2212)) + "90").value();
  EXPECT_NEAR(twisted.rows[1].alpha_rad, -0.5 * kPi, 1e-15);
  EXPECT_EQ(exactText(twisted, 1, DhField::Alpha), QString("-90"));
}

TEST(DhTable, ASlideIsInMillimetresAndForgetsTheAngleItHad) {
  DhTable table = dhStarts().front().make();
  table.q[2] = 1.0;
  table = withField(table, 2, DhField::Type, "prismatic").value();
  EXPECT_EQ(table.q[2], 0.0);
  EXPECT_DOUBLE_EQ(withField(table, 2, DhField::Q, "35").value().q[2], 0.035);
  EXPECT_FALSE(withField(table, 2, DhField::Type, "screw"));
  EXPECT_FALSE(withField(table, 9, DhField::A, "1"));
  EXPECT_FALSE(withField(table, 0, DhField::A, "far"));
}

TEST(DhTable, TheLastRowStaysAndThereAreNoMoreThanEight) {
  DhTable table = dhStarts().front().make();
  for (int more = 0; more < 20; ++more) table = withRow(table, 0);
  EXPECT_EQ(table.rows.size(), kMaxDhRows);
  EXPECT_EQ(table.q.size(), kMaxDhRows);
  for (int fewer = 0; fewer < 20; ++fewer) table = withoutRow(table, 0);
  EXPECT_EQ(table.rows.size(), 1U);
}

TEST(DhTable, FramesAreWhereTheGeometryOfAPlaneHasThem) {
  const DhTable table = dhStarts().front().make();  // links of 100 and 80 mm
  const std::vector<double> q{0.0, 0.5 * kPi, 0.0};
  const std::vector<Pose> frames = framesOf(table, q);
  const Vec3 tip_B = frames.front().inverse() * frames.back().translation();
  EXPECT_NEAR((tip_B - Vec3(0.10, 0.08, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(drawingOf(table, q).joints.size(), 3U);
}

TEST(DhTable, TheMeasuresOfARowLeadFromTheFrameBeforeItToItsOwn) {
  DhTable table = tableOf(*arm::findModel("puma-560"));
  const std::vector<double> q{0.3, -0.4, 0.5, 0.6, -0.7, 0.8};
  const std::vector<Pose> frames = framesOf(table, q);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    Vec3 at_W = frames[row].translation();
    Vec3 x_W = frames[row].linear().col(0), z_W = frames[row].linear().col(2);
    for (const DrawnMeasure& measure : measuresOf(table, q, row)) {
      EXPECT_EQ(measure.axis, measure.text.startsWith("θ") || measure.text.startsWith("d") ? 2 : 0);
      if (measure.turn_rad == 0.0) {
        EXPECT_TRUE(measure.p_W.isApprox(at_W, 1e-9)) << measure.text.toStdString();
        at_W += measure.to_end_W;
        continue;
      }
      const Vec3 leg_W = Eigen::AngleAxisd(measure.turn_rad, measure.axis_W) * measure.to_end_W.normalized();
      (measure.axis == 0 ? z_W : x_W) = leg_W;
    }
    EXPECT_TRUE(at_W.isApprox(frames[row + 1].translation(), 1e-9)) << row;
    EXPECT_TRUE(z_W.isApprox(frames[row + 1].linear().col(2), 1e-9)) << row;
    EXPECT_TRUE(x_W.isApprox(frames[row + 1].linear().col(0), 1e-9)) << row;
  }
  EXPECT_TRUE(measuresOf(table, q, 6).empty());
}

/// The texts of its cells, row by row.
QStringList cellsOf(Desk& desk) {
  auto* const table = desk.find<QTableWidget>("panel.dh.table");
  QStringList cells;
  for (int row = 0; row < table->rowCount(); ++row)
    for (int column = 0; column < static_cast<int>(DhField::Q); ++column) cells << table->item(row, column)->text();
  return cells;
}

QStringList cellsOf(const DhTable& table) {
  QStringList cells;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    for (int field = 0; field < static_cast<int>(DhField::Q); ++field)
      cells << shownText(table, row, static_cast<DhField>(field));
  return cells;
}

TEST(DhPanel, TheTableOfTheScenesArmGoesWithTheSceneUntilAnotherIsChosen) {
  Desk desk(framesFeature());
  ASSERT_TRUE(desk.perform("dh.set", 2, QString("a"), QString("140")));
  const QStringList typed = cellsOf(desk);
  desk.open("04_plane");
  EXPECT_EQ(cellsOf(desk), typed) << "the same arm: what was typed stays";
  desk.open("30_ur5e_table");
  EXPECT_EQ(cellsOf(desk), cellsOf(tableOf(*arm::findModel("ur5e"))));
  desk.show();
  desk.run(500);
  for (int axis = 1; axis <= 3; ++axis)
    EXPECT_EQ(desk.label(QString("panel.dh.tip.2.%1").arg(axis)).remove(QChar(0x2212)), QString("0.0"));
  ASSERT_TRUE(desk.perform("dh.start", QString("puma-560")));
  desk.open("02_sphere");
  EXPECT_EQ(cellsOf(desk), cellsOf(tableOf(*arm::findModel("puma-560"))));
}

TEST(TransformPanel, OrderMattersAndIsSaidToUnlessTheStepsCommute) {
  Desk desk(framesFeature());
  EXPECT_TRUE(desk.label("panel.transform.apart").endsWith("order matters."));
  ASSERT_TRUE(desk.perform("transform.remove") && desk.perform("transform.remove"));
  EXPECT_FALSE(desk.perform("transform.remove")) << "one stays";
  EXPECT_TRUE(desk.label("panel.transform.apart").endsWith("order does not matter."));
  EXPECT_FALSE(desk.perform("transform.set", 1, QString("Rx"), QString("400")));
  EXPECT_FALSE(desk.find("panel.transform.told")->isHidden());
}

}  // namespace underact::gui::test
