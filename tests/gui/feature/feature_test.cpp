#include "app/gui/feature/feature.h"

#include <gtest/gtest.h>

#include <QDockWidget>
#include <QMainWindow>

namespace underact::gui::test {

TEST(HelpPlace, IsThatOfTheLongestNameThatAPartOrWhatItLiesInGoesOnFrom) {
  const std::vector<HelpPage> pages{{"panel.feel", "window#feel"}, {"panel.feel.rate", "velocity"}};
  QWidget outer;
  outer.setObjectName("panel.feel");
  QWidget inner(&outer);
  EXPECT_EQ(helpPageOf(&inner, pages), QString("window#feel"));
  inner.setObjectName("panel.feel.rate.law");
  EXPECT_EQ(helpPageOf(&inner, pages), QString("velocity"));
  inner.setObjectName("panel.feelings");  // goes on without a dot: another thing, in the same panel
  EXPECT_EQ(helpPageOf(&inner, pages), QString("window#feel"));
  EXPECT_EQ(helpPageOf(nullptr, pages), QString("start"));
  EXPECT_EQ(helpPageOf(&inner, {}), QString("start"));
}

TEST(Opener, IsTheFirstRowThatOpensTheKind) {
  const std::vector<FeatureRow> rows{{}, {.opens = FileKind::Mesh, .open_action = "mesh.add"}};
  EXPECT_EQ(openerOf(FileKind::Mesh, rows), QString("mesh.add"));
  EXPECT_EQ(openerOf(FileKind::Scene, rows), QString());
}

TEST(Dock, KnowsItsKeyAndWhereItStandsAtFirst) {
  QMainWindow window;
  QDockWidget* feel = makeDock("feel", "Feel", Qt::RightDockWidgetArea, &window);
  QDockWidget* plots = makeDock("plots", "Plots", Qt::BottomDockWidgetArea, &window);
  window.addDockWidget(Qt::LeftDockWidgetArea, feel);  // somebody has moved it
  EXPECT_EQ(docksOf(&window), (QList<QDockWidget*>{feel, plots}));
  EXPECT_EQ(keyOf(plots), QString("plots"));
  EXPECT_EQ(homeOf(feel), Qt::RightDockWidgetArea);
}

}  // namespace underact::gui::test
