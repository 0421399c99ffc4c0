#include <QApplication>
#include <QDialog>
#include <QDropEvent>
#include <QListWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QSpinBox>

#include "app/gui/visitor/demonstrator_panel.h"
#include "tests/stories/docks_seen.h"
#include "tests/stories/visitor_desk.h"

namespace underact::gui::test {
namespace {

constexpr double kWhole_N = 0.88;
const QStringList kAllowed{"session.stop", "visitor.demonstrator"};

QStringList dialogsSeen() {
  QStringList seen;
  for (const QWidget* widget : QApplication::topLevelWidgets())
    if (qobject_cast<const QDialog*>(widget) != nullptr && widget->isVisible()) seen << widget->objectName();
  return seen;
}

}  // namespace

TEST(VisitorStory, NothingElseCanBeReached) {
  VisitorDesk desk;
  ASSERT_TRUE(desk.begin());
  Actions& actions = desk.window->actions();
  for (const QString& name : actions.names()) {
    if (kAllowed.contains(name)) continue;
    EXPECT_FALSE(actions.perform(name)) << name.toStdString();
    QAction* action = actions.find(name);
    if (action == nullptr) continue;
    const bool checked = action->isChecked();
    action->trigger();  // as its shortcut does
    EXPECT_EQ(action->isChecked(), checked) << name.toStdString();
  }
  EXPECT_EQ(dialogsSeen(), QStringList());
  for (const Qt::Key key : {Qt::Key_F1, Qt::Key_F2, Qt::Key_F5, Qt::Key_F10, Qt::Key_Menu})
    QTest::keyClick(desk.window->windowHandle(), key);
  QTest::keyClick(desk.window->windowHandle(), Qt::Key_F, Qt::AltModifier);
  QTest::keyClick(desk.window->windowHandle(), Qt::Key_Q, Qt::ControlModifier);
  desk.run(100);
  EXPECT_EQ(dialogsSeen(), QStringList());
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
  EXPECT_FALSE(desk.window->close());
  EXPECT_TRUE(desk.window->isVisible());
  EXPECT_FALSE(desk.window->menuBar()->isVisible());
  QMimeData dropped;
  dropped.setUrls({QUrl::fromLocalFile(shippedScene("01_point"))});
  QDragEnterEvent enters(QPoint(50, 50), Qt::CopyAction, &dropped, Qt::LeftButton, {});
  QApplication::sendEvent(desk.window.get(), &enters);
  EXPECT_FALSE(enters.isAccepted());
  QDropEvent drops(QPointF(50, 50), Qt::CopyAction, &dropped, Qt::LeftButton, {});
  QApplication::sendEvent(desk.window.get(), &drops);
  EXPECT_EQ(desk.scene(), "Sphere");
  EXPECT_TRUE(desk.window->findChild<VisitorMode*>()->isOn());
  EXPECT_TRUE(desk.window->isFullScreen());
}

TEST(VisitorStory, HalfOfTheForceIsSentAndAllOfItAfter) {
  VisitorDesk desk;
  ASSERT_TRUE(desk.begin());
  const double pushed_N = desk.maxPushed_N();
  EXPECT_NEAR(pushed_N, 0.5 * kWhole_N, 1e-6);
  desk.window->findChild<VisitorMode*>()->leave();
  desk.window->actions().perform("scene.open", QVariant(shippedScene("02_sphere")));
  desk.run(1000);
  EXPECT_NEAR(desk.maxPushed_N(), kWhole_N, 1e-6);
}

TEST(VisitorStory, ScenesComeInTurnByTimeAndByNext) {
  VisitorDesk desk;
  ASSERT_TRUE(desk.begin());
  EXPECT_EQ(desk.scene(), "Sphere");
  EXPECT_EQ(desk.label("visitor.title"), "Sphere");
  EXPECT_TRUE(desk.label("visitor.feel").contains("to its surface"));
  desk.run(89'000);
  EXPECT_EQ(desk.scene(), "Sphere");
  desk.run(1'500);
  EXPECT_EQ(desk.scene(), "Box from outside");
  desk.press("visitor.next");
  EXPECT_EQ(desk.scene(), "Circle in a tilted plane");
  desk.press("visitor.next");
  EXPECT_EQ(desk.scene(), "Sphere");
  desk.run(1000);
  EXPECT_EQ(desk.host->snapshot().mode, servo::Mode::Running);
}

TEST(VisitorStory, AMinuteAfterTheLastVisitorItIsAsAtFirst) {
  VisitorDesk desk;
  ASSERT_TRUE(desk.begin());
  const Vec3 first = desk.cable->arm().setpoint().p_WT;
  desk.press("visitor.next");
  desk.run(100);
  SceneView& view = desk.window->view();
  view.setFocus();
  QTest::keyPress(desk.window->windowHandle(), Qt::Key_Right, Qt::ShiftModifier);
  QTest::keyRelease(desk.window->windowHandle(), Qt::Key_Right, Qt::ShiftModifier);
  QTest::keyClick(desk.window->windowHandle(), Qt::Key_Left, Qt::AltModifier);  // the view turns
  EXPECT_GT((desk.cable->arm().setpoint().p_WT - first).norm(), 0.005);
  EXPECT_FALSE(view.viewpoint().fits);
  desk.run(59'000);
  EXPECT_EQ(desk.scene(), "Box from outside");
  desk.run(2'000);
  EXPECT_EQ(desk.scene(), "Sphere");
  EXPECT_TRUE(view.viewpoint().fits);
  // Nobody holds the stylus: it rests where friction leaves it.
  EXPECT_LT((desk.cable->arm().setpoint().p_WT - first).norm(), 1e-4);
}

TEST(VisitorStory, AnUnpluggedArmIsSaidAndPushesAgainOnSomebodysWordAlone) {
  VisitorDesk desk;
  ASSERT_TRUE(desk.begin());
  desk.setpointAt({0.0, 0.0, 0.030});
  desk.run(1000);
  desk.plugged_in = false;
  desk.run(200);
  EXPECT_TRUE(desk.find("visitor.trouble")->isVisible());
  EXPECT_TRUE(desk.label("visitor.trouble").contains("stopped answering"))
      << desk.label("visitor.trouble").toStdString();
  EXPECT_TRUE(desk.find("visitor.go")->isVisible());
  EXPECT_EQ(dialogsSeen(), QStringList());
  desk.plugged_in = true;
  static_cast<void>(desk.cable->takeMax_N());
  desk.run(5000);
  EXPECT_EQ(desk.cable->takeMax_N(), 0.0) << "a plug is nobody's word";
  desk.press("visitor.go");
  desk.run(1500);
  EXPECT_GT(desk.cable->takeMax_N(), 0.1);
  EXPECT_FALSE(desk.find("visitor.trouble")->isVisible());
  EXPECT_FALSE(desk.find("visitor.go")->isVisible());
}

TEST(VisitorStory, EscStopsAndTheLargeButtonStarts) {
  VisitorDesk desk;
  ASSERT_TRUE(desk.begin());
  QTest::keyClick(desk.window->windowHandle(), Qt::Key_Escape);
  desk.run(200);
  EXPECT_FALSE(desk.host->running());
  EXPECT_TRUE(desk.find("visitor.go")->isVisible());
  EXPECT_FALSE(desk.find("visitor.trouble")->isVisible());
  desk.press("visitor.go");
  desk.run(200);
  EXPECT_TRUE(desk.host->running());
}

TEST(VisitorStory, TheHiddenKeyOpensTheDemonstratorsPanel) {
  VisitorDesk desk;
  ASSERT_TRUE(desk.begin());
  QTest::keyClick(desk.window->windowHandle(), Qt::Key_U, Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier);
  QTest::qWait(50);
  ASSERT_EQ(dialogsSeen(), QStringList{"demonstrator"});
  desk.find<QSpinBox>("demonstrator.force")->setValue(25);
  EXPECT_NEAR(desk.maxPushed_N(), 0.25 * kWhole_N, 1e-6);
  desk.find<QSpinBox>("demonstrator.dwell")->setValue(10);
  desk.run(11'000);
  EXPECT_EQ(desk.scene(), "Box from outside");
  auto* scenes = desk.find<QListWidget>("demonstrator.scenes");
  for (int row = 0; row < scenes->count(); ++row)
    scenes->item(row)->setCheckState(scenes->item(row)->text() == "Point" ? Qt::Checked : Qt::Unchecked);
  ASSERT_TRUE(QTest::qWaitFor([&desk] {
    desk.run(1);
    return desk.scene() == "Point";
  }));
  desk.press("demonstrator.stop");
  desk.run(200);
  EXPECT_FALSE(desk.host->running());
  scenes->item(scenes->count() - 1)->setCheckState(Qt::Unchecked);
  EXPECT_EQ(QSettings().value("visitor/force_percent").toInt(), 25);
  EXPECT_EQ(QSettings().value("visitor/dwell_s").toInt(), 10);
  EXPECT_EQ(QSettings().value("visitor/scenes").toStringList(), QStringList{shippedScene("01_point")});
  desk.press("demonstrator.leave");
  QTest::qWait(50);
  EXPECT_FALSE(desk.window->findChild<VisitorMode*>()->isOn());
  EXPECT_EQ(dialogsSeen(), QStringList());
}

TEST(VisitorStory, LeavingPutsEverythingBack) {
  VisitorDesk desk;
  ASSERT_TRUE(desk.window->actions().perform("gains.set", QVariantList{"kp", "x", 0.31}));
  desk.window->actions().perform("layer.arm", QVariant(false));
  desk.run(100);
  const std::map<std::string, int> docks = docksSeen(*desk.window);
  const QRect geometry = desk.window->geometry();
  const QString path = desk.window->document().path();
  const QFont font = desk.window->view().font();
  ASSERT_TRUE(desk.begin());
  EXPECT_TRUE(desk.window->view().layers().arm);
  desk.run(200'000);
  desk.window->findChild<VisitorMode*>()->leave();
  QTest::qWait(100);
  desk.run(1000);
  EXPECT_EQ(docksSeen(*desk.window), docks);
  EXPECT_EQ(desk.window->geometry(), geometry);
  EXPECT_FALSE(desk.window->isFullScreen());
  EXPECT_TRUE(desk.window->menuBar()->isVisible());
  EXPECT_EQ(desk.window->document().path(), path);
  EXPECT_TRUE(desk.window->document().modified());
  EXPECT_EQ(desk.host->scene().control.gains.kp_N_per_mm.x(), 0.31);
  EXPECT_FALSE(desk.window->view().layers().arm);
  EXPECT_EQ(desk.window->view().font(), font);
  EXPECT_EQ(desk.host->forceShare(), 1.0);
  EXPECT_TRUE(desk.host->running());
  EXPECT_TRUE(desk.window->actions().perform("edit.undo"));
  EXPECT_NE(desk.host->scene().control.gains.kp_N_per_mm.x(), 0.31);
  EXPECT_FALSE(desk.find("visitor")->isVisible());
}

TEST(VisitorStory, ItDoesNotBeginWhileASessionIsRecorded) {
  VisitorDesk desk;
  desk.window->actions().perform("session.record", QVariant(true));
  ASSERT_TRUE(desk.host->records());
  EXPECT_FALSE(desk.window->actions().perform("visitor.start", QVariant(desk.paths)));
  auto* box = desk.find<QMessageBox>("dialog.no_visitors");
  ASSERT_NE(box, nullptr);
  EXPECT_TRUE(box->informativeText().contains("recorded"));
  EXPECT_EQ(desk.host->forceShare(), 1.0);
  EXPECT_FALSE(desk.host->setForceShare(0.5).empty());
  box->accept();
  desk.window->actions().perform("session.record", QVariant(false));
}

TEST(VisitorStory, AFileThatCannotBeShownIsLeftOut) {
  VisitorDesk desk;
  desk.paths = {temporaryFile("broken.json", "{"), shippedScene("01_point")};
  desk.window->actions().perform("visitor.start", QVariant(desk.paths));
  ASSERT_TRUE(QTest::qWaitFor([&desk] {
    desk.run(1);
    return desk.window->findChild<VisitorMode*>()->count() == 1;
  }));
  EXPECT_EQ(desk.scene(), "Point");
}

TEST(VisitorStory, PicturesOfTheVisitor) {
  for (const char* theme : {"light", "dark"}) {
    Story story("02_sphere");
    story.perform(QString("view.theme.") + theme);
    story.perform("session.start");
    story.perform("visitor.start", QStringList{shippedScene("02_sphere")});
    ASSERT_TRUE(QTest::qWaitFor([&story] {
      story.run(1);
      return story.window().findChild<VisitorMode*>()->count() == 1;
    }));
    story.arm().setSetpoint({.p_WT = Vec3(0.012, 0.018, 0.034)});
    story.run(2000);
    story.view().moveCamera(Camera::Fit);
    story.settle(400);
    story.savePicture(QString("visitor_") + theme);
    story.perform("visitor.demonstrator");
    story.settle(100);
    EXPECT_TRUE(
        story.find("demonstrator")->grab().save(QString(UNDERACT_BINARY) + "/pictures/demonstrator_" + theme + ".png"));
    story.window().findChild<VisitorMode*>()->leave();
  }
}

}  // namespace underact::gui::test
