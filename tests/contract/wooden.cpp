#include "core/system/clock.h"
#include "device/wooden_haptics/wooden_arm.h"
#include "tests/contract/drivers.h"
#include "tests/support/hid_double.h"

namespace underact::test {
namespace {

/// A WoodenHaptics arm whose HID reports go to a board of the tests' own.
class WoodenFarSide final : public FarSide {
 public:
  explicit WoodenFarSide(const WoodenFirmware::Built& built) : firmware_(built), bus_(firmware_) {}
  Result<std::unique_ptr<servo::DevicePort>> open() override {
    Result<std::unique_ptr<device::WoodenArm>> arm =
        device::WoodenArm::open(bus_, {}, arm::findPreset(arm::kDefaultArm)->geometry, 1000);
    if (!arm) return arm.problems();
    return std::unique_ptr<servo::DevicePort>(std::move(arm).value());
  }
  Vec3 force_N() const override { return firmware_.force_N(system::monotonicNow_ns()); }
  std::int64_t forces() const override { return firmware_.currentsTaken(); }
  void placeTip(const Vec3& p_WT) override { firmware_.placeTip(p_WT); }
  bool hasButton() const override { return firmware_.onlyAnswers(); }  // protocol 1 has none
  void holdButton(bool held) override { firmware_.holdButton(held); }
  void unplug() override { bus_.unplug(); }
  void plugIn() override { bus_.plugIn(); }
  void freeze(bool on) override { firmware_.freeze(on); }
  double ownWatchdog_s() const override { return 0.5; }
  // Half a step of each of its encoders, at 0.22 to 0.31 m, and one step of tremor: 0.08, 0.03 and 0.04 mm.
  double resolution_m() const override { return 1e-4; }
  // Half a mA of each motor: with 0.321 N m/A 2.6e-3 N m about the upright, at 0.28 m; far less of the others.
  double forceResolution_N() const override { return 0.02; }

 private:
  WoodenFirmware firmware_;
  HidDouble bus_;
};

}  // namespace

std::unique_ptr<FarSide> woodenV1FarSide(std::string& /*why*/) {
  return std::make_unique<WoodenFarSide>(WoodenFirmware::Built{});
}

std::unique_ptr<FarSide> woodenV2FarSide(std::string& /*why*/) {
  return std::make_unique<WoodenFarSide>(WoodenFirmware::Built{2, 14, {0.321, 0.0603, 0.0603}});
}

std::unique_ptr<FarSide> woodenTeensyFarSide(std::string& /*why*/) {
  return std::make_unique<WoodenFarSide>(WoodenFirmware::Built{2, 64, {0.321, 0.0603, 0.0603}});
}

}  // namespace underact::test
