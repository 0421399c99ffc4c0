#include "tests/stories/registration_desk.h"

#include <gtest/gtest.h>

namespace underact::gui::test {

RegistrationFolder::RegistrationFolder() {
  qputenv("UNDERACT_REGISTRATION_DIR", folder_.path().toUtf8());
}

RegistrationFolder::~RegistrationFolder() {
  qunsetenv("UNDERACT_REGISTRATION_DIR");
}

Pose turnedArm() {
  Pose X_DW = Pose::Identity();
  X_DW.linear() = Eigen::AngleAxisd(2.0, Vec3::UnitY()).toRotationMatrix();
  X_DW.translation() = Vec3(0.060, 0.055, -0.040);
  return X_DW;
}

RegistrationDesk::RegistrationDesk(const Beginning& beginning) : story("02_sphere", beginning) {
  EXPECT_TRUE(story.perform("registration.open"));
  EXPECT_TRUE(QTest::qWaitForWindowExposed(dialog()));
  story.run(100);
}

QWidget* RegistrationDesk::widget(const QString& name) {
  auto* const found = dialog() != nullptr ? dialog()->findChild<QWidget*>(name) : nullptr;
  EXPECT_NE(found, nullptr) << name.toStdString();
  return found;
}

void RegistrationDesk::press(const QString& name) {
  ASSERT_TRUE(in(name)->isVisible() && in(name)->isEnabled()) << name.toStdString();
  in(name)->click();
}

void RegistrationDesk::moveTip(const Vec3& p_WT) {
  Vec3 setpoint = p_WT;
  for (int step = 0; step < 12; ++step) {
    story.arm().setSetpoint({setpoint, Vec3::Zero(), Mat3::Identity(), false});
    story.run(750);
    const Vec3 error = p_WT - story.snapshot().report.p_WT;
    if (error.norm() < 0.2e-3) return;
    setpoint += error;
  }
  ADD_FAILURE() << "the hand does not get to " << p_WT.transpose();
}

void RegistrationDesk::touch(const Vec3& p_WT) {
  moveTip(p_WT);
  story.arm().holdButton(true);
  story.run(50);
  story.arm().holdButton(false);
  story.run(600);
}

void RegistrationDesk::touchAll(const std::vector<std::size_t>& order, const Pose& X_DW) {
  const std::vector<Vec3> points_D = tool().run().touching().points_D();
  for (const std::size_t mark : order) touch(X_DW.inverse() * points_D[mark]);
}

void RegistrationDesk::toResult(const std::vector<std::size_t>& order) {
  press("registration.next");
  touchAll(order);
  press("registration.next");
}

void RegistrationDesk::keepPicture(const QString& name) {
  QTest::qWait(150);
  EXPECT_TRUE(dialog()->grab().toImage().save(QString(UNDERACT_BINARY) + "/pictures/" + name + ".png"));
}

}  // namespace underact::gui::test
