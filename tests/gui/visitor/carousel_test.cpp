#include "app/gui/visitor/carousel.h"

#include <gtest/gtest.h>

namespace underact::gui::test {

TEST(Carousel, TheNextSceneComesWhenTheDwellIsOverAndTheResetOnceAMinuteAfterTheLastTouch) {
  Carousel carousel;
  carousel.setDwell(90.0);
  carousel.showed(0.0);
  EXPECT_EQ(carousel.at(59.9, false), Carousel::Step::Stay) << "nobody was there: nothing to reset";
  EXPECT_EQ(carousel.at(61.0, true), Carousel::Step::Stay);
  EXPECT_EQ(carousel.at(90.0, false), Carousel::Step::Next);
  carousel.showed(90.0);
  EXPECT_EQ(carousel.at(120.9, false), Carousel::Step::Stay);
  EXPECT_EQ(carousel.at(121.0, false), Carousel::Step::Reset);
  carousel.showed(121.0);
  EXPECT_EQ(carousel.at(210.9, false), Carousel::Step::Stay) << "once for each visitor";
  EXPECT_EQ(carousel.at(211.0, false), Carousel::Step::Next);
}

}  // namespace underact::gui::test
