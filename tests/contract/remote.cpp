#include "tests/contract/drivers.h"
#include "tests/support/shared_arm.h"

namespace underact::test {
namespace {

/// An arm of another program, behind a network whose plug can be pulled: forces and samples are those of the arm there.
class RemoteFarSide final : public FarSide {
 public:
  Result<std::unique_ptr<servo::DevicePort>> open() override {
    Result<std::unique_ptr<device::remote::RemoteArm>> arm = shared_.open();
    if (!arm) return arm.problems();
    return std::unique_ptr<servo::DevicePort>(std::move(arm).value());
  }
  Vec3 force_N() const override { return shared_.arm.force_N(); }
  // The sharing program goes on telling the arm zero: those that push are what must end.
  std::int64_t forces() const override { return shared_.arm.pushes(); }
  // A message that is read late is heard for its own periods again; what these are, tests of ArmSide count by hand.
  std::int64_t unreadForces() const override { return 5; }
  void placeTip(const Vec3& p_WT) override { shared_.arm.placeTip(p_WT); }
  void holdButton(bool held) override { shared_.arm.holdButton(held); }
  void unplug() override { shared_.cable().pull(); }
  void plugIn() override { shared_.cable().plug(); }
  void freeze(bool on) override { shared_.arm.freeze(on); }

 private:
  SharedArm shared_;
};

}  // namespace

std::unique_ptr<FarSide> remoteFarSide(std::string& /*why*/) {
  return std::make_unique<RemoteFarSide>();
}

}  // namespace underact::test
