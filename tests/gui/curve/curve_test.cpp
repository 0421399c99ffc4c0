#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <memory>

#include "app/gui/curve/curve_dialog.h"
#include "app/gui/feature/feature.h"

namespace underact::gui {
FeatureRow curveFeature();
}

namespace underact::gui::test {
namespace {

std::shared_ptr<const std::vector<Vec3>> pointsOfCurve(double unit) {
  return std::make_shared<const std::vector<Vec3>>(
      std::vector<Vec3>{{0, 0, 0}, {40 * unit, 0, 0}, {40 * unit, 30 * unit, 0}, {0, 30 * unit, 0}});
}

scene::Curve curveOf(const CurveDialog& dialog) {
  return std::get<scene::Curve>(dialog.constraint().shape);
}

}  // namespace

TEST(CurveDialog, WhatLiesOutsideTheWorkspaceComesIntoItsMiddle) {
  const auto far = std::make_shared<const std::vector<Vec3>>(std::vector<Vec3>{{900, 0, 0}, {940, 0, 0}, {920, 30, 0}});
  const scene::Constraint made = CurveDialog("/home/knot.csv", far, true, nullptr).constraint();
  const auto& curve = std::get<scene::Curve>(made.shape);
  EXPECT_EQ(made.name, "knot");
  const Vec3 middle = curve.X_WM.topLeftCorner<3, 3>() * Vec3(920, 15, 0) + curve.X_WM.topRightCorner<3, 1>();
  EXPECT_LT(middle.norm(), 60.0);
}

TEST(CurveDialog, MetresAreProposedWhereTheSizeSaysSo) {
  EXPECT_DOUBLE_EQ(curveOf(CurveDialog("a.csv", pointsOfCurve(1.0), true, nullptr)).scale_mm_per_unit, 1.0);
  EXPECT_DOUBLE_EQ(curveOf(CurveDialog("a.csv", pointsOfCurve(0.001), true, nullptr)).scale_mm_per_unit, 1000.0);
}

TEST(CurveDialog, TheWishIsWhatIsChosen) {
  CurveDialog dialog("a.csv", pointsOfCurve(1.0), true, nullptr);
  auto* closed = dialog.findChild<QCheckBox*>();
  const bool was_closed = curveOf(dialog).closed;
  closed->setChecked(!was_closed);
  EXPECT_NE(curveOf(dialog).closed, was_closed);
  const curve::CurveKind kind = curveOf(dialog).kind;
  auto* choice = dialog.findChild<QComboBox*>();
  choice->setCurrentIndex(1 - choice->currentIndex());
  EXPECT_NE(curveOf(dialog).kind, kind);
}

}  // namespace underact::gui::test
