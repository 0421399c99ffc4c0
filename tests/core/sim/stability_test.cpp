#include <cmath>
#include <vector>

#include "core/control/law.h"
#include "core/sim/plant.h"
#include "tests/support/property.h"
#include "tests/support/sampled_wall.h"

namespace underact::sim {
namespace {

using test::SampledWall;

constexpr double kShare = 0.02;

/// Whether the simulated arm under the project's own law is calm after a nudge: its swing at the end is smaller than
/// it was halfway.
bool isCalm(const SampledWall& wall, double stiffness_N_per_m) {
  const Vec3 p_WP(0.0, 0.0, 0.03), nudge_W(1e-6, 0.0, 0.0);
  const Plant plant{
      *arm::findPreset("omni-thesis"), {"bare", "", "", wall.mass_kg, 0.0, false}, {0.0, wall.damping_N_s_per_m, 0.0}};
  const control::Law law =
      control::PD{Vec3::Constant(stiffness_N_per_m), Vec3::Constant(wall.kd_N_s_per_m), control::RawDifference{}};
  control::LawState memory;
  const auto period_ns = static_cast<std::int64_t>(std::llround(1e9 * wall.period_s));
  PlantState state = restAt(plant, p_WP);
  state.p_WT += nudge_W;
  std::vector<Vec3> under_way(static_cast<std::size_t>(wall.delay_ticks), Vec3::Zero());
  HandWish wish;
  double first_m = 0.0, second_m = 0.0;
  const int ticks = static_cast<int>(1.2 / wall.period_s);  // sways of 20 Hz and more: 1 % off the limit shows
  for (int tick = 0; tick < ticks; ++tick) {
    under_way.push_back(control::force(law, memory, p_WP - state.p_WT, {wall.period_s, false, false}));
    const Vec3 f_T_W = under_way.front();
    under_way.erase(under_way.begin());
    wish.p_WT = p_WP;
    state = advance(plant, state, f_T_W, wish, period_ns);
    const double off_m = (state.p_WT - p_WP).norm();
    if (off_m > 1e-3) return false;  // a thousand times the nudge, and still far from any joint's limit
    if (tick >= ticks / 4 && tick < ticks / 2) first_m = std::max(first_m, off_m);
    if (tick >= 3 * (ticks / 4)) second_m = std::max(second_m, off_m);
  }
  return second_m < first_m || second_m < 1e-12;
}

/// By halving the span from four fifths of a guess to five fourths of it. 0: the limit is not in there.
double simulatedLimit(const SampledWall& wall, double guess_N_per_m) {
  double calm = 0.8 * guess_N_per_m, wild = 1.25 * guess_N_per_m;
  if (!isCalm(wall, calm) || isCalm(wall, wild)) return 0.0;
  while (wild - calm > 5e-3 * wild) {
    const double middle = 0.5 * (calm + wild);
    (isCalm(wall, middle) ? calm : wild) = middle;
  }
  return 0.5 * (calm + wild);
}

struct Row {
  double mass_kg, damping_N_s_per_m, kd_N_s_per_m, period_s;
  double limit_N_per_m[3];  // with a delay of 0, 1, 2 ticks
};

// The table of largest stable stiffnesses: an own script's, by spectral radius, to 0.1 N/m. Where it says "any" mass,
// 20 g: a light one shows soonest whether it is calm.
const Row kTable[]{
    {0.02, 0.1, 0.0, 1e-3, {200.0, 66.7, 40.0}},          {0.045, 0.1, 0.5, 1e-3, {1187.2, 395.3, 236.5}},
    {0.108, 1.0, 0.5, 1e-3, {2990.8, 997.4, 598.5}},      {0.045, 0.1, 2.0, 1e-3, {4019.1, 1331.6, 787.7}},
    {0.02, 0.1, 0.0, 0.25e-3, {800.0, 266.7, 160.0}},     {0.045, 0.1, 0.5, 0.25e-3, {4787.1, 1595.3, 956.5}},
    {0.045, 0.1, 2.0, 0.25e-3, {16616.0, 5531.7, 3308.3}}};

TEST(StabilityOfAWall, TheSimulatedLimitIsThatOfTheSpectralRadius) {
  for (const Row& row : kTable) {
    for (int delay = 0; delay < 3; ++delay) {
      const SampledWall wall{row.mass_kg, row.damping_N_s_per_m, 0.0, row.kd_N_s_per_m, row.period_s, delay};
      const double known = row.limit_N_per_m[delay];
      EXPECT_NEAR(test::exactLimit(wall), known, 0.001 * known + 0.1) << row.mass_kg << " kg, delay " << delay;
      const double simulated = simulatedLimit(wall, test::exactLimit(wall));
      EXPECT_NEAR(simulated, known, kShare * known) << row.mass_kg << " kg, delay " << delay;
    }
  }
}

}  // namespace
}  // namespace underact::sim
