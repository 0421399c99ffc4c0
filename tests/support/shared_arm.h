#pragma once
#include <gtest/gtest.h>

#include <mutex>
#include <string>
#include <vector>

#include "device/remote/remote_arm.h"
#include "device/remote/share.h"
#include "tests/support/arm_double.h"
#include "tests/support/cable.h"
#include "tests/support/scratch_folder.h"

namespace underact::test {

/// An arm that is shared, the network to it, and the keys of both ends, which are another one's each.
class SharedArm {
 public:
  explicit SharedArm(bool allows_force = true, bool is_passive = true)
      : sharer_(KeyFolder(scratch_.path() + "/sharer").own().value()),
        client_(KeyFolder(scratch_.path() + "/client").own().value()) {
    options_ = {{"127.0.0.1", 0}, sharer_, {client_.public_key}, arm.preset(), 1000, allows_force, is_passive};
    share();
    cable_ = std::make_unique<Cable>(share_->address().port);
  }
  /// Anew at the same port, as when the sharing program was started again.
  void share() {
    auto shared = device::remote::Share::open(std::make_unique<ArmDouble::Port>(arm), options_,
                                              [this](const std::string& sentence) { hear(sentence); });
    EXPECT_TRUE(shared) << shared.problems().front().sentence;
    share_ = std::move(shared).value();
    options_.listen = share_->address();
  }
  void end() { share_.reset(); }
  /// Over the cable; or, straight, without.
  device::remote::Endpoint endpoint(bool straight = false) const {
    const int port = straight ? share_->address().port : cable_->port();
    return {{device::remote::kThisMachine, port}, sharer_.public_key, client_};
  }
  Result<std::unique_ptr<device::remote::RemoteArm>> open(const char* preset = nullptr, int rate_hz = 1000,
                                                          bool straight = false) const {
    const arm::Preset& wanted = preset != nullptr ? *arm::findPreset(preset) : arm.preset();
    return device::remote::RemoteArm::open(endpoint(straight), wanted, rate_hz);
  }
  Cable& cable() { return *cable_; }
  device::remote::KeyPair stranger() const { return KeyFolder(scratch_.path() + "/stranger").own().value(); }
  /// All that was told people, a line each.
  std::string told() const {
    const std::scoped_lock lock(mutex_);
    return told_;
  }

  ArmDouble arm;

 private:
  using KeyFolder = device::remote::KeyFolder;
  void hear(const std::string& sentence) {
    const std::scoped_lock lock(mutex_);
    told_ += sentence + "\n";
  }

  ScratchFolder scratch_;
  device::remote::KeyPair sharer_, client_;
  device::remote::ShareOptions options_;
  mutable std::mutex mutex_;
  std::string told_;
  std::unique_ptr<device::remote::Share> share_;
  std::unique_ptr<Cable> cable_;
};

}  // namespace underact::test
