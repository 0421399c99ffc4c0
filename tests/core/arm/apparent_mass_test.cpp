#include "core/arm/apparent_mass.h"

#include <gtest/gtest.h>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/chain/kinematics.h"

namespace underact::arm {
namespace {

Model touchWithMasses() {
  Model model = *findModel("touch-measured");
  model.masses.resize(6);
  return model;
}

/// The kinetic energy of the links when the tip moves, by the differences of two places.
double energyAlong(const Model& model, const Geometry& geometry, const Vec3& v_W) {
  constexpr double kStep_s = 1e-6;
  std::array<std::vector<Pose>, 2> links;
  JointAngles wrist_rad = withinLimits(limitsOf(model), dhFromDevice({}));
  for (std::size_t at = 0; at < 2; ++at) {
    JointAngles q_rad = solvePosition(geometry, (static_cast<double>(at) - 0.5) * kStep_s * v_W).q_rad;
    std::copy(wrist_rad.begin() + 3, wrist_rad.end(), q_rad.begin() + 3);
    links[at].assign(6, Pose::Identity());
    chain::forward(model.chain, q_rad, links[at]);
  }
  double energy_J = 0.0;
  for (std::size_t link = 0; link < 6; ++link) {
    const LinkMass& mass = model.masses[link];
    const Vec3 v_C = (links[1][link] * mass.p_WC - links[0][link] * mass.p_WC) / kStep_s;
    const Mat3 turned = links[1][link].linear() * links[0][link].linear().transpose();
    const Vec3 w_W =
        Vec3(turned(2, 1) - turned(1, 2), turned(0, 2) - turned(2, 0), turned(1, 0) - turned(0, 1)) / (2.0 * kStep_s);
    const Mat3 R = links[0][link].linear();
    energy_J += 0.5 * mass.mass_kg * v_C.squaredNorm() + 0.5 * w_W.dot(R * mass.inertia_W_kg_m2 * R.transpose() * w_W);
  }
  return energy_J;
}

}  // namespace

TEST(ApparentMass, OfAPointAtTheTipIsItsMass) {
  Model model = touchWithMasses();
  model.masses[5].mass_kg = 0.07;
  model.masses[5].p_WC = model.chain.X_WT_home.translation();
  EXPECT_NEAR(apparentMass_kg(model), 0.07, 1e-12);
}

TEST(ApparentMass, IsTheMeanOfTheKineticEnergyInAllDirections) {
  Model model = touchWithMasses();
  const Geometry geometry = *omniGeometry(model);
  for (std::size_t link = 0; link < 6; ++link) {
    const auto number = static_cast<double>(link);
    model.masses[link] = {0.02 + 0.01 * number, Vec3(0.01 * number, 0.02, -0.15 + 0.03 * number),
                          Vec3(1e-5, 2e-5, 3e-5 + 1e-6 * number).asDiagonal()};
  }
  double mean_kg = 0.0;
  for (int axis = 0; axis < 3; ++axis) mean_kg += 2.0 * energyAlong(model, geometry, Vec3::Unit(axis)) / 3.0;
  EXPECT_NEAR(apparentMass_kg(model), mean_kg, 1e-6 * mean_kg);
}

TEST(ApparentMass, IsNoneWithoutMassesOrForAnotherArm) {
  EXPECT_EQ(apparentMass_kg(*findModel("touch-measured")), 0.0);
  EXPECT_EQ(apparentMass_kg(touchWithMasses()), 0.0);
  Model puma = *findModel("puma-560");
  puma.masses.assign(6, {1.0, Vec3::Ones(), Mat3::Identity()});
  EXPECT_EQ(apparentMass_kg(puma), 0.0);
}

}  // namespace underact::arm
