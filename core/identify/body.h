#pragma once

namespace underact::identify {

/// The dynamics of an arm along one direction: m x'' = f + bias - b x' - F sign(x'), stuck while |f + bias| <= F.
struct Body {
  double mass_kg = 0.0;            // above 0
  double friction_N = 0.0;         // Coulomb's, F
  double damping_N_s_per_m = 0.0;  // b
  double bias_N = 0.0;             // a constant force: gravity that is not balanced
};

/// Position and velocity along that direction.
struct Motion {
  double x_m = 0.0;
  double v_m_per_s = 0.0;
};

/// Advances a body by one period under a constant force. Exact, including reversals and stops between two samples:
/// there is no step size.
class BodyStep {
 public:
  /// body: mass above 0, friction and damping from 0 on. period_s: above 0.
  BodyStep(const Body& body, double period_s);
  /// friction_share: the share of the friction along the direction of the body; below 1 where it also moves across it,
  /// since friction opposes the whole velocity.
  Motion operator()(Motion motion, double force_N, double friction_share = 1.0) const;

 private:
  struct Reach {  // of a velocity and of an acceleration after a time, with the damping's decay
    double of_velocity_s, of_acceleration_s2;
  };
  Reach reachAfter(double time_s) const;
  Motion gone(const Motion& motion, double acceleration, const Reach& reach) const;

  Body body_;
  double period_s_;
  double decay_per_s_;  // b / m
  Reach whole_;
};

}  // namespace underact::identify
