#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include "app/gui/feature/panel.h"
#include "app/gui/model/scene_library.h"
#include "app/gui/model/servo_rate.h"
#include "app/gui/window/menus.h"
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
  return {.panels = {{"one", "One", Qt::LeftDockWidgetArea, "Ctrl+Alt+Shift+F1", "The first.", makePlain},
                     {"two", "Two", Qt::LeftDockWidgetArea, "Ctrl+Alt+Shift+F2", "The second.", makePlain, "one"}}};
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

TEST(Menus, HaveEveryActionOfThisWindowOnceAndNoneOfAnother) {
  Desk desk(twoPanels());
  buildMenus(&desk.window(), desk.actions(), *desk.services().recent);
  QHash<QAction*, int> count;
  for (const QMenu* menu : desk.window().menuBar()->findChildren<QMenu*>())
    for (QAction* action : menu->actions())
      if (!action->isSeparator() && action->menu() == nullptr) ++count[action];
  for (const QString& name : desk.actions().names()) {
    QAction* action = desk.actions().find(name);
    if (name.startsWith("menu.")) continue;  // a button of the tool bar that opens a menu
    EXPECT_EQ(count.value(action), action == nullptr ? 0 : 1) << name.toStdString();
  }
}

TEST(Menus, FilesOpenedLatelyAreListedByTheirNames) {
  Desk desk(twoPanels());
  buildMenus(&desk.window(), desk.actions(), *desk.services().recent);
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
