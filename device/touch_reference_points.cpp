#include "device/touch_reference_points.h"

#include <chrono>
#include <thread>
#include <utility>

#include "core/arm/forward.h"
#include "core/registration/touching.h"
#include "core/servo/host.h"

namespace underact::device {
namespace {

using registration::Touching;

constexpr auto kBetweenLooks = std::chrono::milliseconds(20);  // between two polls

std::string asked(const Touching& touching) {
  return "Rest the tip on reference point " + std::to_string(touching.due() + 1) + " of " +
         std::to_string(touching.points_D().size()) + ", press the stylus button nearer to the tip, and hold still.";
}

/// The outcome of a tick as a sentence; empty: nothing.
std::string wordsOf(Touching::Event event, const Touching& touching) {
  if (event == Touching::Event::Moved) return "The tip moved by more than 1 mm while it was held. " + asked(touching);
  if (event != Touching::Event::Touched) return {};
  return touching.isDone() ? "All reference points have been touched." : "Touched. " + asked(touching);
}

}  // namespace

Result<std::vector<registration::Touch>> touchReferencePoints(std::unique_ptr<servo::DevicePort> port,
                                                              const arm::Preset& preset, int rate_hz,
                                                              const std::vector<Vec3>& points_D,
                                                              const TouchPrompts& talk) {
  using Clock = std::chrono::steady_clock;
  const std::chrono::duration<double> wait(talk.wait_s);
  servo::Host host(std::move(port), {.rate_hz = rate_hz});
  host.begin();
  Touching touching(points_D);
  auto last = Clock::now();
  talk.say(asked(touching));
  while (!touching.isDone()) {
    if (!talk.goes_on()) return Problems{{"It ended before all reference points were touched.", {}}};
    if (Clock::now() - last > wait) {
      const std::string trouble = host.trouble();
      return Problems{{"Nobody pressed the stylus button at reference point " + std::to_string(touching.due() + 1) +
                           ". " + (trouble.empty() ? "Begin again, with a person at the arm." : trouble),
                       {}}};
    }
    std::this_thread::sleep_for(kBetweenLooks);
    host.drain([&](const servo::TickRecord& record) {
      if ((record.input & servo::kHadSample) == 0) return;
      const Vec3 p_WT = arm::tipPosition(preset.geometry, record.q_rad);
      const std::string words = wordsOf(touching.add(record.time_ns, p_WT, (record.buttons & 1U) != 0), touching);
      if (words.empty()) return;
      talk.say(words);
      last = Clock::now();
    });
  }
  return touching.touches();
}

}  // namespace underact::device
