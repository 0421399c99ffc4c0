#pragma once
#include <gtest/gtest.h>

#include <QLabel>
#include <QScrollArea>
#include <QTableWidget>

#include "tests/stories/story.h"

namespace underact::gui::test {

/// A window with the Robot panel open.
struct Robot : Story {
  /// The columns of the table of joints.
  enum Column { kType, kAxisX, kAxisY, kAxisZ, kPointX, kPointY, kPointZ, kMin, kMax, kSpring, kRest };

  explicit Robot(const QString& scene, const Beginning& beginning = {}) : Story(scene, beginning) {
    EXPECT_TRUE(perform("dock.robot", true));
    perform("view.theme.light");
    settle();
  }
  const scene::VirtualManipulator& robot(std::size_t index = 0) {
    return std::get<scene::VirtualManipulator>(host().scene().constraints.at(index).shape);
  }
  target::Robot now() { return snapshot().report.held[0].robot; }
  Vec3 wanted_N() { return snapshot().report.f_T_W; }  // before the gate
  QTableWidget* joints() { return find<QTableWidget>("panel.robot.joints"); }
  QString refusal() {
    auto* label = find<QLabel>("panel.robot.refusal");
    return label->isVisible() ? label->text() : QString();
  }
  /// The value beside a label of the read-out.
  QString readout(const QString& label) {
    for (const QLabel* value : find("panel.robot.now")->findChildren<QLabel*>()) {
      if (value->accessibleName() == label) return value->text();
    }
    ADD_FAILURE() << "no row " << label.toStdString();
    return {};
  }
  /// The stylus held there, the servo running, everything at rest. z_W: where the stylus points; zero: as it is.
  void hold(const Vec3& p_W, const Vec3& z_W = Vec3::Zero()) {
    sim::HandSetpoint setpoint;
    setpoint.p_WT = p_W;
    if (!z_W.isZero()) {
      setpoint.turns = true;
      setpoint.R_WT = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), z_W).toRotationMatrix();
    }
    arm().setSetpoint(setpoint);
    perform("session.start");
    run(3000);
  }
  void clickThere(const QString& name) {
    auto* widget = find(name);
    auto* scroll = find("panel.robot")->findChild<QScrollArea*>();
    if (scroll->isAncestorOf(widget)) scroll->ensureWidgetVisible(widget);
    settle(20);
    click(widget);
  }
  /// By the keys, as a person types over a cell.
  void typeCell(QTableWidget* table, int row, int column, const QString& text) {
    find("panel.robot")->findChild<QScrollArea*>()->ensureWidgetVisible(table);
    table->setFocus(Qt::TabFocusReason);
    table->setCurrentCell(row, column);
    key(Qt::Key_F2);
    key(Qt::Key_A, Qt::ControlModifier);
    for (const QChar letter : text) QTest::keyClick(window().windowHandle(), letter.toLatin1());
    key(Qt::Key_Return);
    settle(20);
  }
};

}  // namespace underact::gui::test
