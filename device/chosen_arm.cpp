#include "device/chosen_arm.h"

#include <utility>

namespace underact::device {

ChosenArm::ChosenArm(std::unique_ptr<servo::DevicePort> first) : first_(std::move(first)), arm_(first_.get()) {}

void ChosenArm::choose(std::unique_ptr<servo::DevicePort> arm) {
  next_ = std::move(arm);
  is_chosen_ = true;
}

Problems ChosenArm::reopen() {
  if (!std::exchange(is_chosen_, false)) return arm_->reopen();
  arm_ = first_.get();  // before the other one is closed
  other_ = std::move(next_);
  if (other_ != nullptr) arm_ = other_.get();
  is_new_ = true;
  return {};
}

// Whichever is in place: the first one is asked as well, since it may return.
void ChosenArm::setRate(int rate_hz) {
  first_->setRate(rate_hz);
  if (other_ != nullptr) other_->setRate(rate_hz);
}

bool ChosenArm::read(arm::Sample& sample) noexcept {
  constexpr std::int64_t kOn_ns = 1'000'000;  // how far the clock advances from one arm to the next
  if (!arm_->read(sample)) return false;
  if (is_new_) ahead_ns_ = time_ns_ + kOn_ns - sample.time_ns;
  if (is_new_ || sample.epoch != own_epoch_) ++epoch_;
  is_new_ = false;
  own_epoch_ = sample.epoch;
  sample.epoch = epoch_;
  sample.time_ns += ahead_ns_;
  time_ns_ = sample.time_ns;
  return true;
}

}  // namespace underact::device
