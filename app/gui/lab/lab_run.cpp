#include "app/gui/lab/lab_run.h"

#include "core/sim/hand_script.h"

namespace underact::gui {
namespace {

constexpr std::uint64_t kSeed = 1;      // of the hands: the same results each time
constexpr double kShareOfPoints = 0.5;  // of the time: a third of it for a circle, three quarters for a curve

}  // namespace

LabResult measureLab(const LabOrder& order, WorkState& state) {
  const auto part = [&state](double from, double length) {
    return [&state, from, length](double share) {
      state.share = from + length * share;
      return !state.cancelled;
    };
  };
  LabResult result;
  result.points =
      tradeoff::measurePoints(order.scene, order.hands, order.seconds, order.rate_hz, part(0.0, kShareOfPoints));
  if (state.cancelled) return result;
  result.choice_results = tradeoff::measureChoices(order.scene, order.hands, order.seconds, order.rate_hz,
                                                   part(kShareOfPoints, 1.0 - kShareOfPoints));
  return result;
}

std::vector<tradeoff::NamedHand> handsOf(const std::string& name) {
  std::vector<tradeoff::NamedHand> hands;
  for (const sim::BuiltInHand& one : sim::builtInHands()) {
    if (!name.empty() && name != one.name) continue;
    hands.push_back({one.name, sim::builtInHand(one.name, kSeed).value()});
  }
  return hands;
}

}  // namespace underact::gui
