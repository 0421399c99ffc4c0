#include "device/device_check.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

#include "core/arm/forward.h"
#include "core/base/units.h"
#include "underact/version.h"

namespace underact::device {
namespace {

constexpr std::size_t kJoints = 6;  // of every device

constexpr auto kBetweenTicks = std::chrono::milliseconds(20);  // between two polls

class Watch {
 public:
  explicit Watch(const arm::Preset& preset) : preset_(preset) {}
  void add(const servo::TickRecord& record, DeviceCheck& trial) {
    ++trial.ticks;
    if ((record.input & servo::kHadSample) == 0) {
      ++trial.without;
      return;
    }
    trial.buttons |= record.buttons;
    const Vec3 p_WT = arm::tipPose(preset_.geometry, record.q_rad).translation();
    if (!has_one_) {
      trial.min_rad = trial.largest_rad = last_rad_ = record.q_rad;
      trial.min_p_WT = trial.largest_p_WT = p_WT;
      has_one_ = true;
      return;
    }
    if (record.q_rad == last_rad_) ++trial.repeated;
    last_rad_ = record.q_rad;
    for (std::size_t joint = 0; joint < last_rad_.size(); ++joint) {
      trial.min_rad[joint] = std::min(trial.min_rad[joint], record.q_rad[joint]);
      trial.largest_rad[joint] = std::max(trial.largest_rad[joint], record.q_rad[joint]);
    }
    trial.min_p_WT = trial.min_p_WT.cwiseMin(p_WT);
    trial.largest_p_WT = trial.largest_p_WT.cwiseMax(p_WT);
  }

 private:
  const arm::Preset& preset_;
  arm::JointAngles last_rad_{};
  bool has_one_ = false;
};

template <class... Value>
std::string line(const char* format, Value... value) {
  char text[200];
  std::snprintf(text, sizeof text, format, value...);
  return std::string(text) + "\n";
}

std::string movedText(const DeviceCheck& trial) {
  std::string text;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    text += line("Joint %d: %.2f to %.2f degrees", static_cast<int>(joint) + 1, trial.min_rad[joint] / kRadPerDegree,
                 trial.largest_rad[joint] / kRadPerDegree);
  }
  for (int axis = 0; axis < 3; ++axis) {
    text += line("Tip, %c: %.2f to %.2f mm", 'x' + axis, trial.min_p_WT[axis] * kMillimetrePerMetre,
                 trial.largest_p_WT[axis] * kMillimetrePerMetre);
  }
  return text;
}

}  // namespace

DeviceCheck checkDevice(std::unique_ptr<servo::DevicePort> arm, const arm::Preset& preset, int rate_hz, double seconds,
                        const std::function<bool()>& goes_on) {
  DeviceCheck trial;
  trial.info = arm->info();
  trial.rate_hz = rate_hz;
  servo::DevicePort& port = *arm;
  servo::Host host(std::move(arm), {.rate_hz = rate_hz});
  host.begin();
  Watch watch(preset);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < end && goes_on()) {
    std::this_thread::sleep_for(kBetweenTicks);
    host.drain([&](const servo::TickRecord& record) { watch.add(record, trial); });
  }
  trial.lateness = host.timing().lateness();
  trial.scheduling = host.scheduling().name;
  trial.listing = port.listing();
  trial.trouble = host.trouble();
  return trial;
}

std::string reportText(const DeviceCheck& trial, std::string_view name, std::string_view words) {
  std::string text = "Report on an arm, Underact " + std::string(kVersion) + "\n";
  text += "Arm: " + std::string(name) + ", " + trial.info.title + "\n";
  text += trial.info.untested ? "Not yet tested on hardware.\n" : "";
  text += "Remarks: " + (words.empty() ? "nothing" : std::string(words)) + "\n\n";
  text += line("Requested rate: %d Hz, scheduling: %s", trial.rate_hz, trial.scheduling.c_str());
  text += line("Ticks: %lld, without a sample: %lld, repeated: %lld", static_cast<long long>(trial.ticks),
               static_cast<long long>(trial.without), static_cast<long long>(trial.repeated));
  text += line("Latency: p50 %.0f, p99 %.0f, largest %.0f us", trial.lateness.p50_us, trial.lateness.p99_us,
               trial.lateness.max_us);
  text += movedText(trial);
  text += line("Buttons pressed: 0x%x", trial.buttons);
  text += "Trouble: " + (trial.trouble.empty() ? "none" : trial.trouble) + "\n";
  if (!trial.listing.empty()) text += "\nWhat the arm reports about itself:\n";
  for (const std::string& one : trial.listing) text += one + "\n";
  text += "\nNo force was sent. The serial numbers above identify the arm: leave them out if you wish.\n";
  return text;
}

}  // namespace underact::device
