#include "app/gui/arm/arm_panel.h"

#include <gtest/gtest.h>

#include <QLabel>

#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui::test {

TEST(ArmPanel, SaysWhereTipAndJointsAreInMillimetresAndDegrees) {
  ArmPanel panel(nullptr);
  servo::Snapshot snapshot;
  snapshot.report.p_WT = Vec3(0.0123, -0.05, 0.0);
  snapshot.report.sample.q_rad = {0.0, 90.0 * kRadPerDegree, -45.0 * kRadPerDegree, 0.0, 0.0, 12.34 * kRadPerDegree};
  snapshot.report.level = 0.5;
  panel.present(snapshot);
  const auto value = [&panel](int row) {
    return panel.findChild<QLabel*>(QString("panel.arm.value.%1").arg(row))->text();
  };
  const QString minus(QChar(0x2212));
  EXPECT_EQ(value(0), placeText({12.3, -50.0, 0.0}));
  EXPECT_EQ(value(1), "0.0°, 90.0°, " + minus + "45.0°");
  EXPECT_EQ(value(2), QString("0.0°, 0.0°, 12.3°"));
  EXPECT_EQ(value(3), QString("50 %"));
  EXPECT_EQ(value(4), QString("none"));
}

TEST(ArmPanel, EachKindOfFaultHasAWordOfItsOwn) {
  ArmPanel panel(nullptr);
  QStringList words;
  for (int kind = 0; kind < kFaultKinds; ++kind) {
    servo::Snapshot snapshot;
    snapshot.report.fault.kind = static_cast<FaultKind>(kind);
    panel.present(snapshot);
    const QString word = panel.findChild<QLabel*>("panel.arm.value.4")->text();
    EXPECT_FALSE(word.isEmpty() || words.contains(word)) << kind << " " << word.toStdString();
    words << word;
  }
}

}  // namespace underact::gui::test
