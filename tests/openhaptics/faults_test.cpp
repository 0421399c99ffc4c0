// Each of the 36 calls fails, once and for good, while the arm is opened, while it pushes, and while it closes.
#include "tests/openhaptics/arm_fixture.h"
#include "tests/support/property.h"

namespace underact::device::openhaptics {
namespace {

using test::hd::Extent;

struct Row {
  const char* call;
  bool is_used;  // by the driver at all
};

// All that the library exports.
const std::vector<Row> kCalls{
    {"hdInitDevice", true},
    {"hdMakeCurrentDevice", true},
    {"hdGetCurrentDevice", true},
    {"hdDisableDevice", true},
    {"hdBeginFrame", true},
    {"hdEndFrame", true},
    {"hdGetError", true},
    {"hdGetErrorString", true},
    {"hdEnable", true},
    {"hdDisable", true},
    {"hdIsEnabled", true},
    {"hdGetBooleanv", true},
    {"hdGetIntegerv", true},
    {"hdGetFloatv", true},
    {"hdGetDoublev", true},
    {"hdGetLongv", true},
    {"hdGetString", true},
    {"hdSetBooleanv", false},
    {"hdSetIntegerv", false},
    {"hdSetFloatv", false},
    {"hdSetDoublev", true},
    {"hdSetLongv", false},
    {"hdCheckCalibration", true},
    {"hdCheckCalibrationStyle", true},
    {"hdUpdateCalibration", true},
    {"hdUpdateCalibrationMessage", false},
    {"hdScaleGimbalAngles", false},
    {"hdDeploymentLicense", false},
    {"hdStartScheduler", true},
    {"hdStopScheduler", true},
    {"hdSetSchedulerRate", true},
    {"hdScheduleSynchronous", false},
    {"hdScheduleAsynchronous", true},
    {"hdUnschedule", true},
    {"hdWaitForCompletion", false},
    {"hdGetSchedulerTimeStamp", false},
};

class EveryCall : public OpenHapticsArmTest, public testing::WithParamInterface<Row> {
 protected:
  EveryCall() { rate_hz = 4000; }  // what is waited for is counted in periods
  /// One of each kind; with a soak, all there are.
  static std::vector<std::uint32_t> codes() {
    if (test::sweep(0, 1) == 0) return {0x101, 0x203, 0x302, 0xABCD};
    return {0x100, 0x101, 0x102, 0x103, 0x104, 0x200, 0x201, 0x202, 0x203, 0x204, 0x300,
            0x301, 0x302, 0x303, 0x304, 0x400, 0x401, 0x402, 0x500, 0x501, 0x600, 0xABCD};
  }
  void expectRest(std::uint32_t code) {
    close();
    EXPECT_TRUE(rests()) << GetParam().call << std::hex << " 0x" << code;
    EXPECT_EQ(far->badForces(), 0);
    EXPECT_EQ(far->blindForces(), 0);
    far->reset();
  }
  /// What a fault has left behind does not last: the next opening is as the first. After a library that would not let
  /// the arm go, that takes a second attempt.
  void expectOk(std::uint32_t code) {
    Result<std::unique_ptr<OpenHapticsArm>> opened = tryToOpen(rate_hz);
    if (!opened) opened = tryToOpen(rate_hz);
    ASSERT_TRUE(opened) << GetParam().call << std::hex << " 0x" << code << ": " << opened.problems().front().sentence;
    arm = std::move(opened).value();
    drive();
    EXPECT_TRUE(pushesSoon()) << arm->trouble();
    close();
    EXPECT_TRUE(rests());
  }
};

}  // namespace

TEST_P(EveryCall, ThatFailsWhileTheArmIsOpenedIsAProblemOrIsBorne) {
  for (const std::uint32_t code : codes()) {
    for (const Extent extent : {Extent::Once, Extent::Lasting}) {
      far->inject(GetParam().call, 1, code, extent);
      Result<std::unique_ptr<OpenHapticsArm>> opened = tryToOpen(rate_hz);
      if (opened) {
        arm = std::move(opened).value();
      } else {
        EXPECT_TRUE(opened.problems().front().sentence.ends_with(".")) << opened.problems().front().sentence;
      }
      expectRest(code);
    }
    expectOk(code);
  }
}

TEST_P(EveryCall, ThatFailsWhileItPushesLeavesNoForceAndASentence) {
  for (const std::uint32_t code : codes()) {
    openAndPush();
    ASSERT_NE(arm, nullptr);
    const std::int64_t calls = far->calls(GetParam().call);
    far->inject(GetParam().call, 1, code, Extent::Lasting);
    ASSERT_TRUE(ticksOn(70)) << "more than lie between two looks at the calibration";
    if (far->calls(GetParam().call) > calls) {  // one of a frame
      EXPECT_TRUE(restsSoon()) << GetParam().call << std::hex << " 0x" << code << ": " << arm->trouble();
      EXPECT_TRUE(test::comes([this] { return !arm->trouble().empty(); })) << GetParam().call << std::hex << code;
    } else {
      EXPECT_TRUE(pushes()) << GetParam().call << " is not called in a frame";
      EXPECT_EQ(arm->trouble(), "");
    }
    expectRest(code);
  }
  expectOk(0);
}

TEST_P(EveryCall, ThatFailsOnceWhileItPushesIsOverAfterARestart) {
  for (const std::uint32_t code : codes()) {
    openAndPush();
    ASSERT_NE(arm, nullptr);
    far->inject(GetParam().call, 1, code, Extent::Once);
    ASSERT_TRUE(ticksOn(70));
    arm->endDrive();
    EXPECT_TRUE(restsSoon()) << GetParam().call << std::hex << " 0x" << code;
    Problems problems = arm->reopen();
    if (!problems.empty()) problems = arm->reopen();  // it may have been the reopening that failed
    ASSERT_TRUE(problems.empty()) << GetParam().call << std::hex << " 0x" << code << ": " << problems.front().sentence;
    drive();
    EXPECT_TRUE(pushesSoon()) << GetParam().call << std::hex << " 0x" << code << ": " << arm->trouble();
    expectRest(code);
  }
}

TEST_P(EveryCall, ThatFailsWhileTheArmIsClosedLeavesNoForce) {
  for (const std::uint32_t code : codes()) {
    openAndPush();
    ASSERT_NE(arm, nullptr);
    arm->endDrive();
    far->inject(GetParam().call, 1, code, Extent::Lasting);
    expectRest(code);
  }
  expectOk(0);
}

INSTANTIATE_TEST_SUITE_P(OfTheLibrary, EveryCall, testing::ValuesIn(kCalls),
                         [](const testing::TestParamInfo<Row>& row) { return std::string(row.param.call); });

TEST_F(OpenHapticsArmTest, TheTableOfCallsIsTheWholeOfThem) {
  EXPECT_EQ(kCalls.size(), 36U);
  far->needCalibration(0x5001, 2);
  openAndPush();
  close();
  far->inject("hdInitDevice", 1, 0x300, Extent::Lasting);
  EXPECT_FALSE(tryToOpen(rate_hz));
  for (const Row& row : kCalls) EXPECT_EQ(far->calls(row.call) > 0, row.is_used) << row.call;
}

}  // namespace underact::device::openhaptics
