#include "core/arm/preset.h"
#include "device/haply/haply_arm.h"
#include "tests/contract/drivers.h"
#include "tests/support/haply_service.h"

namespace underact::test {
namespace {

/// An Inverse3 behind a service of the tests' own. Unplugged is the arm itself, or, of v3.1, the service that ends.
class HaplyFarSide final : public FarSide {
 public:
  explicit HaplyFarSide(const HaplyService::Options& options) : service_(options), stops_(options.version < "3.5") {}
  Result<std::unique_ptr<servo::DevicePort>> open() override {
    Result<std::unique_ptr<device::haply::HaplyArm>> arm = device::haply::HaplyArm::open(
        {"127.0.0.1", service_.port()}, arm::findPreset(arm::kDefaultArm)->geometry, 1000);
    if (!arm) return arm.problems();
    return std::unique_ptr<servo::DevicePort>(std::move(arm).value());
  }
  Vec3 force_N() const override { return service_.force_N(); }
  std::int64_t forces() const override { return service_.forces(); }
  void placeTip(const Vec3& p_WT) override { service_.placeTip(p_WT); }
  void holdButton(bool held) override { service_.holdButton(held); }
  void unplug() override { stops_ ? service_.stop() : service_.unplugArm(true); }
  void plugIn() override { stops_ ? service_.start() : service_.unplugArm(false); }
  void freeze(bool on) override { service_.freeze(on); }

 private:
  HaplyService service_;
  bool stops_;
};

}  // namespace

std::unique_ptr<FarSide> haplyFarSide(std::string& /*why*/) {
  return std::make_unique<HaplyFarSide>(HaplyService::Options{});
}

std::unique_ptr<FarSide> haplyOldFarSide(std::string& /*why*/) {
  HaplyService::Options options;
  options.version = "3.1.0";
  return std::make_unique<HaplyFarSide>(options);
}

}  // namespace underact::test
