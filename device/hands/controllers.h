#pragma once
#include "device/hands/port.h"

namespace underact::device::hands {

/// Game controllers and joysticks through GLFW, which supports one display: if it finds none, trouble() says so. GLFW
/// starts with the first look(). One instance at a time, used by the main thread only.
class Controllers final : public Port {
 public:
  Controllers() = default;
  ~Controllers() override;
  std::vector<Seen> look() override;
  Sentence trouble() const override { return trouble_; }

 private:
  bool begin();
  bool has_begun_ = false, works_ = false;
  Sentence trouble_;
};

}  // namespace underact::device::hands
