#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QHash>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QProcess>
#include <QScreen>
#include <QSet>
#include <QSettings>
#include <QTabBar>

#include "tests/stories/language_desk.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

bool isInteractive(const QWidget* widget) {
  if (widget->objectName().startsWith("qt_")) return false;  // parts that Qt makes inside its own widgets
  if (qobject_cast<const QLineEdit*>(widget) && qobject_cast<const QAbstractSpinBox*>(widget->parent())) return false;
  if (qobject_cast<const QAbstractButton*>(widget)) {
    const QWidget* parent = widget->parentWidget();
    return qobject_cast<const QDockWidget*>(parent) == nullptr && qobject_cast<const QLineEdit*>(parent) == nullptr &&
           qobject_cast<const QTabBar*>(parent) == nullptr;  // those that scroll it, unseen where all tabs fit
  }
  return qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
         qobject_cast<const QComboBox*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
         qobject_cast<const QAbstractItemView*>(widget);
}

bool isInsideQtsOwn(const QWidget* widget) {
  for (const QObject* above = widget->parent(); above != nullptr; above = above->parent()) {
    if (above->objectName().startsWith("qt_") || above->inherits("QComboBoxPrivateContainer") ||
        qobject_cast<const QAbstractItemView*>(above) || above->inherits("QAbstractScrollArea")) {
      // what stands in a scroll area's own content widget is ours
      if (!above->inherits("QScrollArea") && above->objectName() != "qt_scrollarea_viewport") return true;
    }
  }
  return false;
}

void collect(const QMenu* menu, QSet<QAction*>& all) {
  for (QAction* action : menu->actions()) {
    if (action->menu() != nullptr) collect(action->menu(), all);
    all.insert(action);
  }
}

}  // namespace

TEST(WindowStory, EveryWidgetThatTakesInputHasANameForStoriesAndOneForScreenReaders) {
  Story story("02_sphere");
  int seen = 0;
  QSet<QString> names;
  for (const QWidget* widget : story.window().findChildren<QWidget*>()) {
    if (!isInteractive(widget) || isInsideQtsOwn(widget)) continue;
    const std::string what = std::string(widget->metaObject()->className()) + " " + widget->objectName().toStdString();
    EXPECT_FALSE(widget->objectName().isEmpty()) << what;
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << what;
    if (const auto* const button = qobject_cast<const QAbstractButton*>(widget)) {
      EXPECT_FALSE(!button->isHidden() && button->text().isEmpty() && button->icon().isNull())
          << what << " shows nothing";
    }
    EXPECT_FALSE(names.contains(widget->objectName())) << what << " stands twice";
    names.insert(widget->objectName());
    ++seen;
  }
  EXPECT_GT(seen, 30);
}

TEST(WindowStory, EveryActionHasAMenuEntryAShortcutOfItsOwnAndATip) {
  Story story("02_sphere");
  QSet<QAction*> in_menus;
  for (QAction* top : story.window().menuBar()->actions()) collect(top->menu(), in_menus);
  QSet<QString> shortcuts;
  for (const QString& name : story.window().actions().names()) {
    QAction* action = story.window().actions().find(name);
    if (action == nullptr || name.startsWith("menu."))
      continue;  // a command with arguments; a button that opens a menu
    EXPECT_TRUE(in_menus.contains(action)) << name.toStdString();
    EXPECT_FALSE(action->statusTip().isEmpty()) << name.toStdString();
    const QString keys = action->shortcut().toString();
    EXPECT_FALSE(keys.isEmpty()) << name.toStdString();
    EXPECT_FALSE(shortcuts.contains(keys)) << name.toStdString() << " " << keys.toStdString();
    shortcuts.insert(keys);
  }
}

TEST(WindowStory, TabReachesEveryControlOfTheFeelPanelInTheOrderOfTheEye) {
  Story story("12_line_pid");
  QWidget* panel = story.find("panel.feel");
  QList<QWidget*> wanted;
  for (QWidget* widget : panel->findChildren<QWidget*>()) {
    if (isInteractive(widget) && !isInsideQtsOwn(widget) && widget->isVisible() && widget->isEnabled())
      wanted << widget;
  }
  story.find("panel.feel.law")->setFocus(Qt::TabFocusReason);
  QList<QWidget*> reached{story.find("panel.feel.law")};
  for (int step = 0; step < 60 && reached.size() < wanted.size(); ++step) {
    story.key(Qt::Key_Tab);
    QWidget* focus = QApplication::focusWidget();
    if (focus != nullptr && panel->isAncestorOf(focus) && !reached.contains(focus)) reached << focus;
  }
  for (QWidget* widget : wanted) EXPECT_TRUE(reached.contains(widget)) << widget->objectName().toStdString();
  for (int index = 1; index < reached.size(); ++index) {
    const QPoint before = reached[index - 1]->mapTo(panel, QPoint()), after = reached[index]->mapTo(panel, QPoint());
    EXPECT_TRUE(after.y() > before.y() - 4) << reached[index]->objectName().toStdString();
  }
}

TEST(WindowStory, LightAndDarkChangeWhileTheServoRuns) {
  Story story("02_sphere");
  story.perform("session.start");
  story.run(500);
  story.perform("view.theme.light");
  story.settle();
  const QColor light = story.picture().pixelColor(5, story.window().height() / 2);
  story.perform("view.theme.dark");
  story.settle();
  const QColor dark = story.picture().pixelColor(5, story.window().height() / 2);
  EXPECT_GT(light.lightness(), 200);
  EXPECT_LT(dark.lightness(), 80);
  story.run(500);
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
}

TEST(WindowStory, LayoutThemeLayersAndFilesAreRememberedAndResetPutsThePanelsBack) {
  {
    Story story("04_plane");
    story.perform("dock.shape", true);
    story.find("dock.scenes")->hide();
    story.perform("view.theme.dark");
    story.perform("layer.arm", false);
    story.perform("plots.axis", "z");
  }
  Story story({}, {.first_start = false});
  EXPECT_TRUE(story.find("dock.shape")->isVisible());
  EXPECT_FALSE(story.find("dock.scenes")->isVisible());
  EXPECT_TRUE(story.find("dock.feel")->isVisible());
  EXPECT_TRUE(story.window().actions().find("view.theme.dark")->isChecked());
  EXPECT_FALSE(story.view().layers().arm);
  EXPECT_EQ(story.find<QComboBox>("panel.plots.axis")->currentIndex(), 2);
  EXPECT_EQ(readSettings().last_scene, shippedScene("04_plane"));
  story.perform("layout.reset");
  EXPECT_FALSE(story.find("dock.shape")->isVisible());
  EXPECT_TRUE(story.find("dock.scenes")->isVisible());
}

TEST(WindowStory, InverseSolutionsBelongToASceneAndAreGoneWithItWithTheLayoutAndAfterARestart) {
  {
    Story story("02_sphere");
    ASSERT_TRUE(story.perform("layer.ghosts", true));
    ASSERT_TRUE(story.perform("scene.open", shippedScene("04_plane")));
    EXPECT_FALSE(story.view().layers().ghosts);
    EXPECT_FALSE(story.window().actions().find("layer.ghosts")->isChecked());
    ASSERT_TRUE(story.perform("layer.ghosts", true));
    ASSERT_TRUE(story.perform("layout.reset"));
    EXPECT_FALSE(story.view().layers().ghosts);
    ASSERT_TRUE(story.perform("layer.ghosts", true));
  }
  Story again({}, {.first_start = false});
  EXPECT_FALSE(again.view().layers().ghosts);
}

/// The letters that Alt opens a menu or does something else with, and what in the panels takes one of them, too.
QStringList takenTwice(Story& story) {
  QHash<QKeySequence, QString> taken;
  QStringList wrong;
  for (const QAction* menu : story.window().menuBar()->actions())
    taken.insert(QKeySequence::mnemonic(menu->text()), menu->text());
  for (const QAction* action : story.window().findChildren<QAction*>()) {
    if (!action->shortcut().toString().startsWith("Alt+")) continue;
    if (taken.contains(action->shortcut())) wrong << action->objectName() + " and " + taken.value(action->shortcut());
    taken.insert(action->shortcut(), action->objectName());
  }
  for (const QWidget* widget : story.window().findChildren<QWidget*>()) {
    const auto* const label = qobject_cast<const QLabel*>(widget);
    const auto* const button = qobject_cast<const QAbstractButton*>(widget);
    const QKeySequence key = label != nullptr && label->buddy() != nullptr ? QKeySequence::mnemonic(label->text())
                             : button != nullptr                           ? button->shortcut()
                                                                           : QKeySequence();
    if (!key.isEmpty() && taken.contains(key))
      wrong << widget->objectName() + ": " + key.toString() + " of " + taken.value(key);
  }
  return wrong;
}

TEST(WindowStory, NoLetterInAPanelTakesTheKeyOfAMenuOrOfAnAction) {
  {
    Story story("02_sphere");
    EXPECT_TRUE(takenTwice(story).isEmpty()) << takenTwice(story).join("\n").toStdString();
    story.key(Qt::Key_C, Qt::AltModifier);
    EXPECT_TRUE(story.view().layers().section);
  }
  const German german;
  Story story("02_sphere");
  EXPECT_TRUE(takenTwice(story).isEmpty()) << takenTwice(story).join("\n").toStdString();
}

TEST(WindowStory, TabGoesOnThroughTabbedPanelsAndRoundAgain) {
  {
    Story before("02_sphere");
    before.perform("dock.sessions", true);
    before.perform("lesson.start", "05_jacobian");
    before.perform("lesson.leave");
  }
  Story story("02_sphere", {.first_start = false});  // with a layout from before
  for (const char* dock : {"dock.kinematics", "dock.robot", "dock.sessions", "dock.servo", "dock.lab"})
    story.perform(dock, true);
  for (const char* dock : {"dock.shape", "dock.arm", "dock.devices"}) {
    story.window().tabifyDockWidget(story.find<QDockWidget>("dock.feel"), story.find<QDockWidget>(dock));
    story.find(dock)->show();
  }
  story.find("dock.feel")->raise();
  story.settle();
  QWidget* const save = story.find("panel.feel.button.scene.save_as");
  save->setFocus(Qt::TabFocusReason);
  QSet<QWidget*> seen;
  QWidget* last = nullptr;
  for (int tabs = 0; tabs < 400 && !seen.contains(QApplication::focusWidget()); ++tabs) {
    last = QApplication::focusWidget();
    ASSERT_NE(last, nullptr);
    ASSERT_TRUE(last->isVisible());
    seen.insert(last);
    story.key(Qt::Key_Tab);
    ASSERT_NE(QApplication::focusWidget(), last) << last->objectName().toStdString() << " keeps the focus";
  }
  EXPECT_TRUE(seen.contains(story.find("button.session.start"))) << last->objectName().toStdString();
  EXPECT_EQ(QApplication::focusWidget(), save) << "it goes round";
}

TEST(WindowStory, TheFocusIsSeenOnStop) {
  Story story("02_sphere");
  QWidget* const stop = story.find("button.session.stop");
  story.view().setFocus();
  story.settle();
  const QImage without = stop->grab().toImage();
  stop->setFocus(Qt::TabFocusReason);
  story.settle();
  EXPECT_NE(stop->grab().toImage(), without);
}

TEST(WindowStory, AfterARestartWhileMaximisedTheNormalSizeIsTheOneFromBefore) {
  QSize normal;
  {
    Story story("02_sphere", {.size = QSize(1100, 700)});
    normal = story.window().normalGeometry().size();
    story.window().showMaximized();
    story.settle(200);
    story.window().document().undoStack().setClean();
    story.window().close();
  }
  for (int restart = 0; restart < 2; ++restart) {
    Story story("02_sphere", {.first_start = false});
    EXPECT_TRUE(story.window().isMaximized());
    EXPECT_EQ(story.window().normalGeometry().size(), normal) << restart;
  }
}

TEST(WindowStory, SettingsOfANewerProgramAreSaidToBeAndLeftAsTheyAre) {
  {
    Story older("04_plane");  // without a version, as the first release wrote them
    older.perform("layer.arm", false);
  }
  QSettings().remove("settings/version");
  { EXPECT_FALSE(Story({}, {.first_start = false}).view().layers().arm); }
  QSettings().setValue("settings/version", kSettingsVersion + 1);
  {
    Story story({}, {.first_start = false});
    EXPECT_TRUE(story.view().layers().arm) << "its own";
    story.settle();
    auto* box = story.find<QMessageBox>("dialog.newer_settings");
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->text().contains("newer version of Underact"));
    box->accept();
    story.perform("layer.force", false);
  }
  EXPECT_EQ(QSettings().value("settings/version").toInt(), kSettingsVersion + 1);
  EXPECT_FALSE(QSettings().value("layers/arm").toBool());
  EXPECT_NE(QSettings().value("layers/force").toString(), "false");
  QSettings().clear();
}

TEST(WindowStory, NothingIsCutAtTheSmallestUsableSize) {
  Story story("12_line_pid", {.size = {1024, 700}});
  EXPECT_EQ(story.window().size(), QSize(1024, 700));
  EXPECT_GE(story.view().width(), 400);
  EXPECT_GE(story.view().height(), 260);
  for (const char* name : {"status.force", "button.session.stop", "panel.gains.kp.x.number"}) {
    QWidget* widget = story.find(name);
    const QRect there(widget->mapTo(&story.window(), QPoint()), widget->size());
    EXPECT_TRUE(story.window().rect().contains(there)) << name;
    EXPECT_GE(widget->width(), widget->minimumSizeHint().width()) << name;
  }
}

TEST(WindowStory, AtTheSmallestSizeAllButtonsOfTheToolBarAndTheFieldsOfFeelAreInTheWindow) {
  Story story("14_circle_influence", {.size = QSize(800, 560)});
  story.settle(200);
  ASSERT_EQ(story.window().size(), QSize(800, 560));
  for (const char* part : {"toolbar", "panel.feel"}) {
    for (QWidget* widget : story.find(part)->findChildren<QWidget*>()) {
      if (!widget->isVisible() || widget->objectName().startsWith("qt_") || widget->objectName().isEmpty()) continue;
      const int right = widget->mapTo(&story.window(), QPoint(widget->width(), 0)).x();
      EXPECT_LE(right, story.window().width()) << widget->objectName().toStdString();
    }
  }
  for (const char* button : {"button.help.guide", "button.dock.lessons", "button.session.record"})
    EXPECT_TRUE(story.find(button)->isVisible()) << button;
}

TEST(WindowStory, WhatAStoryHoldsBackIsPaintedWhenItWaitsOrASecondHasPassed) {
  Story story("02_sphere");
  const auto moveAndRun = [&story](double x_m, int ticks) {
    sim::HandSetpoint setpoint;
    setpoint.p_WT = Vec3(x_m, 0.0, 0.06);
    story.arm().setSetpoint(setpoint);
    story.run(ticks);
  };
  const qint64 at_first = story.view().framesDrawn();
  for (int step = 0; step < 10; ++step) moveAndRun(0.002 * step, 25);
  EXPECT_EQ(story.view().framesDrawn(), at_first);
  story.settle();
  const qint64 settled = story.view().framesDrawn();
  EXPECT_GT(settled, at_first);
  moveAndRun(-0.02, 1000);
  EXPECT_GT(story.view().framesDrawn(), settled);
}

TEST(WindowStory, TheProgramDrawsAPictureAndSaysWhatItIs) {
  QProcess program;
  const QString out = temporaryFile("picture.png");
  program.start(UNDERACT_WINDOW, {"--picture", shippedScene("02_sphere"), "--out", out});
  ASSERT_TRUE(program.waitForFinished(60000));
  EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
  EXPECT_GE(QImage(out).width(), 640);
  program.start(UNDERACT_WINDOW, {"--version"});
  ASSERT_TRUE(program.waitForFinished(60000));
  EXPECT_TRUE(program.readAllStandardOutput().startsWith("underact "));
  program.start(UNDERACT_WINDOW, {"--no-such-thing"});
  ASSERT_TRUE(program.waitForFinished(60000));
  EXPECT_EQ(program.exitCode(), 2);
}

TEST(WindowStory, WhereItCannotDrawTheProgramSaysSoAndEnds) {
  const QStringList scene{UNDERACT_WINDOW, shippedScene("02_sphere")};
  const QStringList picture{UNDERACT_WINDOW, "--picture", scene[1], "--out", temporaryFile("none.png")};
  const std::pair<QStringList, const char*> kRows[]{
      {{"QT_QPA_PLATFORM=offscreen", "DISPLAY="}, "No OpenGL 3.2: this display offers none"},
      {{"MESA_GL_VERSION_OVERRIDE=1.4"}, "offers 1.4"},
      {{"MESA_GL_VERSION_OVERRIDE=2.1"}, "offers 2.1"},
      {{"MESA_GL_VERSION_OVERRIDE=3.0"}, "offers 3.0"},
      {{"DISPLAY=:9999"}, "No display that can be used (DISPLAY=:9999,"},
      {{"DISPLAY=", "WAYLAND_DISPLAY=dead", "QT_QPA_PLATFORM="}, "WAYLAND_DISPLAY=dead)"},
      {{"QT_QPA_PLATFORM=nonsense"}, "\"nonsense\""}};
  for (const auto& [changes, words] : kRows) {
    for (const QStringList& command : {scene, picture}) {
      QProcess program;
      program.start("env", changes + command);
      ASSERT_TRUE(program.waitForFinished(60000));
      const QByteArray given = program.readAllStandardError();
      EXPECT_TRUE(program.exitStatus() == QProcess::NormalExit && program.exitCode() == 2) << words;
      EXPECT_TRUE(given.contains(words) && !given.contains("einstall") && !given.contains("written"))
          << given.toStdString();
    }
  }
}

TEST(WindowStory, OneThatIsMaximisedFromItsStartHasASmallerNormalSize) {
  QWidget before;
  before.setGeometry(before.screen()->availableGeometry());
  before.setWindowState(Qt::WindowMaximized);
  Settings settings;
  settings.geometry = before.saveGeometry();
  writeSettings(settings);
  Story story("02_sphere", {.first_start = false});
  EXPECT_TRUE(story.window().isMaximized());
  EXPECT_LT(story.window().normalGeometry().height(), before.height());
}

}  // namespace underact::gui::test
