#include <gtest/gtest.h>

#include <QCoreApplication>

#include "app/gui/application.h"
#include "app/gui/servo/limit_names.h"
#include "app/gui/stability.h"
#include "app/gui/words.h"
#include "app/options/window_options.h"
#include "core/servo/timing.h"
#include "tests/stories/picture_difference.h"

namespace underact::gui::test {

TEST(Parts, LatenessLatelyForgetsWhatIsOlderThanTenSeconds) {
  servo::Timing timing(100);
  const auto add = [&timing](std::int64_t lateness_ns) {
    servo::TickRecord record;
    record.lateness_ns = lateness_ns;
    timing.add(record);
  };
  for (int tick = 0; tick < 1000; ++tick) add(500'000);
  EXPECT_NEAR(timing.lateLately().p99_us, 500.0, 500.0 / 32.0);
  for (int tick = 0; tick < 1000; ++tick) add(tick < 980 ? 7'000 : 90'000);
  EXPECT_NEAR(timing.lateLately().p50_us, 7.0, 7.0 / 32.0);
  EXPECT_NEAR(timing.lateLately().p99_us, 90.0, 90.0 / 32.0);
  EXPECT_NEAR(timing.lateness().max_us, 500.0, 500.0 / 32.0);  // since the start, it is still known
}

TEST(Parts, TheLimitThatCutsMostIsTheOneNamed) {
  EXPECT_EQ(mostLimiting({}), "");
  EXPECT_EQ(mostLimiting({.clamp_N = 0.2, .speed_N = 0.3, .slew_N = 0.1}), "speed");
  EXPECT_EQ(mostLimiting({.clamp_N = 0.4, .speed_N = 0.3}), "greatest force");
  EXPECT_EQ(mostLimiting({.edge_N = 0.1}), "edge");
  EXPECT_EQ(mostLimiting({.heat_N = 0.1}), "heat");
  EXPECT_EQ(mostLimiting({.slew_N = 0.1}), "change");
  EXPECT_EQ(mostLimiting({.clamp_N = 9.0, .frozen = true}), "frozen sample");  // nothing is sent then
}

TEST(Parts, AnExceptionInAnEventIsToldAndTheProgramGoesOn) {
  class Throwing : public QObject {
    bool event(QEvent* event) override {
      if (event->type() == QEvent::User) throw std::runtime_error("a bad day");
      return QObject::event(event);
    }
  } throwing;
  std::string told;
  Application::onException([&told](const std::string& what) {
    told = what;
    throw std::runtime_error("and a worse one");  // from telling: ends nothing either
  });
  QEvent event(QEvent::User);
  EXPECT_FALSE(QCoreApplication::sendEvent(&throwing, &event));
  EXPECT_EQ(told, "a bad day");
  Application::onException({});
  EXPECT_FALSE(QCoreApplication::sendEvent(&throwing, &event));
}

TEST(Parts, CalmStiffnessIsBelowTheExactLimitsOfTheTable) {
  // Mass, damping, kd, rate -> exact limit with one tick of delay, by the spectral radius of the sampled loop.
  EXPECT_NEAR(calmStiffness(0.0, 0.1, 1000), 66.7, 0.1);
  EXPECT_NEAR(calmStiffness(0.0, 0.1, 4000), 266.7, 0.1);
  EXPECT_LE(calmStiffness(0.5, 0.1, 1000), 395.3);
  EXPECT_LE(calmStiffness(0.5, 1.0, 1000), 997.4 * 1.01);
  EXPECT_LE(calmStiffness(2.0, 0.1, 1000), 1331.6);
}

TEST(Parts, NumbersHaveARealMinusAndNoNegativeZero) {
  EXPECT_EQ(numberText(-1.24, 1), QString(QChar(0x2212)) + "1.2");
  EXPECT_EQ(numberText(-0.04, 1), "0.0");
  EXPECT_EQ(numberText(kNotANumber, 1), QString(QChar(0x2013)));
  EXPECT_EQ(directionText({0, 0, -2}), QString("0.000, 0.000, ") + QChar(0x2212) + "1.000");
}

TEST(Parts, TheCommandLineIsUnderstoodOrSaidToBeWrong) {
  using options::parseWindowOptions;
  EXPECT_EQ(parseWindowOptions({"a.json", "--rate", "2000"}).rate_hz, 2000);
  EXPECT_EQ(parseWindowOptions({"a.json"}).scene, "a.json");
  EXPECT_EQ(parseWindowOptions({"--help"}).exit, 0);
  EXPECT_NE(parseWindowOptions({"--help"}).said.find("--scheduling"), std::string::npos);
  EXPECT_EQ(parseWindowOptions({"--rate", "10000"}).rate_hz, 10000);
  EXPECT_EQ(parseWindowOptions({"--scheduling", "rtkit"}).scheduling.way, servo::Way::Rtkit);
  EXPECT_EQ(parseWindowOptions({"--scheduling", "normal", "--core", "1"}).scheduling.core, 1);
  EXPECT_EQ(parseWindowOptions({}).scheduling.way, servo::Way::Auto);
  EXPECT_EQ(parseWindowOptions({}).scheduling.core, -1);
  EXPECT_EQ(parseWindowOptions({"--scheduling", "best"}).exit, 2);
  EXPECT_EQ(parseWindowOptions({"--core", "-1"}).exit, 2);
  EXPECT_EQ(parseWindowOptions({"--core"}).exit, 2);
  EXPECT_NE(parseWindowOptions({"--core"}).said.find("--core"), std::string::npos);
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
