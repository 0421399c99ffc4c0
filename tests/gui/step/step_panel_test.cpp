#include "app/gui/step/step_panel.h"

#include <gtest/gtest.h>

#include "app/gui/model/arm_in_use.h"
#include "core/scene/edit.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow stepFeature();
}

namespace underact::gui::test {

TEST(StepPanel, GainsGoToTheSceneAsOneStepBack) {
  Desk desk(stepFeature());
  ASSERT_TRUE(desk.perform("step.law", QString("PD")));
  ASSERT_TRUE(desk.perform("step.set", QString("kp"), 0.7));
  EXPECT_EQ(desk.undoText(), QString()) << "to try something changes no scene";
  ASSERT_TRUE(desk.perform("step.give"));
  const scene::Control& control = scene::controlOf(desk.scene(), 0);
  EXPECT_EQ(control.law, scene::LawType::PD);
  EXPECT_TRUE(control.gains.kp_N_per_mm.isApprox(Vec3::Constant(0.7)));
  EXPECT_EQ(desk.undoText(), QString("gains of the step response"));
}

TEST(StepPanel, SaysThePolesOfTheMassThatIsHeld) {
  Desk desk(stepFeature());
  desk.show();  // nothing is computed for a panel that nobody sees
  desk.perform("step.law", QString("P"));
  desk.perform("step.set", QString("kp"), 0.1);    // 100 N/m
  desk.perform("step.set", QString("mass"), 1.0);  // s^2 + 100
  desk.perform("step.set", QString("damping"), 0.0);
  EXPECT_TRUE(desk.label("panel.step.poles").contains("0.000 ± 10.00i"))
      << desk.label("panel.step.poles").toStdString();
  EXPECT_TRUE(desk.label("panel.step.note").startsWith("The response oscillates for ever"));
}

TEST(StepPanel, RefusesNegativeNumbersAndWhatIsNoQuantity) {
  Desk desk(stepFeature());
  EXPECT_FALSE(desk.perform("step.set", QString("kp"), -1.0));
  EXPECT_FALSE(desk.perform("step.set", QString("weight"), 1.0));
  EXPECT_FALSE(desk.perform("step.law", QString("I")));
  EXPECT_FALSE(desk.perform("step.show", 17));
}

}  // namespace underact::gui::test
