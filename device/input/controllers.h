#pragma once
#include "device/input/device_enumerator.h"

namespace underact::device::input {

/// Game controllers and joysticks through GLFW, which supports one display: if it finds none, trouble() says so. GLFW
/// starts with the first poll(). One instance at a time, used by the main thread only.
class Controllers final : public DeviceEnumerator {
 public:
  Controllers() = default;
  ~Controllers() override;
  std::vector<DeviceState> poll() override;
  Sentence trouble() const override { return trouble_; }

 private:
  bool begin();
  bool has_begun_ = false, works_ = false;
  Sentence trouble_;
};

}  // namespace underact::device::input
