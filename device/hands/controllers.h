#pragma once
#include "device/hands/port.h"

namespace underact::device::hands {

/// Game controllers and joysticks through GLFW, which knows one screen: where it finds none, trouble() says so. GLFW
/// starts with the first look(). One at a time, the main thread's from its first day to its last.
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
