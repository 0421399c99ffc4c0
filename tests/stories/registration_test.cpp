#include <gtest/gtest.h>

#include <QApplication>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

#include "app/gui/arms/second_arm.h"
#include "app/gui/registration/registration_tool.h"
#include "core/registration/registration_store.h"
#include "core/registration/sheet.h"
#include "tests/openhaptics/stand_in.h"
#include "tests/stories/registration_desk.h"

namespace underact::gui::test {
namespace {

using Which = RegistrationTool::Which;
using registration::Registration;

/// As if the arm of that key had been registered there.
void keepRegistration(const std::string& arm, const Pose& X_DW, const std::string& folder) {
  Registration registration{arm, "2026-11-22", "underact 0.1.0", {}, {}};
  for (const Vec3& mark_D : registration::sheetPoints(4))
    registration.touches.push_back({mark_D, X_DW.inverse() * mark_D, 0.0});
  registration.fit = fitTouches(registration.touches).value();
  EXPECT_TRUE(registration::saveRegistration(registration, folder).empty());
}

double apart_m(const Pose& a, const Pose& b) {
  return (a.translation() - b.translation()).norm();
}

double turned_rad(const Pose& a, const Pose& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

/// From one place on the screen to another.
QPointF onScreen(Story& story, const Vec3& from_W, const Vec3& to_W) {
  return story.view().screenOf(to_W) - story.view().screenOf(from_W);
}

}  // namespace

TEST(RegistrationStory, ThreeMarksAreTouchedAndTheArmIsFoundWhereItStands) {
  RegistrationDesk desk;
  desk.story.perform("session.start");
  desk.story.run(300);
  EXPECT_TRUE(desk.text("registration.state").startsWith("Not registered"));
  EXPECT_TRUE(desk.text("registration.calibration").contains("needs no calibration"));
  desk.keepPicture("registration_prepare");
  desk.press("registration.next");
  desk.story.run(300);
  EXPECT_EQ(desk.story.snapshot().mode, servo::Mode::Idle);  // nothing pulls at the tip
  EXPECT_FALSE(desk.in("registration.next")->isEnabled());
  EXPECT_TRUE(desk.text("registration.prompt").contains("reference point 1"));
  const std::vector<Vec3> points_D = desk.tool().run().touching().points_D();
  desk.touch(turnedArm().inverse() * points_D[0]);
  EXPECT_TRUE(desk.text("registration.told").startsWith("Reference point 1 has been touched"));
  EXPECT_TRUE(desk.text("registration.prompt").contains("reference point 2"));
  desk.keepPicture("registration_touch");
  desk.touch(turnedArm().inverse() * points_D[1]);
  desk.touch(turnedArm().inverse() * points_D[2]);
  EXPECT_EQ(desk.text("registration.prompt"), "All reference points have been touched.");
  desk.press("registration.next");
  EXPECT_FALSE(desk.in<QLabel>("registration.warnings")->isVisible())
      << desk.text("registration.warnings").toStdString();
  EXPECT_EQ(desk.in<QTableWidget>("registration.residuals")->rowCount(), 3);
  EXPECT_LT(desk.in<QTableWidget>("registration.residuals")->item(0, 1)->text().toDouble(), 0.5);
  EXPECT_TRUE(desk.text("registration.expected").contains("19 of 20"));
  desk.keepPicture("registration_result");
  desk.press("registration.accept");
  desk.story.settle(400);
  const auto& known = desk.tool().of(Which::First);
  ASSERT_TRUE(known);
  EXPECT_LT(apart_m(known->fit.X_DW, turnedArm()), 1e-3);
  EXPECT_LT(turned_rad(known->fit.X_DW, turnedArm()), 0.01);
  EXPECT_TRUE(registration::loadRegistration("simulated", desk.folder.path()).value());
  EXPECT_EQ(desk.story.view().marksDrawn(), 3U);
  desk.story.perform("dock.devices", true);
  EXPECT_TRUE(desk.story.find<QLabel>("panel.devices.registration")->text().startsWith("Registered on "));
  desk.story.settle(400);
  desk.story.savePicture("registration");
}

TEST(RegistrationStory, ThePictureIsTurnedSoThatLeftOnTheDeskIsLeft) {
  const RegistrationFolder folder;
  keepRegistration("simulated", turnedArm(), folder.path());
  Story story("02_sphere");
  EXPECT_EQ(story.view().marksDrawn(), 4U);
  const Pose X_WD = turnedArm().inverse();
  const Vec3 middle_W = X_WD * Vec3(0.06, 0.0, -0.04), right_W = X_WD * Vec3(0.12, 0.0, -0.04),
             up_W = X_WD * Vec3(0.06, 0.06, -0.04);
  story.perform("view.front");
  story.settle(400);
  EXPECT_GT(onScreen(story, middle_W, right_W).x(), 40.0);
  EXPECT_NEAR(onScreen(story, middle_W, right_W).y(), 0.0, 0.5);
  EXPECT_LT(onScreen(story, middle_W, up_W).y(), -40.0);
  EXPECT_NEAR(onScreen(story, middle_W, up_W).x(), 0.0, 0.5);
  story.savePicture("registration_front");
  ASSERT_TRUE(story.perform("layer.from_desk", false));
  story.settle(400);
  EXPECT_GT(onScreen(story, Vec3::Zero(), Vec3(0.06, 0.0, 0.0)).x(), 40.0);  // x of W again
  EXPECT_LT(onScreen(story, middle_W, right_W).x(), 0.0);                    // a turn of 2 rad: right is at the left
  ASSERT_TRUE(story.perform("layer.desk", false));
  EXPECT_EQ(story.view().marksDrawn(), 0U);
}

TEST(RegistrationStory, AnArmThatLiesOnItsSideIsDrawnUprightOnTheDesk) {
  const RegistrationFolder folder;
  Pose X_DW = turnedArm();
  X_DW.linear() = Eigen::AngleAxisd(1.3, Vec3::UnitZ()).toRotationMatrix();  // 75 degrees
  keepRegistration("simulated", X_DW, folder.path());
  Story story("02_sphere");
  story.perform("view.front");
  story.settle(400);
  const Pose X_WD = X_DW.inverse();
  const QPointF up = onScreen(story, X_WD * Vec3::Zero(), X_WD * Vec3(0.0, 0.06, 0.0));
  EXPECT_LT(up.y(), -30.0);
  EXPECT_NEAR(up.x(), 0.0, 0.5);
}

TEST(RegistrationStory, ScenesAndForcesStayWhereTheyAre) {
  const RegistrationFolder folder;
  const auto forceIn = [](Story& story) {
    story.perform("session.start");
    story.arm().setSetpoint({Vec3(0.0, 0.0, 0.045), Vec3::Zero(), Mat3::Identity(), false});
    story.run(3000);
    return Vec3(story.snapshot().report.force.f_T_W());
  };
  Vec3 without;
  {
    Story story("02_sphere");
    without = forceIn(story);
  }
  keepRegistration("simulated", turnedArm(), folder.path());
  Story story("02_sphere");
  EXPECT_EQ(forceIn(story), without);
  EXPECT_GT(without.norm(), 0.05);
}

TEST(RegistrationStory, MarksInAnotherOrderAreNamed) {
  RegistrationDesk desk;
  desk.toResult({1, 0, 2});
  ASSERT_TRUE(desk.in<QLabel>("registration.warnings")->isVisible());
  EXPECT_TRUE(desk.text("registration.warnings").startsWith("The reference points 1 and 2 were probably swapped"))
      << desk.text("registration.warnings").toStdString();
  desk.keepPicture("registration_order");
  desk.press("registration.back");
  EXPECT_TRUE(desk.text("registration.state").startsWith("Not registered"));
}

TEST(RegistrationStory, MarksOnALineAreRefusedBeforeTheyAreTouchedAndTouchesOnALineAfter) {
  RegistrationDesk desk;
  auto* const marks = desk.in<QTableWidget>("registration.marks");
  marks->item(2, 1)->setText("60");
  marks->item(2, 2)->setText("0");
  EXPECT_FALSE(desk.in("registration.next")->isEnabled());
  EXPECT_TRUE(desk.text("registration.layout").contains("one line"));
  EXPECT_FALSE(desk.in("registration.sheet")->isEnabled());
  marks->item(2, 1)->setText("sixty");
  EXPECT_TRUE(desk.text("registration.layout").contains("number"));
  marks->item(2, 1)->setText("0");
  marks->item(2, 2)->setText("80");
  EXPECT_TRUE(desk.in("registration.next")->isEnabled());
  desk.press("registration.next");
  desk.touch({0.0, -0.05, 0.0});
  desk.touch({0.04, -0.05, 0.0});
  desk.touch({-0.04, -0.05, 0.0});
  EXPECT_FALSE(desk.in("registration.next")->isEnabled());
  EXPECT_TRUE(desk.text("registration.told").contains("one line")) << desk.text("registration.told").toStdString();
}

TEST(RegistrationStory, ATipThatMovesIsSaidAndOneMarkIsTouchedAgain) {
  RegistrationDesk desk;
  desk.press("registration.next");
  const std::vector<Vec3> points_D = desk.tool().run().touching().points_D();
  desk.moveTip(turnedArm().inverse() * points_D[0]);
  desk.in("registration.hold")->setFocus();
  desk.story.bringToFront(desk.dialog());
  desk.story.key(Qt::Key_Space);  // the key in place of the button
  EXPECT_TRUE(desk.tool().run().touching().isHolding());
  EXPECT_FALSE(desk.in("registration.hold")->isEnabled());
  desk.story.arm().setSetpoint({Vec3(0.05, -0.03, 0.0), Vec3::Zero(), Mat3::Identity(), false});
  desk.story.run(250);
  EXPECT_GT(desk.in<QProgressBar>("registration.progress")->value(), 20);
  desk.story.run(400);
  EXPECT_TRUE(desk.text("registration.told").startsWith("The tip moved"))
      << desk.text("registration.told").toStdString();
  EXPECT_TRUE(desk.text("registration.prompt").contains("reference point 1"));
  desk.touchAll({0, 1, 0});  // the last one wrong
  desk.in<QTableWidget>("registration.touched")->selectRow(2);
  desk.press("registration.again");
  EXPECT_TRUE(desk.text("registration.prompt").contains("reference point 3"));
  desk.touchAll({2});
  desk.press("registration.next");
  EXPECT_FALSE(desk.in<QLabel>("registration.warnings")->isVisible())
      << desk.text("registration.warnings").toStdString();
}

TEST(RegistrationStory, CancellingLeavesWhatThereWas) {
  RegistrationDesk desk;
  desk.press("registration.next");
  desk.touchAll({0, 1});
  desk.press("registration.cancel");
  desk.story.settle();
  EXPECT_FALSE(desk.tool().run().isOn());
  EXPECT_FALSE(desk.tool().of(Which::First));
  EXPECT_EQ(desk.story.view().marksDrawn(), 0U);
  EXPECT_FALSE(registration::loadRegistration("simulated", desk.folder.path()).value());
  desk.story.run(1000);  // its ticks are heard by nobody
  ASSERT_TRUE(desk.story.perform("registration.open"));
  desk.press("registration.next");
  EXPECT_TRUE(desk.text("registration.prompt").contains("reference point 1"));
}

TEST(RegistrationStory, ItIsThereAgainAtTheNextStartAndCanBeForgotten) {
  const RegistrationFolder folder;
  keepRegistration("simulated", turnedArm(), folder.path());
  {
    Story story("02_sphere", {.first_start = false});
    auto& tool = *story.window().findChild<RegistrationTool*>();
    ASSERT_TRUE(tool.of(Which::First));
    EXPECT_LT(apart_m(tool.of(Which::First)->fit.X_DW, turnedArm()), 1e-9);
    ASSERT_TRUE(story.perform("registration.open"));
    auto* const forget = story.find<QPushButton>("registration.forget");
    ASSERT_TRUE(forget->isVisible());
    forget->click();
    EXPECT_FALSE(tool.of(Which::First));
    EXPECT_FALSE(forget->isVisible());
    EXPECT_EQ(story.view().marksDrawn(), 0U);
  }
  EXPECT_FALSE(registration::loadRegistration("simulated", folder.path()).value());
}

TEST(RegistrationStory, AFileThatIsDamagedIsSaidAndTheArmIsNotRegistered) {
  const RegistrationFolder folder;
  QFile file(QString::fromStdString(registration::registrationPath("simulated", folder.path())));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"underact_registration\": 1");
  file.close();
  Story story("02_sphere");
  EXPECT_EQ(story.view().marksDrawn(), 0U);
  EXPECT_TRUE(story.find<QLabel>("panel.devices.registration")->text().startsWith("Not registered: "));
}

TEST(RegistrationStory, WhatCannotBeKeptIsSaidAndCountsUntilTheWindowCloses) {
  RegistrationDesk desk;
  desk.toResult({0, 1, 2});
  qputenv("UNDERACT_REGISTRATION_DIR", "/proc/nowhere");
  desk.press("registration.accept");
  ASSERT_NE(desk.dialog(), nullptr);
  EXPECT_TRUE(desk.text("registration.kept").contains("until the window closes"));
  EXPECT_EQ(desk.story.view().marksDrawn(), 3U);
  desk.press("registration.accept");
  desk.story.settle();
  EXPECT_EQ(desk.dialog(), nullptr);
}

TEST(RegistrationStory, TwoArmsStandWhereTheirRegistrationsSay) {
  const RegistrationFolder folder;
  Pose X_DS = Pose::Identity();
  X_DS.linear() = Eigen::AngleAxisd(-0.8, Vec3::UnitY()).toRotationMatrix();
  X_DS.translation() = Vec3(0.40, 0.055, -0.10);
  keepRegistration("simulated", turnedArm(), folder.path());
  Story story("02_sphere");
  auto& second = *story.window().findChild<SecondArm*>();
  ASSERT_TRUE(story.perform("second.on", true));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !(second.poll(), second.isLoading()); }, kLong_ms));
  EXPECT_FALSE(second.placed());  // it is not registered itself
  EXPECT_TRUE(story.find("panel.second.side")->isEnabled());
  story.perform("second.on", false);
  keepRegistration("simulated:second", X_DS, folder.path());
  ASSERT_TRUE(story.perform("second.on", true));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !(second.poll(), second.isLoading()); }, kLong_ms));
  ASSERT_TRUE(second.placed());
  const Pose expected = turnedArm().inverse() * X_DS;
  EXPECT_LT(apart_m(*second.placed(), expected), 1e-9);
  EXPECT_LT(turned_rad(*second.placed(), expected), 1e-6);
  EXPECT_FALSE(story.find("panel.second.side")->isEnabled());
  story.perform("second.side", true);  // changes nothing
  EXPECT_TRUE(second.placed());
  for (int done = 0; done < 300; done += 50) {
    second.run(50);
    story.run(50);
  }
  story.settle(400);
  story.savePicture("registration_two_arms");
  ASSERT_TRUE(story.perform("registration.forget", true));
  EXPECT_FALSE(second.placed());
}

TEST(RegistrationStory, TheSecondArmIsRegisteredByItsOwnTicks) {
  const RegistrationFolder folder;
  Story story("02_sphere");
  auto& second = *story.window().findChild<SecondArm*>();
  ASSERT_TRUE(story.perform("second.on", true));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !(second.poll(), second.isLoading()); }, kLong_ms));
  auto& tool = *story.window().findChild<RegistrationTool*>();
  story.perform("second.mirror", false);
  tool.begin(Which::Second, registration::sheetPoints());
  for (int mark = 0; mark < 3; ++mark) {
    const Vec3 p_WT(0.03 * mark, -0.05, mark == 1 ? 0.02 : -0.01);
    second.simulatedArm().setSetpoint({p_WT, Vec3::Zero(), Mat3::Identity(), false});
    for (int done = 0; done < 3000; done += 50) {
      second.run(50);
      story.run(50);
    }
    ASSERT_TRUE(story.perform("registration.touch"));
    for (int done = 0; done < 600; done += 50) {
      second.run(50);
      story.run(50);
    }
  }
  ASSERT_TRUE(tool.run().touching().isDone());
  EXPECT_LT((tool.run().touching().held(2)->p_WT - Vec3(0.06, -0.05, -0.01)).norm(), 3e-3);
  tool.stopTouching();
}

TEST(RegistrationStory, AnArmThatIsNotCalibratedIsNotTouchedWith) {
  const RegistrationFolder folder;
  underact::test::hd::Control* const library = underact::test::standIn();
  ASSERT_NE(library, nullptr);
  library->reset();
  library->plug(true);
  library->placeTip(0.0, 0.0, 0.06);
  Story story("02_sphere", {.servo = {.watchdog_s = 2.0, .max_late = 1'000'000}});
  const auto comes = [](const std::function<bool()>& what) { return QTest::qWaitFor(what, kLong_ms); };
  ASSERT_TRUE(story.perform("devices.use", QString("openhaptics")));
  auto* const in_use = story.find<QLabel>("panel.devices.in_use");
  ASSERT_TRUE(comes([&] { return in_use->text().contains("Untested"); }));
  library->needCalibration(0x5002, 4);
  ASSERT_TRUE(story.perform("registration.open"));
  auto* const calibration = story.find<QLabel>("registration.calibration");
  auto* const next = story.find<QAbstractButton>("registration.next");
  ASSERT_TRUE(comes([&] { return calibration->text().contains("inkwell"); })) << calibration->text().toStdString();
  EXPECT_FALSE(next->isEnabled());
  library->needCalibration(0x5000, 4);
  ASSERT_TRUE(comes([&] { return next->isEnabled(); })) << calibration->text().toStdString();
  EXPECT_TRUE(calibration->text().contains("nothing is missing"));
  // Its marks are touched by its own button, and it is kept by its own name.
  next->click();
  auto& tool = *story.window().findChild<RegistrationTool*>();
  const Pose X_WD = turnedArm().inverse();
  for (std::size_t mark = 0; mark < 3; ++mark) {
    const Vec3 p_WT = X_WD * tool.run().touching().points_D()[mark];
    library->placeTip(p_WT.x(), p_WT.y(), p_WT.z());
    QTest::qWait(200);
    library->holdButtons(1);
    ASSERT_TRUE(comes([&] { return tool.run().touching().due() > mark; })) << tool.run().told().toStdString();
    library->holdButtons(0);
    QTest::qWait(100);
  }
  ASSERT_TRUE(tool.accept().empty());
  const auto& known = tool.of(Which::First);
  ASSERT_TRUE(known);
  EXPECT_TRUE(QString::fromStdString(known->arm).startsWith("openhaptics")) << known->arm;
  EXPECT_LT(apart_m(known->fit.X_DW, turnedArm()), 1e-3);
  const std::string key = known->arm;
  story.perform("devices.simulated");
  EXPECT_FALSE(tool.of(Which::First));  // it is another arm
  ASSERT_TRUE(story.perform("devices.use", QString("openhaptics")));
  ASSERT_TRUE(comes([&] { return tool.of(Which::First).has_value(); }));
  EXPECT_EQ(tool.of(Which::First)->arm, key);
  story.perform("devices.simulated");
  library->reset();
}

TEST(RegistrationStory, EveryWidgetOfTheWizardSpeaksAndLargeTextFits) {
  const QFont default_value = QApplication::font();
  for (const double share : {1.0, 2.0}) {
    QFont font = default_value;
    font.setPointSizeF(share * default_value.pointSizeF());
    QApplication::setFont(font);
    RegistrationDesk desk;
    desk.story.perform(share > 1.0 ? "view.theme.dark" : "view.theme.light");
    EXPECT_LE(desk.dialog()->height(), desk.story.window().height());
    for (const char* name : {"registration.count", "registration.marks", "registration.paper", "registration.sheet",
                             "registration.arm", "registration.next", "registration.cancel"}) {
      auto* const widget = desk.in<QWidget>(name);
      EXPECT_FALSE(widget->accessibleName().isEmpty()) << name;
      EXPECT_TRUE(widget->focusPolicy() & Qt::TabFocus) << name;
      const QRect there(widget->mapTo(desk.dialog(), QPoint()), widget->size());
      EXPECT_TRUE(desk.dialog()->rect().contains(there)) << name << " at " << share;
    }
    desk.keepPicture(share > 1.0 ? "registration_prepare_large_dark" : "registration_prepare_light");
    desk.press("registration.next");
    for (const char* name : {"registration.hold", "registration.again", "registration.touched"}) {
      auto* const widget = desk.in<QWidget>(name);
      EXPECT_FALSE(widget->accessibleName().isEmpty()) << name;
      const QRect there(widget->mapTo(desk.dialog(), QPoint()), widget->size());
      EXPECT_TRUE(desk.dialog()->rect().contains(there)) << name << " at " << share;
    }
  }
  QApplication::setFont(default_value);
}

}  // namespace underact::gui::test
