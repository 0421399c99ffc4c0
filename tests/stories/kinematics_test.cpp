#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QScrollArea>
#include <QSlider>
#include <QTableWidget>
#include <cmath>

#include "app/gui/kit/theme.h"
#include "app/gui/model/kinematics_now.h"
#include "core/arm/forward.h"
#include "core/arm/model.h"
#include "core/arm/sample.h"
#include "core/base/units.h"
#include "tests/stories/picture_difference.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

const arm::Preset& preset() {
  return *arm::findPreset(arm::kDefaultArm);
}

arm::JointAngles joints_rad(Story& story) {
  return story.snapshot().report.sample.q_rad;
}

double degreesOf(double angle_rad) {
  return angle_rad / kRadPerDegree;
}

/// A window with the panel open, the servo stopped and the numbers of now in it.
struct Lesson : Story {
  explicit Lesson(const Beginning& beginning = {}) : Story("02_sphere", beginning) {
    EXPECT_TRUE(perform("dock.kinematics", true));
    perform("session.stop");
    settle();
    run(500);
  }
  /// The joint goes there, as far as friction lets it; degrees.
  void moveJoint(int joint, double angle_deg) {
    EXPECT_TRUE(perform("joint.set", joint, angle_deg));
    run(3000);
  }
  QString text(const QString& name) { return find<QLabel>("panel.kinematics." + name)->text(); }
  double number(const QString& name) {
    const QString plain = text(name).replace(QChar(0x2212), '-').remove("°").split(' ').first();
    bool is_number = false;
    const double value = plain.toDouble(&is_number);
    EXPECT_TRUE(is_number) << name.toStdString() << ": " << text(name).toStdString();
    return value;
  }
  /// Clicks it, scrolled to where it can be clicked.
  void clickThere(const QString& name) {
    auto* widget = find("panel.kinematics." + name);
    find("panel.kinematics")->findChild<QScrollArea*>()->ensureWidgetVisible(widget);
    settle(20);
    click(widget);
  }
  QTableWidget* table() { return find<QTableWidget>("panel.kinematics.solutions"); }
};

}  // namespace

TEST(KinematicsStory, ThePanelIsClosedAtFirstAndOneKeyOpensItWithAllItsLayers) {
  Story story("02_sphere");
  EXPECT_FALSE(story.find("dock.kinematics")->isVisible());
  const Layers& layers = story.view().layers();
  EXPECT_FALSE(layers.link_frames || layers.ghosts || layers.motion_ellipsoid || layers.force_ellipsoid);
  EXPECT_EQ(story.view().solutionsDrawn(), 0u);
  story.key(Qt::Key_0, Qt::AltModifier);
  EXPECT_TRUE(story.find("dock.kinematics")->isVisible());
  EXPECT_TRUE(layers.link_frames && layers.ghosts && layers.motion_ellipsoid && layers.force_ellipsoid);
  EXPECT_TRUE(story.find<QCheckBox>("panel.kinematics.layer.ghosts")->isChecked());
  story.settle();
  story.key(Qt::Key_0, Qt::AltModifier);
  EXPECT_FALSE(story.find("dock.kinematics")->isVisible());
  EXPECT_FALSE(layers.link_frames || layers.ghosts || layers.motion_ellipsoid || layers.force_ellipsoid);
}

TEST(KinematicsStory, TheSlidersMoveTheArmOnlyWhileTheServoIsStopped) {
  Lesson story;
  auto* slider = story.find<QSlider>("panel.kinematics.joint.1.slider");
  story.perform("session.start");
  story.run(500);
  EXPECT_FALSE(slider->isEnabled());
  EXPECT_TRUE(story.text("joints.note").contains("Stop")) << story.text("joints.note").toStdString();
  EXPECT_FALSE(story.perform("joint.set", 1, 20.0));
  story.perform("session.stop");
  story.run(500);
  ASSERT_EQ(story.snapshot().mode, servo::Mode::Idle);
  EXPECT_TRUE(slider->isEnabled());
  EXPECT_FALSE(story.text("joints.note").contains("Stop"));

  story.type(story.find("panel.kinematics.joint.1.number"), "20");
  story.run(3000);
  EXPECT_NEAR(degreesOf(joints_rad(story)[0]), 20.0, 0.5);  // friction holds it a little short
  EXPECT_NEAR(slider->value() / 10.0, degreesOf(joints_rad(story)[0]), 0.06);
  slider->setFocus();
  for (int step = 0; step < 3; ++step) {
    story.key(Qt::Key_PageDown);  // 5 degrees each, from where the joint was wished
    story.run(3000);
  }
  EXPECT_NEAR(degreesOf(joints_rad(story)[0]), 5.0, 0.5);
  story.moveJoint(5, 60.0);  // the gimbal has no friction, only encoders
  EXPECT_NEAR(degreesOf(joints_rad(story)[4]), 60.0, 0.5);
  EXPECT_NEAR(degreesOf(joints_rad(story)[0]), 5.0, 0.5);  // and the others stay
}

TEST(KinematicsStory, StepsAddUpFromWhatWasWishedAndNotFromWhereFrictionLeftTheArm) {
  Lesson story;
  arm::JointAngles setpoint_rad = joints_rad(story);
  story.moveJoint(1, 20.0);
  story.moveJoint(3, 35.0);
  story.find("panel.kinematics.joint.2.number")->setFocus();
  for (int step = 0; step < 3; ++step) {
    story.key(Qt::Key_Up);  // 1 degree
    story.run(500);
  }
  setpoint_rad[0] = 20.0 * kRadPerDegree;
  setpoint_rad[1] += 3.0 * kRadPerDegree;
  setpoint_rad[2] = 35.0 * kRadPerDegree;
  const Pose X_WT = arm::tipPose(preset().geometry, setpoint_rad);
  EXPECT_LT((story.arm().setpoint().p_WT - X_WT.translation()).norm(), 1e-9);
  EXPECT_TRUE(story.arm().setpoint().R_WT.isApprox(X_WT.linear(), 1e-9));

  story.arm().setSetpoint(
      {Vec3(0.0, 0.0, 0.05), Vec3::Zero(), Mat3::Identity(), false});  // somebody else takes the hand
  story.run(3000);
  setpoint_rad = joints_rad(story);
  setpoint_rad[0] = -10.0 * kRadPerDegree;
  ASSERT_TRUE(story.perform("joint.set", 1, -10.0));
  EXPECT_LT((story.arm().setpoint().p_WT - arm::tipPosition(preset().geometry, setpoint_rad)).norm(), 1e-9);
}

TEST(KinematicsStory, AJointAtItsLimitSaysSoAndGoesNoFurther) {
  Lesson story;
  EXPECT_EQ(story.text("joint.3.state"), QString());
  story.moveJoint(3, 120.0);
  EXPECT_NEAR(degreesOf(joints_rad(story)[2]), degreesOf(preset().limits.max_rad[2]), 0.5);
  EXPECT_EQ(story.text("joint.3.state"), QString("at limit"));
}

TEST(KinematicsStory, TheNumbersShownAreTheLibrarys) {
  Lesson story;
  story.moveJoint(1, -25.0);
  story.moveJoint(3, 35.0);
  story.moveJoint(4, 40.0);
  const arm::JointAngles q_rad = joints_rad(story), device_rad = arm::deviceFromDh(q_rad);
  const arm::Model& model = *arm::findModel(arm::kDefaultArm);
  for (int joint = 0; joint < 6; ++joint) {
    const auto index = static_cast<std::size_t>(joint);
    const QString row = QString::number(joint + 1);
    EXPECT_NEAR(story.number("dh." + row + ".1"), degreesOf(model.rows[index].alpha_rad), 0.051);
    EXPECT_NEAR(story.number("dh." + row + ".2"), 1e3 * model.rows[index].a_m, 0.051);
    EXPECT_NEAR(story.number("dh." + row + ".3"), degreesOf(model.rows[index].theta_rad + q_rad[index]), 0.051);
    EXPECT_NEAR(story.number("dh." + row + ".4"), 1e3 * model.rows[index].d_m, 0.051);
    EXPECT_NEAR(story.number("angles." + row + ".1"), degreesOf(q_rad[index]), 0.051);
    EXPECT_NEAR(story.number("angles." + row + ".2"), degreesOf(device_rad[index]), 0.051);
  }
  const Mat6 J = arm::kinematics(preset().geometry, q_rad).J;
  const Mat3 J_p = arm::positionJacobian(preset().geometry, q_rad);
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      const QString cell = QString("%1.%2").arg(row + 1).arg(column + 1);
      EXPECT_NEAR(story.number("jacobian.whole." + cell), J(row, column), 0.00051) << cell.toStdString();
      if (row >= 3 || column >= 3) continue;
      EXPECT_NEAR(story.number("jacobian.position." + cell), J_p(row, column), 0.00051) << cell.toStdString();
    }
  }
  const arm::Dexterity dexterity = arm::dexterity(preset().geometry, q_rad);
  EXPECT_NEAR(story.number("figures.1.1"), dexterity.det_m3, 0.51e-6);
  EXPECT_NEAR(story.number("figures.2.1"), dexterity.manipulability_m3, 0.51e-6);
  EXPECT_NEAR(story.number("figures.3.1"), dexterity.condition, 0.0051);
  EXPECT_EQ(story.text("figures.4.1"), QString("%1, %2, %3 m/rad")
                                           .arg(dexterity.gain_m[0], 0, 'f', 3)
                                           .arg(dexterity.gain_m[1], 0, 'f', 3)
                                           .arg(dexterity.gain_m[2], 0, 'f', 3));
  const arm::SingularityDistances distances = arm::singularityDistances(preset().geometry, q_rad);
  EXPECT_NEAR(story.number("singularity.shoulder.value"), 1e3 * distances.shoulder_m, 0.051);
  EXPECT_NEAR(story.number("singularity.elbow.value"), degreesOf(distances.elbow_rad), 0.051);
  EXPECT_NEAR(story.number("singularity.wrist.value"), degreesOf(distances.wrist_rad), 0.051);
}

TEST(KinematicsStory, EightGhostsAndTheirRowsAreTheSolutionsOfTheLibrary) {
  Lesson story;
  story.moveJoint(1, 15.0);
  story.perform("layer.ghosts", true);
  EXPECT_EQ(story.view().solutionsDrawn(), 8u);
  const arm::Solutions solutions =
      arm::solveAll(preset().geometry, preset().limits, arm::tipPose(preset().geometry, joints_rad(story)));
  ASSERT_EQ(solutions.count, 8u);
  int within = 0;
  for (const arm::Solution& solution : solutions) {
    within += solution.within_limits ? 1 : 0;
    const int row = numberOf(solution.branch) - 1;
    const auto sign = [](std::int8_t of) { return of > 0 ? QString("+") : QString(QChar(0x2212)); };
    EXPECT_EQ(story.table()->item(row, 1)->text(), sign(solution.branch.shoulder));
    EXPECT_EQ(story.table()->item(row, 2)->text(), sign(solution.branch.elbow));
    EXPECT_EQ(story.table()->item(row, 3)->text(), sign(solution.branch.wrist));
    EXPECT_TRUE(story.table()->item(row, 5)->text().contains(solution.within_limits ? "within" : "outside")) << row;
  }
  EXPECT_EQ(story.text("solutions.status"), QString("8 solutions, %1 within the joint limits.").arg(within));
  EXPECT_TRUE(story.table()->item(0, 5)->text().contains("now"));  // the arm itself is the first
}

TEST(KinematicsStory, AChosenSolutionsGhostTurnsThereAndThePictureChanges) {
  Lesson story;
  story.view().setHint({});
  story.view().clearFocus();
  story.settle(300);
  const QImage before = story.view().picture();
  const arm::JointAngles from_rad = joints_rad(story);
  QTableWidget* table = story.table();
  story.click(table->viewport(), table->visualItemRect(table->item(2, 1)).center());  // the other elbow
  EXPECT_TRUE(story.view().solutionMoving());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !story.view().solutionMoving(); }));
  const arm::Solutions solutions =
      arm::solveAll(preset().geometry, preset().limits, arm::tipPose(preset().geometry, from_rad));
  ASSERT_TRUE(story.view().chosenSolution_rad().has_value());
  EXPECT_EQ(*story.view().chosenSolution_rad(), solutions.all[2].q_rad);
  EXPECT_GT(worstBlockDifference(before, story.view().picture()), 2.0 * kTolerance);
  EXPECT_TRUE(story.text("solutions.angles").startsWith("q = ")) << story.text("solutions.angles").toStdString();

  table->setFocus();
  story.key(Qt::Key_Down);  // by keys, too
  ASSERT_TRUE(QTest::qWaitFor([&] { return !story.view().solutionMoving(); }));
  EXPECT_EQ(*story.view().chosenSolution_rad(), solutions.all[3].q_rad);
  story.clickThere("solutions.again");
  EXPECT_TRUE(story.view().solutionMoving());
  story.clickThere("solutions.none");
  EXPECT_FALSE(story.view().chosenSolution_rad().has_value());
  story.settle();
  EXPECT_LT(worstBlockDifference(before, story.view().picture()), kTolerance);
}

TEST(KinematicsStory, TheGhostIsHalfwayThereOnTheWay) {
  Lesson story;
  story.perform("solution.show", 3);
  const arm::Solutions solutions =
      arm::solveAll(preset().geometry, preset().limits, arm::tipPose(preset().geometry, joints_rad(story)));
  const double from_rad = joints_rad(story)[2], to_rad = solutions.all[2].q_rad[2];
  bool on_the_way = false;
  while (story.view().solutionMoving()) {
    const double share = ((*story.view().chosenSolution_rad())[2] - from_rad) / (to_rad - from_rad);
    on_the_way = on_the_way || (share > 0.1 && share < 0.9);
    QTest::qWait(20);
  }
  EXPECT_TRUE(on_the_way);
}

TEST(KinematicsStory, ABarTurnsAmberNearItsSingularity) {
  Lesson story;
  story.perform("view.theme.light");
  auto* bar = story.find("panel.kinematics.singularity.elbow");
  const auto colour = [&] {
    const QWidget* track = story.find("panel.kinematics.singularity.elbow.bar");
    return bar->grab().toImage().pixelColor(track->x() + 3, bar->height() / 2);
  };
  EXPECT_EQ(story.text("singularity.elbow.word"), QString());
  EXPECT_NE(colour(), Theme::light().force);
  story.moveJoint(3, 78.0);  // 12 degrees from the stretched arm
  EXPECT_EQ(story.text("singularity.elbow.word"), QString("near"));
  EXPECT_EQ(colour(), Theme::light().force);
  EXPECT_EQ(story.text("singularity.wrist.word"), QString());
}

TEST(KinematicsStory, NumbersStandStillWhileNobodySeesThem) {
  Lesson story;
  const QString shown = story.text("dh.1.3");
  story.perform("dock.kinematics", false);
  EXPECT_TRUE(story.perform("joint.set", 1, 30.0));
  story.run(3000);
  EXPECT_EQ(story.text("dh.1.3"), shown);
  story.perform("dock.kinematics", true);
  story.settle();
  EXPECT_NEAR(story.number("dh.1.3"), degreesOf(joints_rad(story)[0]), 0.051);
}

TEST(KinematicsStory, NothingInThePanelMovesWhenNumbersChange) {
  Lesson story;
  const auto places = [&] {
    QList<QRect> all;
    for (const QWidget* widget : story.find("panel.kinematics")->findChildren<QWidget*>()) {
      if (widget->isVisible()) all << QRect(widget->mapToGlobal(QPoint()), widget->size());
    }
    return all;
  };
  story.settle();
  const QList<QRect> before = places();
  story.moveJoint(1, -50.0);
  story.moveJoint(3, 78.0);
  story.moveJoint(6, -120.0);
  story.perform("session.start");
  story.run(500);
  story.settle();
  EXPECT_EQ(places(), before);
}

TEST(KinematicsStory, NoNumberIsCutAtTheUsualTextNorAtTwiceIt) {
  const QFont default_value = QApplication::font();
  for (const double share : {1.0, 2.0}) {
    QFont font = default_value;
    font.setPointSizeF(share * default_value.pointSizeF());
    QApplication::setFont(font);
    {
      Lesson story({.size = {1920, 1080}});
      story.moveJoint(6, -130.0);
      story.moveJoint(4, 120.0);
      int seen = 0;
      for (const QLabel* label : story.find("panel.kinematics")->findChildren<QLabel*>()) {
        if (!label->isVisible() || label->text().isEmpty() || label->wordWrap()) continue;
        EXPECT_GE(label->width(), label->fontMetrics().horizontalAdvance(label->text()))
            << label->objectName().toStdString() << ' ' << label->text().toStdString();
        EXPECT_GE(label->height(), label->fontMetrics().height()) << label->objectName().toStdString();
        ++seen;
      }
      EXPECT_GT(seen, 90);
      const auto* number = story.find<QDoubleSpinBox>("panel.kinematics.joint.6.number");
      ASSERT_TRUE(number->text().startsWith(QChar(0x2212))) << number->text().toStdString();
      EXPECT_GE(number->width(), number->fontMetrics().horizontalAdvance(number->text()) + 16);
      const QTableWidget* table = story.table();
      for (int column = 0; column < 4; ++column) {
        EXPECT_GE(table->columnWidth(column),
                  table->fontMetrics().horizontalAdvance(table->horizontalHeaderItem(column)->text()));
      }
      EXPECT_TRUE(
          story.picture().save(QString("%1/pictures/window_kinematics_text_%2.png").arg(UNDERACT_BINARY).arg(share)));
    }
  }
  QApplication::setFont(default_value);
}

TEST(KinematicsStory, ItIsSeenWhereOpaqueChildrenCoverAllOfIt) {
  Lesson story;
  auto* const panel = story.find("panel.kinematics");
  QWidget cover(panel);
  cover.setAttribute(Qt::WA_OpaquePaintEvent);
  cover.setGeometry(panel->rect());
  cover.show();
  ASSERT_TRUE(panel->visibleRegion().isEmpty());
  const double before_deg = story.number("dh.1.3");
  story.moveJoint(1, 20.0);
  EXPECT_GT(std::abs(story.number("dh.1.3") - before_deg), 5.0);
}

TEST(KinematicsStory, LayersAndThePanelAreRemembered) {
  {
    Lesson story;
    story.perform("layer.link_frames", true);
    story.perform("layer.force_ellipsoid", true);
  }
  Story story({}, {.first_start = false});
  EXPECT_TRUE(story.find("dock.kinematics")->isVisible());
  EXPECT_TRUE(story.view().layers().link_frames && story.view().layers().force_ellipsoid);
  EXPECT_FALSE(story.view().layers().ghosts || story.view().layers().motion_ellipsoid);
  story.perform("layout.reset");
  EXPECT_FALSE(story.find("dock.kinematics")->isVisible());
}

TEST(KinematicsStory, FindingASceneBringsTheScenesToTheFront) {
  Lesson story;
  EXPECT_TRUE(story.find("panel.scenes.filter")->visibleRegion().isEmpty());
  story.perform("scenes.find");
  story.settle();
  EXPECT_FALSE(story.find("panel.scenes.filter")->visibleRegion().isEmpty());
}

TEST(KinematicsStory, ThePictureOfTheLesson) {
  Lesson story;
  story.perform("view.theme.light");
  story.perform("view.kinematics");
  story.perform("solution.show", 5);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !story.view().solutionMoving(); }));
  EXPECT_LT(story.imageDifference("kinematics"), kTolerance);
}

// To be looked at by people: build/.../pictures/window_kinematics_THEME.png.
TEST(KinematicsStory, TheWindowOfTheLesson) {
  for (const char* theme : {"light", "dark"}) {
    Lesson story;
    story.perform(QString("view.theme.") + theme);
    story.perform("view.kinematics");
    story.moveJoint(1, 20.0);
    story.perform("solution.show", 3);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !story.view().solutionMoving(); }));
    EXPECT_TRUE(story.picture().save(QString("%1/pictures/window_kinematics_%2.png").arg(UNDERACT_BINARY).arg(theme)));
  }
}

}  // namespace underact::gui::test
