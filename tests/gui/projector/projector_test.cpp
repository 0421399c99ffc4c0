#include "app/gui/projector/projector.h"

#include <gtest/gtest.h>

#include <QToolBar>

#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow projectorFeature();
}

namespace underact::gui::test {

TEST(Projector, TypeGrowsOfViewAndToolsAndIsAsItWasAfter) {
  Desk desk(projectorFeature());
  auto* tools = new QToolBar(&desk.window());
  desk.window().addToolBar(tools);
  const QFont view_font = desk.view().font();
  const QSize icons = tools->iconSize();
  ASSERT_TRUE(desk.perform("view.projector", true));
  EXPECT_GT(desk.view().font().pointSizeF(), 1.5 * view_font.pointSizeF());
  EXPECT_GT(tools->iconSize().width(), icons.width());
  ASSERT_TRUE(desk.perform("view.projector", false));
  EXPECT_EQ(desk.view().font(), view_font);
  EXPECT_EQ(tools->iconSize(), icons);
}

TEST(Projector, ItIsRememberedAndTakenOffBeforeTheLayoutIs) {
  Desk desk(projectorFeature());
  desk.window().addToolBar(new QToolBar(&desk.window()));
  Projector& projector = desk.listener<Projector>();
  Settings settings;
  projector.remember(settings);
  EXPECT_FALSE(settings.projector);
  projector.setOn(true);
  projector.remember(settings);
  EXPECT_TRUE(settings.projector);
  EXPECT_FALSE(projector.isOn());
}

}  // namespace underact::gui::test
