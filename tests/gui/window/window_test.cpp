#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <QToolBar>

#include "app/gui/feature/panel.h"
#include "app/gui/model/scene_library.h"
#include "app/gui/model/servo_rate.h"
#include "app/gui/window/menus.h"
#include "app/gui/window/purpose.h"
#include "tests/gui/desk.h"

namespace underact::gui::test {
namespace {

class PlainPanel : public Panel {
 public:
  using Panel::Panel;
};

Panel* makePlain(const FeatureParts&, QWidget* parent) {
  return new PlainPanel(parent);
}

/// Two panels, the second one behind the first.
FeatureRow twoPanels() {
  return {.panels = {{"one", "One", Qt::LeftDockWidgetArea, "The first.", makePlain},
                     {"two", "Two", Qt::LeftDockWidgetArea, "The second.", makePlain, "one"}}};
}

}  // namespace

TEST(Docks, APanelIsOpenedAndClosedByTheActionOfItsKeyAndOneBehindAnotherIsClosedAtFirst) {
  Desk desk(twoPanels());
  auto* one = desk.window().findChild<QDockWidget*>("dock.one");
  auto* two = desk.window().findChild<QDockWidget*>("dock.two");
  ASSERT_TRUE(one != nullptr && two != nullptr);
  EXPECT_EQ(one->widget()->objectName(), QString("panel.one"));
  EXPECT_FALSE(one->isHidden());
  EXPECT_TRUE(two->isHidden());
  EXPECT_EQ(desk.actions().find("dock.two")->statusTip(), QString("The second."));
  ASSERT_TRUE(desk.perform("dock.two", true));
  EXPECT_FALSE(two->isHidden());
  ASSERT_TRUE(desk.perform("dock.two", false));
  EXPECT_TRUE(two->isHidden());
}

TEST(Menus, HaveEveryActionOfThisWindowOnceForSomePurposeAndNoneOfAnother) {
  Desk desk(twoPanels());
  QSet<QString> in_some;
  for (const Purpose& purpose : purposes()) {
    buildMenus(&desk.window(), desk.actions(), *desk.services().recent, purpose);
    QHash<QAction*, int> count;
    for (const QMenu* menu : desk.window().menuBar()->findChildren<QMenu*>()) {
      EXPECT_TRUE(!menu->isEmpty() || menu->objectName() == "menu.recent") << menu->objectName().toStdString();
      for (QAction* action : menu->actions())
        if (!action->isSeparator() && action->menu() == nullptr) ++count[action];
    }
    for (const QString& name : desk.actions().names()) {
      const int times = count.value(desk.actions().find(name));
      EXPECT_LE(times, desk.actions().find(name) == nullptr ? 0 : 1) << purpose.key << " " << name.toStdString();
      if (times > 0) in_some.insert(name);
    }
  }
  for (const QString& name : desk.actions().names()) {
    const bool is_elsewhere = name.startsWith("menu.") || name.startsWith("dock.") || name.startsWith("purpose.");
    if (desk.actions().find(name) != nullptr && !is_elsewhere && name != "layout.reset")  // in the rail and tool bar
      EXPECT_TRUE(in_some.contains(name)) << name.toStdString();
  }
}

TEST(Purposes, ShowFourToSixPanelsThatExistAndOpenSomeOfThem) {
  QStringList known;
  for (const PanelRow& row : panelsOf(features())) known << row.key;
  for (const Purpose& purpose : purposes()) {
    EXPECT_GE(purpose.panels.size(), 4) << purpose.key;
    EXPECT_LE(purpose.panels.size(), 6) << purpose.key;
    EXPECT_LE(purpose.buttons.size(), 4) << purpose.key << ": Start and Stop stand beside them";
    for (const QString& panel : purpose.panels) EXPECT_TRUE(known.contains(panel)) << panel.toStdString();
    for (const QString& panel : purpose.opened) EXPECT_TRUE(purpose.panels.contains(panel)) << panel.toStdString();
  }
  EXPECT_EQ(QString(purposeOf("nonsense").key), QString(purposes().front().key));
}

TEST(Menus, FilesOpenedLatelyAreListedByTheirNames) {
  Desk desk(twoPanels());
  buildMenus(&desk.window(), desk.actions(), *desk.services().recent, purposeOf({}));
  auto* recent = desk.window().findChild<QMenu*>("menu.recent");
  ASSERT_NE(recent, nullptr);
  desk.services().recent->add(desk.fileOf("mine.json", "{}"));
  emit recent->aboutToShow();
  ASSERT_EQ(recent->actions().size(), 1);
  EXPECT_EQ(recent->actions().first()->text(), QString("mine.json"));
}

TEST(Services, WhatTheyRememberIsWhatHolds) {
  Settings before;
  before.layers.wires = true;
  before.recent = {shippedScene("05_circle")};
  Desk desk(twoPanels(), "02_sphere", before);
  ASSERT_TRUE(desk.document().setLeftHanded(true).empty());
  ASSERT_TRUE(desk.services().rate->choose(2000).empty());
  Settings after;
  desk.services().remember(after);
  EXPECT_TRUE(after.layers.wires);
  EXPECT_EQ(after.recent, before.recent);
  EXPECT_TRUE(after.left_handed);
  EXPECT_EQ(after.servo_rate_hz, 2000);
}

}  // namespace underact::gui::test
