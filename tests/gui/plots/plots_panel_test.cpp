#include "app/gui/plots/plots_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>

#include "app/gui/plot/live_plot.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow plotsFeature();
}

namespace underact::gui::test {

TEST(PlotsPanel, BeginsAsItWasLeftAndRemembersWhatIsChosen) {
  Settings before;
  before.plot_axis = 2;
  before.energy_plot = false;
  Desk desk(plotsFeature(), "02_sphere", before);
  PlotsPanel& panel = desk.panel<PlotsPanel>();
  EXPECT_EQ(desk.find<QComboBox>("panel.plots.axis")->currentIndex(), 2);
  EXPECT_FALSE(panel.plot().showsEnergy());
  desk.find<QCheckBox>("panel.plots.energy")->setChecked(true);
  desk.find<QComboBox>("panel.plots.axis")->setCurrentIndex(1);
  EXPECT_TRUE(panel.plot().showsEnergy());
  Settings after;
  after.energy_plot = false;
  panel.remember(after);
  EXPECT_EQ(after.plot_axis, 1);
  EXPECT_TRUE(after.energy_plot);
}

TEST(PlotsPanel, TheAxisIsChosenByItsLetterAndNoOther) {
  Desk desk(plotsFeature());
  EXPECT_TRUE(desk.perform("plots.axis", QString("z")));
  EXPECT_EQ(desk.panel<PlotsPanel>().plot().axis(), 2);
  EXPECT_FALSE(desk.perform("plots.axis", QString("w")));
  EXPECT_EQ(desk.panel<PlotsPanel>().plot().axis(), 2);
}

}  // namespace underact::gui::test
