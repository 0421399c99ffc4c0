#include <gtest/gtest.h>

#include "tests/error_bounds/oracle/arm.h"
#include "tests/error_bounds/oracle/chain.h"
#include "tests/error_bounds/oracle/energy.h"
#include "tests/error_bounds/oracle/shapes.h"
#include "tests/error_bounds/oracle/turns.h"

// The judges themselves, against what a person works out on paper.
namespace underact::error_bounds {
namespace {

const Real kExact("1e-90");
const Real3 kZero{0, 0, 0};

void expectAt(const Real3& got, const Real3& right) {
  EXPECT_LE(norm(got - right), kExact) << got.x << " " << got.y << " " << got.z;
}

TEST(Oracle, CountsUlpsOfTheScaleItIsGiven) {
  EXPECT_EQ(ulpsOf(1.0 + 0x1p-52, Real(1), Real(1)), 1.0);
  EXPECT_EQ(ulpsOf(1.0 + 0x1p-52, Real(1), Real(2)), 0.5);
  EXPECT_EQ(ulpsOf(Vec3(1, 2, 3 + 0x1p-50), Real3{1, 2, 3}, Real(1)), 4.0);
  EXPECT_EQ(ulpsOf(kNotANumber, Real(1), Real(1)), kInfinity);
  EXPECT_EQ(ulpsOf(Vec3(0, kInfinity, 0), kZero, Real(1)), kInfinity);
  EXPECT_EQ(ulpsOf(0x1p-1022, Real(0), Real(0)), 1.0) << "where there is no scale, the least normal number is one";
}

TEST(Oracle, NearestPointsByHand) {
  expectAt(oracle::onSphere({1, 0, 0}, 2, {1, 3, 4}).p_WP, {1, Real(6) / 5, Real(8) / 5});
  EXPECT_EQ(oracle::onSphere({1, 0, 0}, 2, {1, 3, 4}).distance, 3);
  expectAt(oracle::onLine({0, 0, 1}, {2, 0, 0}, {5, 3, 5}).p_WP, {5, 0, 1});
  EXPECT_EQ(oracle::onLine({0, 0, 1}, {2, 0, 0}, {5, 3, 5}).distance, 5);
  expectAt(oracle::onPlane({0, 0, 2}, {0, 0, -3}, {7, 8, 9}).p_WP, {7, 8, 2});
  expectAt(oracle::onCircle({0, 0, 1}, {0, 0, 5}, 10, {3, 4, 7}).p_WP, {6, 8, 1});
  expectAt(oracle::onCylinder({0, 0, 1}, {0, 0, 5}, 10, {3, 4, 7}).p_WP, {6, 8, 7});
  EXPECT_LE(abs(oracle::offAxis({0, 0, 1}, {0, 0, 5}, {3, 4, 7}) - 5), kExact);
}

TEST(Oracle, TrianglesByHand) {
  const Real3 a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  expectAt(oracle::onTriangle(a, b, c, {1, 1, 5}).p_WP, {1, 1, 0});
  expectAt(oracle::onTriangle(a, b, c, {3, 3, 0}).p_WP, {2, 2, 0});
  expectAt(oracle::onTriangle(a, b, c, {-1, -2, 3}).p_WP, a);
  expectAt(oracle::onTriangle(a, b, c, {1, -2, 3}).p_WP, {1, 0, 0});
  expectAt(oracle::onTriangle(a, b, b, {2, 3, 0}).p_WP, {2, 0, 0});  // no area
  expectAt(oracle::onTriangle(a, a, a, {2, 3, 0}).p_WP, a);
}

TEST(Oracle, SolidsByHand) {
  const std::array<Real3, 3> edges{Real3{1, 0, 0}, Real3{0, 2, 0}, Real3{0, 0, 3}};
  EXPECT_TRUE(oracle::isInSolid(kZero, edges, {0.5, 1.5, -2.5}));
  EXPECT_FALSE(oracle::isInSolid(kZero, edges, {0.5, 2.5, 0}));
  expectAt(oracle::onSolid(kZero, edges, {0.5, 0.1, 0.2}).p_WP, {1, 0.1, 0.2});
  expectAt(oracle::onSolid(kZero, edges, {2, 3, 4}).p_WP, {1, 2, 3});
  EXPECT_LE(abs(oracle::onSolid(kZero, edges, {2, 3, 4}).distance - sqrt(Real(3))), kExact);
  const std::array<Real3, 3> skew{Real3{1, 0, 0}, Real3{1, 1, 0}, Real3{0, 0, 1}};
  EXPECT_TRUE(oracle::isInSolid(kZero, skew, {1.5, 0.9, 0}));
  expectAt(oracle::onSolid(kZero, skew, {5, 2, 0}).p_WP, {2, 1, 0});
}

TEST(Oracle, QuadricsByHand) {
  EXPECT_LE(abs(oracle::toQuadric({2, 1, 1}, {3, 0, 0}, 3) - 1), kExact);
  EXPECT_LE(abs(oracle::toQuadric({2, 1, 1}, {0, 4, 0}, 3) - 3), kExact);
  // Tip at 0.75 on the long axis: x = 4 * 0.75 / 3 = 1, y^2 = 3/4; distance^2 = 1/16 + 3/4.
  EXPECT_LE(abs(oracle::toQuadric({2, 1, 1}, {0.75, 0, 0}, 2) - sqrt(Real(13) / 16)), kExact);
  EXPECT_LE(abs(oracle::toQuadric({5, 5, 5}, {0, 0, 0}, 3) - 5), kExact);
  EXPECT_LE(abs(oracle::toQuadric({5, 5, 5}, {3, 4, 12}, 3) - 8), kExact);
  EXPECT_LE(abs(oracle::toQuadric({5, 5, 5}, {1, 2, 2}, 3) - 2), kExact);
  EXPECT_LE(abs(oracle::toQuadric({2, 1, 1}, {0, Real("1e-300"), 0}, 2) - 1), kExact);
}

TEST(Oracle, TurnsByHand) {
  const oracle::Quaternion quarter = oracle::about({0, 0, 1}, piReal() / 2);
  expectAt(oracle::turned(quarter, Real3{1, 0, 0}), {0, 1, 0});
  const oracle::Columns R = oracle::columnsOf(quarter);
  EXPECT_LE(abs(oracle::angleOf(oracle::columnsOf(Mat3::Identity()), R) - piReal() / 2), kExact);
  const oracle::Motion there{quarter, {1, 0, 0}};
  expectAt(oracle::moved(there * there, Real3{1, 0, 0}), {0, 1, 0});
  EXPECT_LE(abs(piReal() - Real("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899")),
            Real("1e-79"));
}

TEST(Oracle, TheArmByHand) {
  arm::Geometry geometry{2.0, 3.0, Vec3(10, 20, 30)};
  // All joints 0: out by L1 along z of W, the forearm straight down. Joint 3 up by a quarter: straight out.
  expectAt(oracle::armPose(geometry, {0, 0, 0, 0, 0, 0}).p_WT, {10, 17, 32});
  expectAt(oracle::armPose(geometry, {0, 0, piReal() / 2, 0, 0, 0}).p_WT, {10, 20, 35});
  expectAt(oracle::armPose(geometry, {piReal() / 2, 0, piReal() / 2, 0, 0, 0}).p_WT, {15, 20, 30});
  const std::array<Real3, 3> J = oracle::armJacobian(geometry, {});
  const Real near("1e-60");
  EXPECT_LE(norm(J[0] - Real3{2, 0, 0}), near);
  EXPECT_LE(norm(J[1] - Real3{0, 2, 3}), near);
  EXPECT_LE(norm(J[2] - Real3{0, 0, 3}), near);
  EXPECT_LE(norm(oracle::armTurning(geometry, {})[0] - Real3{0, 1, 0}), near);
}

TEST(Oracle, ChainsAndTheirEnergyByHand) {
  chain::Chain chain;
  chain.joints = {{chain::JointType::Revolute, Vec3::UnitZ(), Vec3::Zero()},
                  {chain::JointType::Prismatic, Vec3::UnitX(), Vec3::Zero()}};
  chain.X_WT_home.translation() = Vec3(1, 0, 0);
  expectAt(oracle::chainPose(chain, {piReal() / 2, 2}).p_WT, {0, 3, 0});
  const Real near("1e-60");
  EXPECT_LE(norm(oracle::chainTwist(chain, {piReal() / 2, 2}, 0).v - Real3{-3, 0, 0}), near);
  EXPECT_LE(norm(oracle::chainTwist(chain, {piReal() / 2, 2}, 0).w - Real3{0, 0, 1}), near);
  EXPECT_LE(norm(oracle::chainTwist(chain, {piReal() / 2, 2}, 1).v - Real3{0, 1, 0}), near);
  manipulator::Manipulator m;
  m.chain = chain;
  m.kp_N_per_m = Vec3::Constant(2.0);
  Pose X_WT = Pose::Identity();
  X_WT.translation() = Vec3(0, 0, 4);  // tip (3, 0, 0): 1/2 * 2 * 25
  EXPECT_LE(abs(oracle::energyOf(m, X_WT, {0, 2}) - 25), kExact);
  EXPECT_LE(abs(oracle::slopeOf(m, X_WT, {0, 2}, 1) - 6), near);
  m.spring[1] = 10.0;
  EXPECT_LE(abs(oracle::energyOf(m, X_WT, {0, 2}) - 45), kExact);
}

TEST(Oracle, AnglesAboutAnAxisByHand) {
  const Real3 up{0, 0, 2};
  EXPECT_LE(abs(oracle::turnAbout(up, {1, 0, 5}, {0, 3, -1}) - piReal() / 2), kExact);
  EXPECT_LE(abs(oracle::turnAbout(up, {0, 3, -1}, {1, 0, 5}) + piReal() / 2), kExact);
  EXPECT_LE(abs(oracle::weightAbout(up, {0, 0, -1})), kExact);
  EXPECT_LE(abs(oracle::weightAbout(up, {1, 0, 1}) - 1), kExact);
  const Real half = piReal() / 72;  // half of 5 degrees
  EXPECT_LE(abs(oracle::weightAbout(up, {sin(half), 0, cos(half)}) - Real(1) / 2), kExact);
  manipulator::Manipulator m;
  m.chain.joints = {{chain::JointType::Revolute, Vec3::UnitZ(), Vec3::Zero()}};
  m.chain.X_WT_home.linear() << 0, 0, 1, 0, -1, 0, 1, 0, 0;  // z of V along x
  m.chain.X_WT_home.translation() = Vec3(1, 0, 0);
  m.orientation = manipulator::Orientation::Angle;
  m.kp_N_per_m.setZero();
  m.ko_N_m_per_rad = 2.0;
  Pose X_WT = Pose::Identity();
  X_WT.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;  // z of the stylus along y
  EXPECT_LE(abs(oracle::energyOf(m, X_WT, {0}) - piReal() * piReal() / 4), kExact);
  EXPECT_LE(abs(oracle::energyOf(m, X_WT, {piReal()}) - piReal() * piReal() / 4), kExact);
}

TEST(Oracle, InsideAndOutsideByHand) {
  const Real3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_LE(abs(oracle::shareOfSphere(x, y, z, o) - Real(1) / 8), kExact) << "an octant";
  const auto turns = [&](const Real3& q) {
    return Real(oracle::shareOfSphere(x, y, z, q) + oracle::shareOfSphere(o, y, x, q) +
                oracle::shareOfSphere(o, z, y, q) + oracle::shareOfSphere(o, x, z, q));
  };
  EXPECT_LE(abs(turns({0.2, 0.2, 0.2}) - 1), kExact);
  EXPECT_LE(abs(turns({0.5, 0.5, 0.5})), kExact);
  EXPECT_LE(abs(turns({-0.001, 0.2, 0.2})), kExact);
}

TEST(Oracle, SystemsByCramersRule) {
  const std::array<Real3, 3> columns{Real3{2, 0, 0}, Real3{0, 4, 0}, Real3{1, 0, 5}};
  expectAt(oracle::solved(columns, {4, 8, 10}), {1, 2, 2});
}

}  // namespace
}  // namespace underact::error_bounds
