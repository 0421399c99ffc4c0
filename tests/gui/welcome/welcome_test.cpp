#include "app/gui/welcome/welcome.h"

#include <gtest/gtest.h>

#include <QPushButton>

#include "app/gui/welcome/tour.h"
#include "tests/gui/desk.h"
#include "tests/gui/example.h"

namespace underact::gui {
FeatureRow welcomeFeature();
}

namespace underact::gui::test {

TEST(Welcome, ComesAtTheFirstStartAloneAndStaysAwayOnceItWasClosed) {
  Desk first(welcomeFeature());
  first.show();
  EXPECT_TRUE(first.find("welcome")->isVisible());
  Settings settings;
  first.listener<Welcome>().remember(settings);
  EXPECT_FALSE(settings.has_pushed) << "nothing was tried";
  first.find<QPushButton>("welcome.close")->click();
  first.frame();
  EXPECT_FALSE(first.find("welcome")->isVisible());
  first.listener<Welcome>().remember(settings);
  EXPECT_TRUE(settings.has_pushed);
  Desk later(welcomeFeature(), "02_sphere", settings);
  later.show();
  EXPECT_FALSE(later.find("welcome")->isVisible());
  later.perform("help.welcome");
  later.frame();
  EXPECT_TRUE(later.find("welcome")->isVisible()) << "asked for";
}

TEST(Welcome, SaysWhatCanBeDoneWithTheShapeThatIsThere) {
  Desk desk(welcomeFeature());
  desk.show();
  EXPECT_TRUE(desk.label("welcome.push").contains("Push into the sphere"));
  desk.open("05_circle");
  desk.frame();
  EXPECT_TRUE(desk.label("welcome.push").contains("Pull the stylus away from the circle"));
}

TEST(Tour, GoesFromStopToStopAndBackAndLeavesNothingBehind) {
  Settings seen;
  seen.has_pushed = true;
  Desk desk(welcomeFeature(), "02_sphere", seen);
  desk.show();
  Tour& tour = desk.listener<Tour>();
  EXPECT_EQ(tour.stop(), -1);
  ASSERT_TRUE(desk.perform("help.tour"));
  EXPECT_EQ(tour.stop(), 0);
  desk.find<QPushButton>("tour.next")->click();
  EXPECT_EQ(tour.stop(), 1);
  desk.find<QPushButton>("tour.back")->click();
  EXPECT_EQ(tour.stop(), 0);
  tour.end();
  EXPECT_EQ(tour.stop(), -1);
  EXPECT_FALSE(tour.isVisible());
}

}  // namespace underact::gui::test
