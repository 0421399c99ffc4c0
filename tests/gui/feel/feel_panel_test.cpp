#include "app/gui/feel/feel_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QSlider>

#include "core/scene/edit.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow feelFeature();
}

namespace underact::gui::test {
namespace {

const scene::Control& controlIn(Desk& desk) {
  return scene::controlOf(desk.scene(), 0);
}

}  // namespace

TEST(FeelPanel, AGainReachesTheSceneAndUndoNamesIt) {
  Desk desk(feelFeature());
  FeelPanel& panel = desk.panel<FeelPanel>();
  const Vec3 before = controlIn(desk).gains.kp_N_per_mm;
  desk.find<QCheckBox>("panel.feel.link")->setChecked(false);
  ASSERT_TRUE(panel.setGain(0, 1, 0.25, true));
  EXPECT_EQ(controlIn(desk).gains.kp_N_per_mm, Vec3(before.x(), 0.25, before.z()));
  EXPECT_TRUE(desk.undoText().endsWith(" y")) << desk.undoText().toStdString();
  desk.document().undoStack().undo();
  EXPECT_EQ(controlIn(desk).gains.kp_N_per_mm, before);
}

TEST(FeelPanel, ADragIsOneStepBackAndTheNextOneAnother) {
  Desk desk(feelFeature());
  FeelPanel& panel = desk.panel<FeelPanel>();
  panel.setGain(0, 0, 0.2, true);
  panel.setGain(0, 0, 0.3, false);
  EXPECT_EQ(desk.document().undoStack().count(), 1);
  panel.setGain(0, 0, 0.4, true);
  EXPECT_EQ(desk.document().undoStack().count(), 2);
}

TEST(FeelPanel, ReportsARefusedValueAndKeepsTheScene) {
  Desk desk(feelFeature());
  FeelPanel& panel = desk.panel<FeelPanel>();
  desk.find<QCheckBox>("panel.feel.link")->setChecked(false);
  const Vec3 before = controlIn(desk).gains.kp_N_per_mm;
  EXPECT_FALSE(panel.setGain(0, 2, 0.0, true)) << "one axis without stiffness beside others";
  EXPECT_EQ(controlIn(desk).gains.kp_N_per_mm, before);
  EXPECT_FALSE(desk.find("panel.feel.refusal")->isHidden());
  EXPECT_TRUE(desk.label("panel.feel.refusal").endsWith('.'));
  EXPECT_TRUE(panel.setGain(0, 2, 0.1, true));
  EXPECT_TRUE(desk.find("panel.feel.refusal")->isHidden());
}

TEST(FeelPanel, ResetBringsBackWhatTheFileHasAndIsOfferedOnlyThen) {
  Desk desk(feelFeature());
  const scene::Control own = controlIn(desk);
  EXPECT_FALSE(desk.actions().find("gains.reset")->isEnabled());
  desk.panel<FeelPanel>().set("/control/law", std::string("PID"), true);
  EXPECT_EQ(controlIn(desk).law, scene::LawType::PID);
  EXPECT_TRUE(desk.actions().find("gains.reset")->isEnabled());
  EXPECT_TRUE(desk.panel<FeelPanel>().resetToScene());
  EXPECT_EQ(controlIn(desk).law, own.law);
  EXPECT_EQ(desk.undoText(), QString("reset to scene"));
  EXPECT_FALSE(desk.actions().find("gains.reset")->isEnabled());
}

TEST(FeelPanel, TheLawChosenByHandShowsItsGains) {
  Desk desk(feelFeature());
  auto* law = desk.find<QComboBox>("panel.feel.law");
  law->setCurrentIndex(2);
  EXPECT_EQ(controlIn(desk).law, scene::LawType::PID);
  EXPECT_FALSE(desk.find("panel.gains.ki.x")->parentWidget()->isHidden());
  law->setCurrentIndex(0);
  EXPECT_TRUE(desk.find("panel.gains.ki.x")->parentWidget()->isHidden());
}

}  // namespace underact::gui::test
