#pragma once

namespace underact::identify {

/// An arm as felt along one direction: m x'' = f + bias - b x' - F sign(x'), stuck while |f + bias| <= F.
struct Body {
  double mass_kg = 0.0;            // above 0
  double friction_N = 0.0;         // Coulomb's, F
  double damping_N_s_per_m = 0.0;  // b
  double bias_N = 0.0;             // what pulls all the time: gravity that is not balanced
};

/// Position and velocity along that direction.
struct Motion {
  double x_m = 0.0;
  double v_m_per_s = 0.0;
};

/// A body over one period of a held force. Exact, turns and stops between two samples included: no step size.
class BodyStep {
 public:
  /// body: mass above 0, friction and damping from 0 on. period_s: above 0.
  BodyStep(const Body& body, double period_s);
  /// friction_share: of the friction that acts along the direction seen; less than 1 where the body moves across it,
  /// too, since friction is against the whole velocity.
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
