#include "device/openhaptics/openhaptics_arm.h"

#include <clocale>

#include "core/servo/host.h"
#include "device/openhaptics/scheduler.h"
#include "tests/openhaptics/arm_fixture.h"
#include "tests/openhaptics/contains.h"
#include "tests/support/pattern.h"

namespace underact::device::openhaptics {
namespace {

using test::comes;
using test::hd::Extent;

std::string lineOf(const std::vector<std::string>& lines, const std::string& beginning) {
  for (const std::string& line : lines) {
    if (line.rfind(beginning, 0) == 0) return line.substr(beginning.size());
  }
  return "(no such line)";
}

}  // namespace

TEST_F(OpenHapticsArmTest, TellsWhatItsDriverKnowsInOurUnits) {
  open();
  const std::vector<std::string> lines = arm->listing();
  EXPECT_EQ(lineOf(lines, "Model: "), "Touch");
  EXPECT_EQ(lineOf(lines, "Serial number: "), "0042") << "and nothing that no screen can show";
  EXPECT_EQ(lineOf(lines, "Continuous force: "), "0.88 N");
  EXPECT_EQ(lineOf(lines, "Largest stiffness: "), "0.5 N/mm");
  EXPECT_EQ(lineOf(lines, "Largest damping: "), "3 N s/m");
  EXPECT_EQ(lineOf(lines, "Speed limit: "), "1 m/s");
  EXPECT_EQ(lineOf(lines, "Limit of the rate of force: "), "400 N/s");
  EXPECT_EQ(lineOf(lines, "Workspace: "), "-210 -110 -85 210 205 130 mm, corner to corner");
  EXPECT_EQ(lineOf(lines, "Table below the origin: "), "110 mm");
  EXPECT_EQ(lineOf(lines, "Driven joints: "), "3");
  EXPECT_EQ(lineOf(lines, "Rate: "), "1000 Hz");
  EXPECT_EQ(lineOf(lines, "Motor temperatures, 0 to 1: "), "0.25 0.25 0.25");
  EXPECT_EQ(lineOf(lines, "Safety switch: "), "(no such line)") << "the stand-in has none";
  EXPECT_EQ(arm->info().title, "Touch (vendor's driver)");
  EXPECT_EQ(arm->info().serial, "0042");
}

TEST_F(OpenHapticsArmTest, PlaceAndTurnOfTheStylusAreWhatTheDriverHasThem) {
  open();
  // The stand-in writes both down from the facts' own formulas. What is left is the rounding of %g, six digits.
  for (const char* line : {"Tip, by the arm against by the model omni-thesis: ", "Stylus, likewise: "}) {
    const std::string text = lineOf(arm->listing(), line);
    const std::vector<test::PatternMatch> match = test::matchesOf("^([-+.e0-9]+) (mm|degrees) apart$", text);
    ASSERT_EQ(match.size(), 1u) << line << text;
    EXPECT_LT(std::stod(match[0].groups[1]), 1e-5) << line << text;  // acos(1 - ulp) is 1e-6 degrees
  }
}

TEST_F(OpenHapticsArmTest, UncalibratedItOpensSaysWhatToDoAndPushesOnlyAfterwards) {
  struct Row {
    std::uint32_t status, style;
    const char* says;
  };
  for (const Row& row : {Row{0x5002, 4, "inkwell"}, Row{0x5002, 2, "Move the stylus"}, Row{0x5002, 1, "reset position"},
                         Row{0x1234, 4, "does not say"}}) {
    far->needCalibration(row.status, row.style);
    open();
    drive();
    ASSERT_TRUE(comes([&] { return contains(arm->trouble(), row.says); })) << arm->trouble();
    ASSERT_TRUE(ticksOn(100));
    EXPECT_TRUE(rests()) << row.says;
    EXPECT_EQ(pusher->without_sample, 0) << "it can be looked at all the same";
    const std::uint32_t before = pusher->epoch;
    far->needCalibration(0x5000, row.style);
    EXPECT_TRUE(pushesSoon()) << row.says << ": " << arm->trouble();
    EXPECT_NE(pusher->epoch, before) << "the servo begins anew, or the force comes at once";
    EXPECT_EQ(arm->trouble(), "");
    close();
    EXPECT_TRUE(rests());
  }
}

TEST_F(OpenHapticsArmTest, ACalibrationThatIsReadyIsTakenUp) {
  far->needCalibration(0x5001, 2);
  open();
  drive();
  EXPECT_TRUE(pushesSoon()) << arm->trouble();
}

TEST_F(OpenHapticsArmTest, InItsResetPositionAPressOfTheButtonCalibrates) {
  far->needCalibration(0x5002, 1);
  open();
  drive();
  ASSERT_TRUE(ticksOn(200));
  EXPECT_TRUE(rests());
  far->holdButtons(1);
  EXPECT_TRUE(pushesSoon()) << arm->trouble();
}

TEST_F(OpenHapticsArmTest, InTheInkwellItRestsAndTakenOutItPushes) {
  openAndPush();
  far->dock(true);
  ASSERT_TRUE(restsSoon());
  EXPECT_TRUE(contains(arm->trouble(), "inkwell")) << arm->trouble();
  far->dock(false);
  EXPECT_TRUE(pushesSoon());
}

TEST_F(OpenHapticsArmTest, ASwitchThatNeverMovedIsNotBelieved) {
  far->dock(true);
  openAndPush();
  EXPECT_EQ(arm->trouble(), "");
}

TEST_F(OpenHapticsArmTest, AnotherModelIsSaidAndOneThatMisleadsGetsNoForce) {
  openAndPush();
  far->shiftPosition(15.0);
  ASSERT_TRUE(comes([this] { return contains(arm->trouble(), "15 mm from where the scene's arm \"omni-thesis\""); }))
      << arm->trouble();
  ASSERT_TRUE(ticksOn(100));
  EXPECT_TRUE(pushes());
  far->shiftPosition(80.0);
  ASSERT_TRUE(restsSoon());
  EXPECT_TRUE(contains(arm->trouble(), "80 mm")) << arm->trouble();
  far->shiftPosition(0.0);
  EXPECT_TRUE(pushesSoon());
  EXPECT_EQ(arm->trouble(), "");
}

TEST_F(OpenHapticsArmTest, TheForceIsNoMoreThanTheArmBearsForGood) {
  far->limitContinuousForce(0.3);
  openAndPush();
  EXPECT_NEAR(test::forceOf(*far).norm(), 0.3, 4e-16);
  EXPECT_GT(test::forceOf(*far).x(), 0.29) << "its direction is kept";
}

TEST_F(OpenHapticsArmTest, WhereTheDriverHasNoLimitThePresetsHolds) {
  for (const double nonsense_N : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    far->limitContinuousForce(nonsense_N);
    openAndPush();
    EXPECT_NEAR(test::forceOf(*far).norm(), 0.88, 4e-16);
    close();
  }
}

TEST_F(OpenHapticsArmTest, AForceErrorIsAMomentOfZeroCountedAndSaid) {
  openAndPush();
  const std::uint32_t before = pusher->epoch;
  far->inject("hdEndFrame", 1, 0x203, Extent::Once);
  ASSERT_TRUE(comes([this] { return arm->forceErrors() == 1; }));
  ASSERT_TRUE(comes([&] { return pusher->epoch != before; })) << "it begins anew, softly";
  EXPECT_TRUE(contains(arm->trouble(), "moved faster")) << arm->trouble();
  EXPECT_TRUE(contains(arm->trouble(), "1 times so far")) << arm->trouble();
  EXPECT_TRUE(pushesSoon());
  EXPECT_TRUE(comes([this] { return arm->trouble().empty(); })) << arm->trouble();
}

TEST_F(OpenHapticsArmTest, AForceErrorThatLastsIsZeroThatLasts) {
  openAndPush();
  far->inject("hdGetIntegerv", 1, 0x200, Extent::Lasting);
  ASSERT_TRUE(restsSoon());
  for (int look = 0; look < 100; ++look) {
    ASSERT_TRUE(ticksOn(1));
    ASSERT_TRUE(rests());
  }
  EXPECT_TRUE(contains(arm->trouble(), "warm")) << arm->trouble();
}

TEST_F(OpenHapticsArmTest, ACutIsHeededByTheNextFrameAndEndsWithTheNextWrite) {
  open();
  arm::Sample sample;
  const safety::GatedForce force = wholeForce();
  ASSERT_TRUE(comes([&] {
    if (arm->read(sample)) arm->write(force);
    return pushes();
  }));
  arm->cut();
  EXPECT_TRUE(restsSoon());
  ASSERT_TRUE(comes([&] {
    if (arm->read(sample)) arm->write(force);
    return pushes();
  }));
}

TEST_F(OpenHapticsArmTest, WhoeverStopsWritingLetsGoWithinFivePeriods) {
  open();
  arm::Sample sample;
  ASSERT_TRUE(comes([&] {
    if (arm->read(sample)) arm->write(wholeForce());
    return pushes();
  }));
  const std::int64_t forces = far->pushingForces();
  ASSERT_TRUE(restsSoon());
  EXPECT_LE(far->pushingForces() - forces, 5 + 1) << "one may be on its way when they are counted";
}

TEST_F(OpenHapticsArmTest, APressBetweenTwoReadsIsNotLost) {
  open();
  arm::Sample sample;
  ASSERT_TRUE(comes([&] { return arm->read(sample); }));
  const auto passes = [this](std::int64_t frames) {
    const std::int64_t from = far->forces();
    return comes([&] { return far->forces() >= from + frames; });
  };
  far->holdButtons(2);
  ASSERT_TRUE(passes(3));
  far->holdButtons(0);
  ASSERT_TRUE(passes(3));
  ASSERT_TRUE(arm->read(sample));
  EXPECT_EQ(sample.buttons, 2U);
  ASSERT_TRUE(comes([&] { return arm->read(sample); }));
  EXPECT_EQ(sample.buttons, 0U);
}

TEST_F(OpenHapticsArmTest, TicksAtTheRatesThatItsDriverTakesAndSaysWhichTheseAre) {
  const Result<std::unique_ptr<OpenHapticsArm>> refused = tryToOpen(8000);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.problems().front().sentence,
            "The arm's driver supports 500, 1000, 1600, 2000, 4000 Hz, not 8000. Choose one of these rates.");
  open();
  EXPECT_EQ(arm->fixedRateReason(), "");
  EXPECT_TRUE(contains(arm->rateRefusal(300), "500, 1000"));
  servo::Host host(std::move(arm), servo::HostOptions{.max_late = 1'000'000});
  host.begin();
  EXPECT_FALSE(host.setRate(300).empty());
  ASSERT_TRUE(host.setRate(2000).empty());
  EXPECT_EQ(far->rate_hz(), 2000);
  const std::int64_t ticks = host.snapshot().ticks;
  EXPECT_TRUE(comes([&] { return host.snapshot().ticks > ticks + 20; }));
  EXPECT_EQ(host.scheduling().name, "by the arm's own clock");
}

TEST_F(OpenHapticsArmTest, ASecondOpeningIsRefusedAndLeavesTheFirstAlone) {
  openAndPush();
  const Result<std::unique_ptr<OpenHapticsArm>> second = tryToOpen(rate_hz);
  ASSERT_FALSE(second);
  EXPECT_TRUE(contains(second.problems().front().sentence, "already open")) << second.problems().front().sentence;
  EXPECT_TRUE(pushesSoon()) << arm->trouble();
  EXPECT_EQ(Scheduler::theOne().users(), 1);
}

TEST_F(OpenHapticsArmTest, NumbersKeepTheirPoint) {
  ASSERT_NE(std::setlocale(LC_NUMERIC, "C.UTF-8"), nullptr);
  open();
  EXPECT_STREQ(std::setlocale(LC_NUMERIC, nullptr), "C");
}

TEST_F(OpenHapticsArmTest, WhereItsClockStandsStillTheServoFaultsSaysSoAndComesBackAfterARestart) {
  open();
  servo::Host host(std::move(arm), servo::HostOptions{.max_late = 1'000'000});
  host.begin();
  host.start();
  ASSERT_TRUE(comes([&] { return host.snapshot().ticks > 20 && host.snapshot().mode == servo::Mode::Running; }));
  far->haltClock(true);
  ASSERT_TRUE(comes([&] { return host.snapshot().mode == servo::Mode::Faulted; }));
  EXPECT_TRUE(comes([&] { return contains(host.trouble(), "has stopped"); })) << host.trouble();
  far->haltClock(false);
  ASSERT_TRUE(host.restart().empty());
  host.start();
  EXPECT_TRUE(comes([&] { return host.snapshot().mode == servo::Mode::Running; }));
  EXPECT_EQ(host.trouble(), "");
}

TEST_F(OpenHapticsArmTest, ACallThatHangsIsSeenFromOutsideAndComesBack) {
  open();
  servo::Host host(std::move(arm), servo::HostOptions{.max_late = 1'000'000});
  host.begin();
  host.start();
  ASSERT_TRUE(comes([&] { return host.snapshot().mode == servo::Mode::Running; }));
  far->delay("hdEndFrame", 1, 400);
  ASSERT_TRUE(comes([&] { return host.snapshot().mode == servo::Mode::Faulted; }));
  ASSERT_TRUE(host.restart().empty()) << host.trouble();
  EXPECT_TRUE(restsSoon());
}

TEST_F(OpenHapticsArmTest, LatencyFromASampleToItsForceAtTheArmIsWithinAPeriod) {
  openAndPush();
  ASSERT_TRUE(ticksOn(500));
  const std::int64_t latency_ns = far->latency_ns();
  RecordProperty("median_latency_us", std::to_string(1e-3 * static_cast<double>(latency_ns)));
  EXPECT_GT(latency_ns, 0);
  EXPECT_LT(latency_ns, 1'000'000) << "the force answers the sample of its own frame";
}

}  // namespace underact::device::openhaptics
