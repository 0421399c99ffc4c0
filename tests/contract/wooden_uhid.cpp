#include "core/system/clock.h"
#include "device/catalogue.h"
#include "tests/contract/drivers.h"
#include "tests/support/uhid_board.h"

namespace underact::test {
namespace {

/// A WoodenHaptics arm behind the kernel: the driver as the program opens it, hidapi, /dev/hidraw. See tests/vm.
class WoodenUhidFarSide final : public FarSide {
 public:
  explicit WoodenUhidFarSide(const WoodenFirmware::Built& built) : firmware_(built), board_(firmware_) {
    board_.plugIn();
  }
  Result<std::unique_ptr<servo::DevicePort>> open() override {
    device::Request request;
    request.arm = *arm::findPreset(arm::kDefaultArm);
    return device::openDevice("wooden:0042", request);
  }
  Vec3 force_N() const override { return firmware_.force_N(system::monotonicNow_ns()); }
  std::int64_t forces() const override { return firmware_.currentsTaken(); }
  void placeTip(const Vec3& p_WT) override { firmware_.placeTip(p_WT); }
  bool hasButton() const override { return firmware_.onlyAnswers(); }
  void holdButton(bool held) override { firmware_.holdButton(held); }
  void unplug() override { board_.unplug(); }
  void plugIn() override { board_.plugIn(); }
  void freeze(bool on) override { firmware_.freeze(on); }
  double ownWatchdog_s() const override { return 0.5; }
  double resolution_m() const override { return 1e-4; }  // as in wooden.cpp
  double forceResolution_N() const override { return 0.02; }

 private:
  WoodenFirmware firmware_;
  UhidBoard board_;
};

std::unique_ptr<FarSide> makeIn(const WoodenFirmware::Built& built, std::string& why) {
  if (!UhidBoard::isPossible()) {
    why = "/dev/uhid cannot be opened";
    return nullptr;
  }
  return std::make_unique<WoodenUhidFarSide>(built);
}

}  // namespace

std::unique_ptr<FarSide> woodenUhidV1FarSide(std::string& why) {
  return makeIn({}, why);
}

std::unique_ptr<FarSide> woodenUhidV2FarSide(std::string& why) {
  return makeIn({2, 14, {0.321, 0.0603, 0.0603}}, why);
}

}  // namespace underact::test
