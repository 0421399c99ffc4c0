#include "core/stability/maps.h"

#include <array>

#include "core/base/units.h"
#include "core/stability/exact.h"

namespace underact::stability {
namespace {

template <class Change>
Variant variant(std::string name, Change change) {
  Variant made{std::move(name), {}};
  change(made.wall);
  return made;
}

/// The wall with such a hand, besides the arm's own mass and damping.
Variant held(std::string name, const sim::HandModel& hand) {
  return variant(std::move(name), [&](SampledWall& wall) {
    wall.mass_kg += hand.mass_kg;
    wall.damping_N_s_per_m += hand.damping_N_s_per_m;
    wall.hand_stiffness_N_per_m = hand.stiffness_N_per_m;
  });
}

std::vector<Variant> rates() {
  std::vector<Variant> made;
  for (const int rate_hz : {250, 500, 1000, 2000, 4000, 10'000}) {
    made.push_back(
        variant(std::to_string(rate_hz) + " Hz", [&](SampledWall& wall) { wall.period_ns = 1'000'000'000 / rate_hz; }));
  }
  return made;
}

std::vector<Variant> delays() {
  std::vector<Variant> made;
  for (const int ticks : {0, 1, 2, 4, 8}) {
    made.push_back(variant(std::to_string(ticks) + (ticks == 1 ? " tick" : " ticks"),
                           [&](SampledWall& wall) { wall.delay_ticks = ticks; }));
  }
  return made;
}

std::vector<Variant> filters() {
  const auto by = [](std::string name, control::Velocity velocity) {
    return variant(std::move(name), [&](SampledWall& wall) { wall.velocity = velocity; });
  };
  const scene::AdaptiveWindowFilter adaptive;
  const Vec3 noise_m = Vec3::Constant(kMetrePerMillimetre * adaptive.noise_mm);
  return {by("raw", control::RawDifference{}), by("low-pass 1.6 ms", control::LowPass{}),
          by("low-pass 5 ms", control::LowPass{5e-3}),
          by("window of 8", control::AdaptiveWindow{static_cast<int>(adaptive.window), noise_m}),
          by("Kalman", defaultKalman())};
}

std::vector<Variant> steps() {
  std::vector<Variant> made;
  for (const int times : {0, 1, 2, 4}) {
    const std::string name = times == 0   ? "exact angles"
                             : times == 1 ? "the arm's steps"
                                          : std::to_string(times) + " times as coarse";
    made.push_back(variant(name, [&](SampledWall& wall) { wall.coarseness = times; }));
  }
  return made;
}

std::vector<Variant> frictions() {
  std::vector<Variant> made;
  for (const char* text : {"0", "0.05", "0.13", "0.26", "0.5"})
    made.push_back(variant(std::string(text) + " N", [&](SampledWall& wall) { wall.friction_N = std::stod(text); }));
  return made;
}

}  // namespace

std::span<const WallMap> wallMaps() {
  static const std::array<WallMap, 6> kMaps{{
      {"rate", "Rate of the servo", rates()},
      {"delay", "Delay", delays()},
      {"hand",
       "Hand",
       {held("no hand", {0.0, 0.0, 0.0}), held("demo hand", {}), held("literature's arm", {0.554, 6.45, 135.0})}},
      {"filter", "Velocity filter", filters()},
      {"quantization", "Steps of the encoders", steps()},
      {"friction", "Friction of the arm", frictions()},
  }};
  return kMaps;
}

std::span<const double> mapDampings_N_s_per_m() {
  static constexpr std::array<double, 11> kDampings{0.0, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0};
  return kDampings;
}

std::span<const double> mapStiffnesses_N_per_m() {
  static constexpr std::array<double, 16> kStiffnesses{20.0,   35.0,   60.0,   100.0, 200.0, 350.0, 600.0, 1000.0,
                                                       2000.0, 3500.0, 6000.0, 1e4,   2e4,   3.5e4, 6e4,   1e5};
  return kStiffnesses;
}

Limits limitsOf(const SampledWall& wall) {
  return {simulatedLimit(wall), exactLimit(wall), passiveLimit(wall), colgateSchenkel(wall), gilHulin(wall)};
}

Label labelOf(const SampledWall& wall, const Limits& limits, double stiffness_N_per_m) {
  return {tryWall(wall, stiffness_N_per_m), stiffness_N_per_m <= limits.passive_N_per_m};
}

std::span<const int> sceneRates_hz() {
  static constexpr std::array<int, 4> kRates{500, 1000, 2000, 4000};
  return kRates;
}

std::span<const double> sceneStiffnesses_N_per_m() {
  static constexpr std::array<double, 8> kStiffnesses{50.0, 100.0, 200.0, 350.0, 500.0, 1000.0, 2000.0, 5000.0};
  return kStiffnesses;
}

std::span<const double> sceneDampings_N_s_per_m() {
  static constexpr std::array<double, 6> kDampings{0.0, 0.1, 0.2, 0.5, 1.0, 2.0};
  return kDampings;
}

}  // namespace underact::stability
