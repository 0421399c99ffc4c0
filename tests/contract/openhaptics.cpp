#include "core/arm/preset.h"
#include "device/openhaptics/openhaptics_arm.h"
#include "tests/contract/drivers.h"
#include "tests/openhaptics/stand_in.h"

namespace underact::test {
namespace {

/// A library that speaks as the vendor's does, with a simulated arm on its cable.
class OpenHapticsFarSide final : public FarSide {
 public:
  explicit OpenHapticsFarSide(hd::Control& library) : library_(library) { library_.reset(); }
  Result<std::unique_ptr<servo::DevicePort>> open() override {
    using device::openhaptics::OpenHapticsArm;
    Result<std::unique_ptr<OpenHapticsArm>> arm = OpenHapticsArm::open({*arm::findPreset(arm::kDefaultArm), 1000, ""});
    if (!arm) return arm.problems();
    return std::unique_ptr<servo::DevicePort>(std::move(arm).value());
  }
  Vec3 force_N() const override { return forceOf(library_); }
  std::int64_t forces() const override { return library_.forces(); }
  void placeTip(const Vec3& p_WT) override { library_.placeTip(p_WT.x(), p_WT.y(), p_WT.z()); }
  void holdButton(bool held) override { library_.holdButtons(held ? 1 : 0); }
  void unplug() override { library_.plug(false); }
  void plugIn() override { library_.plug(true); }
  void freeze(bool on) override { library_.freeze(on); }

 private:
  hd::Control& library_;
};

}  // namespace

std::unique_ptr<FarSide> openHapticsFarSide(std::string& why) {
  hd::Control* const library = standIn();
  if (library != nullptr) return std::make_unique<OpenHapticsFarSide>(*library);
  why = "the stand-in for the vendor's library cannot be loaded";
  return nullptr;
}

}  // namespace underact::test
