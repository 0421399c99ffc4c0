#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/identify/body.h"
#include "core/identify/swing.h"

namespace underact::identify {

inline constexpr double kMinMass_kg = 1e-4;  // of a body that is fitted

/// A block of motion in one direction, weighted by a bump phi(t) that ends smoothly at both ends: the integrals of m
/// x'' = f + bias - b x' - F sign(x') times phi, by parts, so that no sample is differentiated twice. Exact for a
/// force that is held between samples, but for the damping.
struct Block {
  double inertia = 0.0;    // of phi'' x, for the mass
  double travel = 0.0;     // of phi x', for the damping
  double time = 0.0;       // of phi, for the bias
  double friction = 0.0;   // of phi and the share of the friction along the direction seen
  double force = 0.0;      // of phi f
  double stretch = 0.0;    // of phi (target - x), x as sampled and held, for a sampled spring to the target
  double sign = 1.0;       // of x'
  bool is_spring = false;  // nothing was cut, and the target has rested for a while: only the spring acts
};

// Shorter than half a swing of 20 g at 0.1 N/mm, 44 ms.
inline constexpr double kBlock_s = 0.03;

/// All blocks of that length in which the tip clearly moves one way; each begins a third later than the last.
std::vector<Block> blocksOf(std::span<const Window> windows, double seconds = kBlock_s);

/// Mass, friction, damping and bias by linear least squares over the blocks: an initial guess for fitBody(). None: too
/// little motion.
std::optional<Body> firstGuess(std::span<const Block> blocks);

/// The stiffness shown by the motion itself, whatever force was reported as sent: that of a spring to the target which
/// balances the body's inertia, m omega^2 of a free swing. None: no free swing, or one too short to find it within 5 %.
struct StiffnessFromSwing {
  double value_N_per_m = 0.0;
  double uncertainty_N_per_m = 0.0;
  std::size_t blocks = 0;
};
/// rows: of the swings along along_W.
std::optional<StiffnessFromSwing> stiffnessFromSwing(std::span<const MotionRow> rows, const Vec3& along_W,
                                                     double period_s, const Body& body, double asked_N_per_m);

}  // namespace underact::identify
