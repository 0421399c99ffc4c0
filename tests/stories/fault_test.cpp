#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <atomic>
#include <stdexcept>

#include "app/gui/fault/fault_dialog.h"
#include "app/gui/fault/fault_watch.h"
#include "app/gui/model/fault_folder.h"
#include "tests/stories/story.h"
#include "tests/support/loose_cable.h"

namespace underact::gui::test {
namespace {

using underact::test::LooseCable;

// The window on that arm, running, with no fault from before.
struct Rig {
  Rig()
      : host(std::make_unique<LooseCable>(pushing(), plugged_in), {.clock = servo::Clock::Manual}),
        window(forgotten({host, nullptr, theme})) {
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    window.actions().perform("scene.open", shippedScene("02_sphere"));
    window.actions().perform("session.start");
    run(1500);
  }
  static device::SimulatedArm::Options pushing() {
    device::SimulatedArm::Options options = simulatedArmOptions(1000);
    options.start_p_WT = {0.0, 0.0, 0.049};  // the hand rests a millimetre in the sphere
    return options;
  }
  static WindowParts forgotten(const WindowParts& parts) {
    forgetSettings();
    QDir(faultFolder()).removeRecursively();
    QFile::remove(faultFolder());
    return parts;
  }
  void run(int ticks) {
    host.run(ticks);
    window.frame();
  }
  void pull() {
    plugged_in = false;
    run(100);
    plugged_in = true;
  }
  template <class Widget = QWidget>
  Widget* find(const char* name) {
    auto* found = window.findChild<Widget*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  QString label(const char* name) { return find<QLabel>(name)->text(); }
  FaultDialog* dialog() { return window.findChild<FaultDialog*>("dialog.fault"); }
  void press(const char* button) { QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton); }

  std::atomic<bool> plugged_in{true};
  servo::Host host;
  ThemeWatcher theme;
  MainWindow window;
};

QStringList faultFiles() {
  return QDir(faultFolder()).entryList({"*"}, QDir::Files, QDir::Name);
}

QJsonObject read(const QString& name) {
  QFile file(QDir(faultFolder()).filePath(name));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  QJsonParseError error;
  const QJsonDocument document = QJsonDocument::fromJson(file.readAll(), &error);
  EXPECT_EQ(error.error, QJsonParseError::NoError) << error.errorString().toStdString();
  return document.object();
}

}  // namespace

TEST(FaultStory, APulledCableIsSaidAndStartClearsIt) {
  Rig rig;
  EXPECT_EQ(rig.label("status.mode"), "Running, 1000 Hz");
  EXPECT_EQ(rig.label("status.device"), "Arm on a loose cable (untested)");
  EXPECT_TRUE(rig.find<QLabel>("status.mode")->toolTip().contains("latency p99"));
  for (const char* detail : {"status.rate", "status.late", "status.scheduling"})
    EXPECT_FALSE(rig.find(detail)->isVisible()) << detail << " is in the tip";
  EXPECT_EQ(rig.dialog(), nullptr);
  rig.pull();
  EXPECT_EQ(rig.host.snapshot().mode, servo::Mode::Faulted);
  EXPECT_EQ(rig.host.snapshot().report.force.f_T_W().norm(), 0.0);
  EXPECT_EQ(rig.label("status.mode"), "Fault");
  EXPECT_TRUE(rig.find<QLabel>("status.mode")->toolTip().contains("stopped answering"));
  ASSERT_TRUE(rig.window.actions().find("session.start")->isEnabled());
  rig.window.actions().perform("session.start");
  rig.run(100);
  EXPECT_EQ(rig.label("status.mode"), "Running, 1000 Hz");
}

TEST(FaultStory, AFaultBringsItsDialogOnceWithASentenceAndWhatToDo) {
  Rig rig;
  rig.pull();
  ASSERT_NE(rig.dialog(), nullptr);
  EXPECT_TRUE(rig.dialog()->isVisible());
  EXPECT_FALSE(rig.dialog()->isModal());
  EXPECT_EQ(rig.label("dialog.fault.what"), "The arm stopped answering.");
  EXPECT_TRUE(rig.label("dialog.fault.meaning").startsWith("Force is off"));
  EXPECT_TRUE(rig.label("dialog.fault.to_do").contains("press Start"));
  EXPECT_FALSE(rig.find("dialog.fault.list")->isVisible());
  rig.run(500);
  rig.run(500);
  EXPECT_EQ(rig.dialog()->count(), 1);
  EXPECT_EQ(rig.window.findChildren<FaultDialog*>().size(), 1);
  rig.dialog()->resize(600, 460);
  QTest::qWait(100);
  EXPECT_TRUE(rig.dialog()->grab().toImage().save(QString(UNDERACT_BINARY) + "/pictures/dialog_fault.png"));
  rig.window.actions().perform("view.theme.dark");
  QTest::qWait(100);
  EXPECT_TRUE(rig.dialog()->grab().toImage().save(QString(UNDERACT_BINARY) + "/pictures/dialog_fault_dark.png"));
}

TEST(FaultStory, TheFileHoldsTheSecondBeforeTheFault) {
  Rig rig;
  rig.pull();
  ASSERT_EQ(faultFiles().size(), 1);
  EXPECT_TRUE(rig.label("dialog.fault.file").endsWith(faultFiles().first()));
  const QJsonObject fault = read(faultFiles().first());
  EXPECT_EQ(fault["underact_fault"].toInt(), 1);
  EXPECT_EQ(fault["kind"].toString(), "no_sample");
  EXPECT_EQ(fault["what"].toString(), "The arm stopped answering.");
  EXPECT_EQ(fault["scene"].toObject()["title"].toString(), "Sphere");
  EXPECT_EQ(fault["device"].toObject()["title"].toString(), "Arm on a loose cable");
  const QJsonArray rows = fault["rows"].toArray();
  ASSERT_EQ(rows.size(), 1000);
  const qsizetype tick = fault["columns"].toArray().toVariantList().indexOf("tick");
  ASSERT_EQ(tick, 0);
  EXPECT_EQ(rows.last().toArray()[0].toInteger(), fault["tick"].toInteger());
  EXPECT_EQ(rows.first().toArray()[0].toInteger(), fault["tick"].toInteger() - 999);
  const qsizetype kind = fault["columns"].toArray().toVariantList().indexOf("fault");
  EXPECT_EQ(rows.last().toArray()[kind].toString(), "no_sample");
  EXPECT_EQ(rows.first().toArray()[kind].toString(), "none");
  QTest::mouseClick(rig.find<QPushButton>("dialog.fault.copy"), Qt::LeftButton);
  EXPECT_EQ(QApplication::clipboard()->text(), QDir(faultFolder()).filePath(faultFiles().first()));
}

TEST(FaultStory, StartAgainClosesTheDialogAndGoesOn) {
  Rig rig;
  rig.pull();
  rig.press("dialog.fault.start");
  rig.run(500);
  EXPECT_FALSE(rig.dialog()->isVisible());
  EXPECT_EQ(rig.host.snapshot().mode, servo::Mode::Running);
}

TEST(FaultStory, ALaterFaultJoinsTheListOfTheOpenDialog) {
  Rig rig;
  rig.pull();
  rig.window.actions().perform("session.start");
  rig.run(500);
  rig.pull();
  EXPECT_EQ(rig.dialog()->count(), 2);
  EXPECT_TRUE(rig.find("dialog.fault.list")->isVisible());
  EXPECT_EQ(faultFiles().size(), 2);
  EXPECT_TRUE(rig.label("dialog.fault.file").endsWith(faultFiles().last()));
  rig.find<QListWidget>("dialog.fault.list")->setCurrentRow(0);
  EXPECT_TRUE(rig.label("dialog.fault.file").endsWith(faultFiles().first()));
  rig.press("dialog.fault.close");
  EXPECT_FALSE(rig.dialog()->isVisible());
  ASSERT_TRUE(rig.window.actions().perform("servo.fault"));  // once more, to look at
  EXPECT_TRUE(rig.dialog()->isVisible());
  EXPECT_EQ(rig.dialog()->count(), 1);
}

TEST(FaultStory, TheKeyboardStaysWithTheWindowAndEscStopsFromBoth) {
  Rig rig;
  rig.window.actions().perform("view.focus");
  rig.pull();
  QTest::qWait(100);
  EXPECT_EQ(QApplication::activeWindow(), &rig.window);
  EXPECT_TRUE(rig.window.view().hasFocus());
  rig.window.actions().perform("session.start");
  rig.run(100);
  ASSERT_TRUE(rig.host.running());
  QTest::keyClick(rig.window.windowHandle(), Qt::Key_Escape);
  EXPECT_FALSE(rig.host.running());
  EXPECT_TRUE(rig.dialog()->isVisible());
  rig.run(200);
  rig.window.actions().perform("session.start");
  ASSERT_TRUE(rig.host.running());
  rig.dialog()->activateWindow();
  ASSERT_TRUE(QTest::qWaitFor([&] { return QGuiApplication::focusWindow() == rig.dialog()->windowHandle(); }));
  QTest::keyClick(rig.dialog()->windowHandle(), Qt::Key_Escape);
  EXPECT_FALSE(rig.host.running()) << "an arm that is not simulated: every Esc stops it";
  EXPECT_FALSE(rig.dialog()->isVisible());
}

TEST(FaultStory, TheSentenceOfAFaultWinsOverTheBannerOfStop) {
  Rig rig;
  rig.pull();
  EXPECT_FALSE(rig.find("view.stopped")->isVisible());
  rig.window.actions().perform("session.start");
  rig.run(100);
  rig.window.actions().perform("session.stop");
  rig.run(300);
  EXPECT_TRUE(rig.find("view.stopped")->isVisible());
}

TEST(FaultStory, AFolderThatCannotBeWrittenIsToldAndTheFaultIsToldAllTheSame) {
  Rig rig;
  QDir().mkpath(QFileInfo(faultFolder()).path());
  QFile in_its_place(faultFolder());
  ASSERT_TRUE(in_its_place.open(QIODevice::WriteOnly));
  in_its_place.close();
  rig.pull();
  EXPECT_EQ(rig.label("dialog.fault.what"), "The arm stopped answering.");
  EXPECT_TRUE(rig.label("dialog.fault.file").contains("cannot be written"))
      << rig.label("dialog.fault.file").toStdString();
  EXPECT_FALSE(rig.find("dialog.fault.copy")->isEnabled());
  QFile::remove(faultFolder());
}

TEST(FaultStory, ARestartThatFailsSaysWhyAndOneThatWorksClosesTheDialog) {
  Rig rig;
  rig.pull();
  rig.plugged_in = false;
  rig.press("dialog.fault.restart");
  EXPECT_TRUE(rig.dialog()->isVisible());
  EXPECT_EQ(rig.label("panel.servo.told"), "The arm could not be reopened. No arm answers on the cable.");
  rig.plugged_in = true;
  rig.press("dialog.fault.restart");
  EXPECT_FALSE(rig.dialog()->isVisible());
  rig.run(100);
  rig.window.actions().perform("session.start");
  rig.run(500);
  EXPECT_EQ(rig.host.snapshot().mode, servo::Mode::Running);
}

TEST(FaultStory, AnExceptionInTheWindowStopsTheForceIsToldAndTheWindowGoesOn) {
  Rig rig;
  int thrown = 0;
  QAction* action = rig.window.actions().add({"test.throw", "Throw", QKeySequence("Ctrl+Alt+F12"), "Throws.", {}, {}},
                                             [&thrown](const QVariantList&) -> bool {
                                               ++thrown;
                                               throw std::runtime_error("the shelf is empty");
                                             });
  ASSERT_NE(action, nullptr);
  ASSERT_TRUE(rig.host.running());
  QTest::keyClick(rig.window.windowHandle(), Qt::Key_F12, Qt::ControlModifier | Qt::AltModifier);
  ASSERT_EQ(thrown, 1);
  EXPECT_FALSE(rig.host.running());
  QTest::qWait(20);
  rig.run(200);
  EXPECT_EQ(rig.host.snapshot().report.force.f_T_W().norm(), 0.0);
  EXPECT_TRUE(rig.label("dialog.fault.what").contains("the shelf is empty"));
  ASSERT_EQ(faultFiles().size(), 1);
  const QJsonObject fault = read(faultFiles().first());
  EXPECT_EQ(fault["kind"].toString(), "window");
  EXPECT_TRUE(fault["what"].toString().contains("the shelf is empty"));
  EXPECT_EQ(fault["rows"].toArray().size(), 1000);
  QTest::keyClick(rig.window.windowHandle(), Qt::Key_F12, Qt::ControlModifier | Qt::AltModifier);
  QTest::qWait(20);
  EXPECT_EQ(thrown, 2);
  EXPECT_TRUE(rig.label("dialog.fault.what").endsWith("(2 times)"));  // counted, not told anew
  EXPECT_EQ(faultFiles().size(), 1);
  rig.press("dialog.fault.start");
  rig.run(500);
  EXPECT_EQ(rig.host.snapshot().mode, servo::Mode::Running);
}

}  // namespace underact::gui::test
