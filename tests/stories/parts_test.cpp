#include <gtest/gtest.h>

#include "app/options/window_options.h"
#include "tests/stories/picture_difference.h"

namespace underact::gui::test {

TEST(Parts, TheCommandLineIsUnderstoodOrSaidToBeWrong) {
  using options::parseWindowOptions;
  EXPECT_EQ(parseWindowOptions({"a.json", "--rate", "2000"}).rate_hz, 2000);
  EXPECT_EQ(parseWindowOptions({"a.json"}).file, "a.json");
  EXPECT_EQ(parseWindowOptions({"--help"}).exit, 0);
  EXPECT_NE(parseWindowOptions({"--help"}).given.find("--scheduling"), std::string::npos);
  EXPECT_EQ(parseWindowOptions({"--rate", "10000"}).rate_hz, 10000);
  EXPECT_EQ(parseWindowOptions({"--scheduling", "rtkit"}).scheduling.method, system::SchedulingMethod::Rtkit);
  EXPECT_EQ(parseWindowOptions({"--scheduling", "normal", "--core", "1"}).scheduling.core, 1);
  EXPECT_EQ(parseWindowOptions({}).scheduling.method, system::SchedulingMethod::Auto);
  EXPECT_EQ(parseWindowOptions({}).scheduling.core, -1);
  EXPECT_EQ(parseWindowOptions({"--scheduling", "best"}).exit, 2);
  EXPECT_EQ(parseWindowOptions({"--core", "-1"}).exit, 2);
  EXPECT_EQ(parseWindowOptions({"--core"}).exit, 2);
  EXPECT_NE(parseWindowOptions({"--core"}).given.find("--core"), std::string::npos);
  EXPECT_EQ(parseWindowOptions({"--max-late", "5"}).max_late, 5);
  EXPECT_EQ(parseWindowOptions({"--max-late", "0"}).exit, 2);
  EXPECT_EQ(parseWindowOptions({"--rate", "10001"}).exit, 2);
  EXPECT_EQ(parseWindowOptions({"--rate", "50"}).exit, 2);
  EXPECT_EQ(parseWindowOptions({"--rate"}).exit, 2);
  EXPECT_EQ(parseWindowOptions({"--picture", "a.json"}).exit, 2);
  EXPECT_EQ(parseWindowOptions({"a.json", "b.json"}).exit, 2);
  EXPECT_EQ(parseWindowOptions({"--fast"}).exit, 2);
  EXPECT_FALSE(parseWindowOptions({}).visitors);
  EXPECT_TRUE(parseWindowOptions({"--visitor"}).visitors);
  EXPECT_EQ(parseWindowOptions({"--visitor"}).exit, 0);
  EXPECT_EQ(parseWindowOptions({"--visitor", "a.json", "b.json"}).visitor_scenes,
            (std::vector<std::string>{"a.json", "b.json"}));
  EXPECT_EQ(parseWindowOptions({"--visitor", "a.json", "--rate", "2000"}).rate_hz, 2000);
  EXPECT_EQ(parseWindowOptions({"--small-pictures", "folder"}).small_pictures, "folder");
}

TEST(Parts, ThePictureDifferenceIsThatOfTheWorstBlock) {
  QImage a(640, 480, QImage::Format_RGB32);
  a.fill(Qt::white);
  QImage b = a;
  for (int y = 32; y < 48; ++y) {
    for (int x = 32; x < 40; ++x) b.setPixelColor(x, y, Qt::black);
  }
  EXPECT_DOUBLE_EQ(worstBlockDifference(a, a), 0.0);
  EXPECT_DOUBLE_EQ(worstBlockDifference(a, b), 0.5);
  EXPECT_DOUBLE_EQ(worstBlockDifference(a, QImage(16, 16, QImage::Format_RGB32)), 1.0);
}

}  // namespace underact::gui::test
