#include "core/tradeoff/duration.h"

#include <gtest/gtest.h>

#include "tests/core/tradeoff/shipped.h"

namespace underact::tradeoff {
namespace {

/// What measurePoints() and measureChoices() took of a processor like that of the figures in the guide, in all five
/// hands. tick_ns: as it is predicted for the scene.
struct Known {
  const char* scene;
  double tick_ns;
  double seconds;
  int rate_hz;
  double took_s;
};
constexpr Known kKnown[]{{"05_circle", 275.0, 2.0, 1000, 1.31},    {"05_circle", 275.0, 6.0, 250, 3.44},
                         {"05_circle", 275.0, 0.5, 1000, 0.42},    {"13_joint_space", 534.0, 2.0, 1000, 2.04},
                         {"19_four_bar", 796.0, 2.0, 1000, 2.65},  {"21_puma_560", 1337.0, 2.0, 1000, 3.01},
                         {"21_puma_560", 1337.0, 2.0, 4000, 4.14}, {"27_bracket", 393.0, 2.0, 1000, 1.57},
                         {"27_bracket", 393.0, 2.0, 4000, 2.24},   {"28_trefoil_path", 731.0, 2.0, 4000, 8.19},
                         {"29_signature", 743.0, 2.0, 1000, 5.36}};

TEST(Duration, IsWithinTwiceOfWhatScenesOfEachKindTook) {
  for (const Known& one : kKnown) {
    const double about_s = secondsToMeasure(test::shipped(one.scene), 5, one.seconds, one.rate_hz, one.tick_ns);
    EXPECT_GT(about_s, 0.5 * one.took_s) << one.scene << " at " << one.rate_hz << " Hz";
    EXPECT_LT(about_s, 2.0 * one.took_s) << one.scene << " at " << one.rate_hz << " Hz";
  }
}

TEST(Duration, EachHandTakesAsLongAndALongerRunMore) {
  const scene::Description scene = test::shipped("05_circle");
  const double one_s = secondsToMeasure(scene, 1, 5.0, 1000, 275.0);
  EXPECT_DOUBLE_EQ(secondsToMeasure(scene, 5, 5.0, 1000, 275.0), 5.0 * one_s);
  EXPECT_DOUBLE_EQ(secondsToMeasure(scene, 1, 10.0, 1000, 275.0), 2.0 * one_s);  // ten blocks of 0.5 s, then as many
  EXPECT_GT(secondsToMeasure(scene, 1, 0.5, 1000, 275.0), 0.1 * one_s);          // never less than ten blocks
}

}  // namespace
}  // namespace underact::tradeoff
