#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <memory>

#include "app/gui/curve/curve_dialog.h"
#include "app/gui/curve/curve_files.h"

namespace underact::gui::test {
namespace {

std::shared_ptr<const std::vector<Vec3>> pointsOfCurve(double unit) {
  return std::make_shared<const std::vector<Vec3>>(
      std::vector<Vec3>{{0, 0, 0}, {40 * unit, 0, 0}, {40 * unit, 30 * unit, 0}, {0, 30 * unit, 0}});
}

}  // namespace

TEST(CurveFiles, AFileIsACurveByItsEnd) {
  EXPECT_TRUE(isCurveFile("path.csv"));
  EXPECT_TRUE(isCurveFile("PATH.CSV"));
  EXPECT_FALSE(isCurveFile("path.json"));
  EXPECT_FALSE(isCurveFile("csv"));
}

TEST(CurveFiles, WhatLiesOutsideTheWorkspaceComesIntoItsMiddle) {
  const auto far = std::make_shared<const std::vector<Vec3>>(std::vector<Vec3>{{900, 0, 0}, {940, 0, 0}, {920, 30, 0}});
  const scene::Constraint made = constraintOf("/home/knot.csv", far, {.kind = curve::Kind::Polyline, .closed = true});
  const auto& curve = std::get<scene::Curve>(made.shape);
  EXPECT_TRUE(curve.closed);
  EXPECT_EQ(curve.kind, curve::Kind::Polyline);
  EXPECT_EQ(made.name, "knot");
  const Vec3 middle = curve.X_WM.topLeftCorner<3, 3>() * Vec3(920, 15, 0) + curve.X_WM.topRightCorner<3, 1>();
  EXPECT_LT(middle.norm(), 60.0);
}

TEST(CurveDialog, MetresAreProposedWhereTheSizeSaysSo) {
  EXPECT_DOUBLE_EQ(CurveDialog("a.csv", pointsOfCurve(1.0), true, nullptr).wish().mm_per_unit, 1.0);
  EXPECT_DOUBLE_EQ(CurveDialog("a.csv", pointsOfCurve(0.001), true, nullptr).wish().mm_per_unit, 1000.0);
}

TEST(CurveDialog, TheWishIsWhatIsChosen) {
  CurveDialog dialog("a.csv", pointsOfCurve(1.0), true, nullptr);
  auto* closed = dialog.findChild<QCheckBox*>();
  const bool was_closed = dialog.wish().closed;
  closed->setChecked(!was_closed);
  EXPECT_NE(dialog.wish().closed, was_closed);
  const curve::Kind kind = dialog.wish().kind;
  auto* choice = dialog.findChild<QComboBox*>();
  choice->setCurrentIndex(1 - choice->currentIndex());
  EXPECT_NE(dialog.wish().kind, kind);
}

}  // namespace underact::gui::test
