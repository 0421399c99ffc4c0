#include "core/identify/weak_form.h"

#include <algorithm>
#include <cmath>

#include "core/base/decompositions.h"
#include "core/base/units.h"

namespace underact::identify {
namespace {

constexpr double kLookAhead_s = 0.005;  // over which a direction is determined
constexpr double kTurned_m = 0.11e-3;   // two encoder steps
constexpr double kFade_s = 0.16;        // 8 time constants of the fade from one target to the next: 1 mN is left
constexpr std::size_t kMinTicks = 3;    // of a block: each begins a third of it later
constexpr std::size_t kMinBlocks = 8, kMinSprings = 6;
constexpr double kSure = 0.025;  // two deviations within 5 %: a less certain stiffness is of no use

/// The direction of the motion in all of [from, to]; 0: it reverses, or is not clear.
double directionOf(const Window& window, std::size_t from, std::size_t to) {
  const auto look = static_cast<std::size_t>(std::lround(kLookAhead_s / window.period_s));
  double direction = 0.0;
  for (std::size_t index = from; index + look <= to; ++index) {
    const double travel_m = window.travel_m[index + look] - window.travel_m[index];
    if (std::abs(travel_m) < kTurned_m || travel_m * direction < 0.0) return 0.0;
    direction = travel_m;
  }
  return direction > 0.0 ? 1.0 : direction < 0.0 ? -1.0 : 0.0;
}

bool isSpring(const Window& window, std::size_t from, std::size_t to) {
  const auto fade = static_cast<std::size_t>(std::lround(kFade_s / window.period_s));
  if (from < fade) return false;  // the time of the target's last move is before the window
  for (std::size_t index = from - fade; index <= to; ++index) {
    if (window.target_m[index] != window.target_m[to]) return false;
    if (index >= from && window.is_cut[index]) return false;
  }
  return true;
}

/// phi = (s (1 - s))^3 on s from 0 to 1, else 0: it and its first two derivatives are 0 at both ends.
double bump(double s) {
  return s > 0.0 && s < 1.0 ? std::pow(s * (1.0 - s), 3) : 0.0;
}

/// Summed by parts over the samples, with differences of phi in place of derivatives: where a force is held between two
/// samples, x_i+1 - 2 x_i + x_i-1 is T^2 / 2 (a_i + a_i-1), exactly. (The integrals with phi'' take from a straight
/// line a part of it that is 1 to 3 % of the inertia.)
Block blockOf(const Window& window, std::size_t from, std::size_t to, double sign) {
  const double period_s = window.period_s, length = static_cast<double>(to - from);
  Block block;
  block.sign = sign;
  block.is_spring = isSpring(window, from, to);
  for (std::size_t index = from; index <= to; ++index) {
    const double at = static_cast<double>(index - from);
    const double before = bump((at - 1.0) / length), now = bump(at / length), after = bump((at + 1.0) / length);
    const double held = 0.5 * period_s * (now + after);  // of what a tick sets, until the next one
    const double x_m = window.travel_m[index] - window.travel_m[from];
    block.inertia += (after - 2.0 * now + before) / period_s * x_m;
    block.travel -= 0.5 * (after - before) * x_m;
    block.stretch += held * (window.target_m[index] - window.travel_m[index]);
    block.time += period_s * now;
    block.friction += period_s * now * window.friction_share[index];
    block.force += held * window.force_N[index];
  }
  return block;
}

}  // namespace

std::vector<Block> blocksOf(std::span<const Window> windows, double seconds) {
  std::vector<Block> blocks;
  for (const Window& window : windows) {
    const auto length = static_cast<std::size_t>(std::lround(seconds / window.period_s));
    if (length < kMinTicks) continue;
    for (std::size_t from = 0; from + length < window.travel_m.size(); from += length / 3) {
      const double sign = directionOf(window, from, from + length);
      if (sign != 0.0) blocks.push_back(blockOf(window, from, from + length, sign));
    }
  }
  return blocks;
}

std::optional<Body> firstGuess(std::span<const Block> blocks) {
  if (blocks.size() < kMinBlocks) return {};
  Eigen::MatrixXd shares(blocks.size(), 4);
  Eigen::VectorXd forces(blocks.size());
  for (std::size_t index = 0; index < blocks.size(); ++index) {
    const Block& block = blocks[index];
    const auto row = static_cast<Eigen::Index>(index);
    shares.row(row) << block.inertia, block.sign * block.friction, block.travel, -block.time;
    forces[row] = block.force;
  }
  const Eigen::Vector4d found = leastSquares(shares, forces);
  if (!found.allFinite()) return {};
  return Body{std::max(found[0], kMinMass_kg), std::max(found[1], 0.0), std::max(found[2], 0.0), found[3]};
}

std::optional<StiffnessFromSwing> stiffnessFromSwing(std::span<const MotionRow> rows, const Vec3& along_W,
                                                     double period_s, const Body& body, double asked_N_per_m) {
  // As long as the motion in one direction: the noise of the second derivative of encoder steps goes with 1 / length^2.
  const double block_s = 0.5 * kPi * std::sqrt(body.mass_kg / asked_N_per_m);
  const std::vector<Block> blocks = blocksOf(windowsOf(rows, along_W, period_s, kInfinity), block_s);
  double of_stretch = 0.0, of_both = 0.0;
  StiffnessFromSwing found;
  const auto needed = [&](const Block& block) {
    return body.mass_kg * block.inertia + body.damping_N_s_per_m * block.travel +
           body.friction_N * block.sign * block.friction - body.bias_N * block.time;
  };
  for (const Block& block : blocks) {
    if (!block.is_spring) continue;
    of_stretch += block.stretch * block.stretch;
    of_both += block.stretch * needed(block);
    ++found.blocks;
  }
  if (found.blocks < kMinSprings || !(of_stretch > 0.0)) return {};
  found.value_N_per_m = of_both / of_stretch;
  double squares = 0.0;
  for (const Block& block : blocks) {
    if (block.is_spring) squares += std::pow(needed(block) - found.value_N_per_m * block.stretch, 2);
  }
  // Blocks overlap by two thirds: three of them count as one.
  const double free = std::max(1.0, static_cast<double>(found.blocks) / 3.0 - 1.0);
  found.uncertainty_N_per_m = std::sqrt(squares / (3.0 * free) * 3.0 / of_stretch);
  if (!(found.uncertainty_N_per_m < kSure * found.value_N_per_m)) return {};
  return found;
}

}  // namespace underact::identify
