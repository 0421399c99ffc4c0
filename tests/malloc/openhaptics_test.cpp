#include <gtest/gtest.h>

#include <cstdint>

#include "core/arm/preset.h"
#include "device/openhaptics/frames.h"
#include "tests/malloc/counter.h"

namespace underact::device::openhaptics {
namespace {

// A library without a word of its own: an arm at rest, and now and then an error.
std::int64_t questions = 0;

Calls quietLibrary() {
  Calls hd;
  hd.hdBeginFrame = [](Handle) {};
  hd.hdEndFrame = [](Handle) {};
  hd.hdEnable = [](std::uint32_t) {};
  hd.hdDisable = [](std::uint32_t) {};
  hd.hdGetError = [] { return ErrorInfo{++questions % 997 == 0 ? 0x203U : 0U, 0, 0}; };
  hd.hdGetBooleanv = [](std::uint32_t, std::uint8_t* values) { values[0] = questions % 7 == 0 ? 0 : 1; };
  hd.hdGetIntegerv = [](std::uint32_t, std::int32_t* values) { values[0] = 4; };
  hd.hdGetFloatv = [](std::uint32_t, float* values) { values[0] = 1.0F; };
  hd.hdGetLongv = [](std::uint32_t, long* values) { values[0] = 1; };
  hd.hdGetString = [](std::uint32_t) -> const char* { return "a name that is too long to be kept without the heap"; };
  hd.hdGetDoublev = [](std::uint32_t parameter, double* values) {
    for (int i = 0; i < (parameter == kTransform ? 16 : 6); ++i) values[i] = questions % 101 == 0 ? 1e300 : 0.1;
  };
  hd.hdSetDoublev = [](std::uint32_t, const double*) {};
  hd.hdCheckCalibration = []() -> std::uint32_t { return questions % 5 == 0 ? kCalibrationNeedsUpdate : kCalibrated; };
  hd.hdCheckCalibrationStyle = []() -> std::uint32_t { return kInkwell; };
  hd.hdUpdateCalibration = [](std::uint32_t) {};
  return hd;
}

class Reader final : public servo::Ticks {
 public:
  explicit Reader(Exchange& exchange) : exchange_(exchange) {}
  void tick() noexcept override {
    arm::Sample sample;
    if (exchange_.read(sample)) exchange_.write(Vec3(0.5, 0.0, 0.0));
    exchange_.cut();
  }

 private:
  Exchange& exchange_;
};

}  // namespace

TEST(OpenHapticsFrames, AllocateFreeAndLockNothingOnceTheArmIsKnown) {
  const Calls hd = quietLibrary();
  Frames frames(hd, *arm::findPreset(arm::kDefaultArm));
  Reader reader(frames.exchange());
  Ticket* const ticket = frames.begin(1);
  frames.attach(&reader);
  (void)Frames::callback(ticket);
  ASSERT_NE(frames.capabilities(), nullptr);
  {
    test::Watch watch;
    for (int frame = 0; frame < 5000; ++frame) (void)Frames::callback(ticket);
    frames.armStatus().stop(0x302);
    for (int frame = 0; frame < 100; ++frame) (void)Frames::callback(ticket);
    EXPECT_EQ(watch.allocations(), 0);
    EXPECT_EQ(watch.frees(), 0);
    EXPECT_EQ(watch.locks(), 0);
  }
  EXPECT_GT(frames.armStatus().forceErrors(), 1);
  frames.attach(nullptr);
  EXPECT_TRUE(frames.retire());
  EXPECT_EQ(Frames::callback(ticket), kCallbackDone) << "a library that calls once more touches nothing";
}

}  // namespace underact::device::openhaptics
