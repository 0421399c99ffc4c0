#include <array>
#include <utility>

#include "core/arm/forward.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/sim/hand_script.h"

namespace underact::sim {
namespace {

// The shapes of the shipped scenes are around the origin of W, 40 to 50 mm wide; the hands are made for them, and stay
// within reach and joint limits of every arm (hand_script_test).
constexpr double kTremor_m = 0.5e-3;

struct Stop {
  double t_s, x_mm, y_mm, z_mm;
};

HandScript along(std::initializer_list<Stop> stops, double repeat_s) {
  HandScript script;
  for (const Stop& stop : stops) {
    HandPoint point;
    point.t_s = stop.t_s;
    point.p_WT = kMetrePerMillimetre * Vec3(stop.x_mm, stop.y_mm, stop.z_mm);
    script.path.push_back(point);
  }
  script.repeat_s = repeat_s;
  script.about_middle = true;
  return script;
}

HandScript still() {
  return along({{0.0, 0, 0, 60}, {1.0, 35, 25, 20}}, 0.0);
}

HandScript sweep() {
  return along({{0.0, 0, 0, 60},
                {2.0, 45, 15, 25},
                {4.0, 5, 45, -10},
                {6.0, -45, 10, 20},
                {8.5, 40, -15, -25},  // past the origin at 4 mm
                {10.5, 5, -45, 20},
                {13.0, -25, 35, -30},  // past it again, on the other side
                {16.0, 0, 0, 60}},
               16.0);
}

/// To 12 mm from the origin and back, along each half axis; never from one to the opposite one, which would pass
/// through the origin, where a sphere has no nearest point.
HandScript probe() {
  return along({{0, 0, 0, 60},
                {1, 0, 0, 12},
                {2, 0, 0, 60},
                {3, 0, -60, 0},
                {4, 0, -12, 0},
                {5, 0, -60, 0},
                {6, 0, 0, -60},
                {7, 0, 0, -12},
                {8, 0, 0, -60},
                {9, 60, 0, 0},
                {10, 12, 0, 0},
                {11, 60, 0, 0},
                {12, 0, 60, 0},
                {13, 0, 12, 0},
                {14, 0, 60, 0},
                {15, -60, 0, 0},
                {16, -12, 0, 0},
                {17, -60, 0, 0},
                {18, 0, 0, 60}},
               18.0);
}

HandScript tremor() {
  HandScript script = still();
  script.tremor_m = kTremor_m;
  return script;
}

/// From 80 mm to 20 mm of the origin in 0.1125 s: the profile's peak is 15/8 of the mean, 1 m/s.
HandScript stab() {
  return along({{0.0, 0, 0, 80},
                {0.4, 0, 0, 80},
                {0.5125, 0, 0, 20},
                {0.625, 0, 0, 80},
                {1.0, 48, 0, 64},
                {1.4, 48, 0, 64},
                {1.5125, 12, 0, 16},
                {1.625, 48, 0, 64},
                {2.0, 0, 48, 64},
                {2.4, 0, 48, 64},
                {2.5125, 0, 12, 16},
                {2.625, 0, 48, 64},
                {3.0, 0, 0, 80}},
               3.0);
}

struct Row {
  BuiltInHand hand;
  HandScript (*make)();
};

constexpr std::array<Row, 5> kRows{
    Row{{"still", "Moves near the surface of the shipped shapes in a second and holds there."}, still},
    Row{{"sweep", "Tours the workspace slowly, past the origin, in 16 s, and starts again."}, sweep},
    Row{{"probe", "Presses slowly towards the origin and back along each half axis, in 18 s, and starts again."},
        probe},
    Row{{"tremor", "Holds as still does, with a tremor of half a millimetre at 8 to 11 Hz."}, tremor},
    Row{{"stab",
         "Plunges at 1 m/s through the surface of a 50 mm sphere and out, three ways in 3 s, and starts again."},
        stab}};

}  // namespace

std::span<const BuiltInHand> builtInHands() {
  static const std::array<BuiltInHand, kRows.size()> kHands = [] {
    std::array<BuiltInHand, kRows.size()> hands{};
    for (std::size_t row = 0; row < kRows.size(); ++row) hands[row] = kRows[row].hand;
    return hands;
  }();
  return kHands;
}

HandScript madeFor(const arm::Preset& arm, HandScript script) {
  if (!std::exchange(script.about_middle, false)) return script;
  for (HandPoint& point : script.path) point.p_WT += arm::workspaceMiddle(arm.geometry);
  return script;
}

Result<HandScript> builtInHand(std::string_view name, std::uint64_t seed) {
  std::string names;
  for (const Row& row : kRows) {
    if (name == row.hand.name) {
      HandScript script = row.make();
      script.seed = seed;
      return script;
    }
    names += (names.empty() ? "" : ", ") + std::string(row.hand.name);
  }
  return Problems{
      {phrase(TRANSLATE_NOOP("problem", "There is no hand \"%1\". Hands: %2."), {std::string(name), names})}};
}

}  // namespace underact::sim
