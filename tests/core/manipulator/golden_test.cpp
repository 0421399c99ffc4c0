#include "tests/core/arm/golden.h"

#include <algorithm>
#include <cmath>

#include "core/manipulator/follow.h"
#include "core/manipulator/global.h"
#include "core/manipulator/thesis_law.h"
#include "tests/core/manipulator/chains.h"

// The vectors: a multistart minimum polished by Newton's method at 50 digits, its Hessian asserted positive. Lengths in
// mm, forces in N; so a torsional stiffness in N mm/rad, an energy in mJ.
namespace underact::manipulator {
namespace {

using json::Value;
using underact::test::golden;

Vec3 threeOf(const Value& list) {
  return {list.items.at(0).number, list.items.at(1).number, list.items.at(2).number};
}

double numberOf(const Value& object, const char* key) {
  return object.find(key)->number;
}

Mat3 turnOf(const Value& rows) {
  Mat3 R;
  for (int row = 0; row < 3; ++row) R.row(row) = threeOf(rows.items.at(static_cast<std::size_t>(row)));
  return R;
}

chain::Chain chainNamed(const Value& file, const std::string& name) {
  const Value& one = *file.find("chains")->find(name);
  std::vector<chain::Joint> joints;
  for (const Value& joint : one.find("joints")->items) {
    const Vec3 axis_W = threeOf(*joint.find("axis"));
    const bool turns = joint.find("type")->text == "R";
    joints.push_back(turns ? test::turning(axis_W, kMetrePerMillimetre * threeOf(*joint.find("point")))
                           : test::sliding(axis_W));
  }
  return test::chainOf(std::move(joints), underact::test::poseOf(*one.find("M0")));
}

/// One of the 116 cases.
struct Case {
  const Value& one;
  Manipulator manipulator;
  Pose X_WT;
};

Case caseOf(const Value& file, const Value& one, std::optional<Method> method) {
  Wanted wanted;
  wanted.chain = chainNamed(file, one.find("chain")->text);
  const std::string& model = one.find("model")->text;
  wanted.orientation = model == "position"       ? Orientation::None
                       : model == "axis_chordal" ? Orientation::Axis
                                                 : Orientation::Full;
  wanted.kp_N_per_m = kNewtonPerMetre * threeOf(*one.find("kp"));
  wanted.ko_N_m_per_rad = kMetrePerMillimetre * numberOf(one, "ko");
  wanted.method = method;
  wanted.tolerance = 1e-12;
  return {one, test::made(wanted),
          test::poseOf(turnOf(*one.find("R_r")), kMetrePerMillimetre * threeOf(*one.find("p_r")))};
}

/// The places of a tip within the solver's tolerance of 1e-12 rad at some 0.1 m, and the rounding of the vectors' own
/// axes (unit to 1e-16): 1e-10 mm; forces and moments with their stiffnesses of up to 1 N/mm and 2500 N mm/rad; the
/// energy to second order.
void expectMet(const Case& c, const Energy& at) {
  const Value& one = c.one;
  EXPECT_LE((kMillimetrePerMetre * at.tip.X_WT.translation() - threeOf(*one.find("p_v"))).norm(), 1e-10);
  if (c.manipulator.orientation == Orientation::Full) {
    EXPECT_LE((at.tip.X_WT.linear() - turnOf(*one.find("R_v"))).norm(), 3e-12);
  } else {
    EXPECT_LE((at.tip.X_WT.linear().col(2) - threeOf(*one.find("n_v"))).norm(), 3e-12);
  }
  const double cost_mJ = numberOf(one, "cost");
  const Vec3 f_W = threeOf(*one.find("force"));
  EXPECT_NEAR(1e3 * at.energy_J, cost_mJ, 1e-13 * (cost_mJ + f_W.norm()));  // coordinates rounded by 1e-13 mm
  EXPECT_LE((at.f_W - f_W).norm(), 2e-10);
  EXPECT_LE((1e3 * at.m_W - threeOf(*one.find("moment"))).norm(), 1e-8);
  const std::size_t joints = c.manipulator.chain.joints.size();
  for (std::size_t j = 0; j < joints; ++j) {
    Vec6 wanted;
    for (std::size_t row = 0; row < 6; ++row) {
      const double mm = row < 3 ? kMetrePerMillimetre : 1.0;
      const bool slides = c.manipulator.chain.joints[j].type == chain::JointType::Prismatic;
      wanted[static_cast<Eigen::Index>(row)] = (slides ? 1.0 : mm) * one.find("J")->items.at(row).items.at(j).number;
    }
    const Vec6 column = at.tip.J.col(static_cast<Eigen::Index>(j));
    // On the sphere (t1 + pi, pi - t2) is the same place with joint 2's axis the other way round.
    const bool may_turn = j == 1 && c.manipulator.orientation != Orientation::Full;
    const double flipped = may_turn ? (column + wanted).norm() : kInfinity;
    EXPECT_LE(std::min((column - wanted).norm(), flipped), 3e-12);
  }
}

std::string nameOf(const Value& one) {
  return one.find("chain")->text + ", " + one.find("model")->text + ", " + json::numberText(numberOf(one, "cost"));
}

/// Near a minimum and not at it.
Pose nearby(const Pose& X_WT) {
  return test::poseOf(X_WT.linear() * test::about(Vec3(1, 2, 3).normalized(), 1e-3),
                      X_WT.translation() + Vec3(4e-5, -3e-5, 2e-5));
}

}  // namespace

TEST(ManipulatorGolden, ColdTheIterativeMethodFindsTheLeastOfAllMinima) {
  const Value file = golden("virtual_manipulator.json");
  int compared = 0;
  for (const Value& one : file.find("cases")->items) {
    SCOPED_TRACE(nameOf(one));
    const Case c = caseOf(file, one, Method::Iterative);
    const Global found = minEnergy(c.manipulator, c.X_WT);
    EXPECT_TRUE(found.is_unique);
    EXPECT_GT(found.steps, 0);
    expectMet(c, found.at);
    ++compared;
  }
  EXPECT_EQ(compared, 116);
}

TEST(ManipulatorGolden, TheClosedFormsAreThereForEqualGainsAndAllButAWholeTurnOfARoundChain) {
  const Value file = golden("virtual_manipulator.json");
  int closed = 0;
  for (const Value& one : file.find("cases")->items) {
    SCOPED_TRACE(nameOf(one));
    const Case c = caseOf(file, one, std::nullopt);
    const bool slides_only = one.find("chain")->text.starts_with("2P");
    const Vec3 kp = c.manipulator.kp_N_per_m;
    const bool equal = kp.x() == kp.y() && kp.y() == kp.z();
    ASSERT_EQ(c.manipulator.closed.has_value(),
              equal && (slides_only || c.manipulator.orientation != Orientation::Full));
    if (!c.manipulator.closed) continue;
    const Global found = minEnergy(c.manipulator, c.X_WT);
    EXPECT_TRUE(found.is_unique);
    EXPECT_EQ(found.steps, 0);
    expectMet(c, found.at);
    ++closed;
  }
  EXPECT_EQ(closed, 74);
}

TEST(ManipulatorGolden, WarmItIsThereInAFewSteps) {
  const Value file = golden("virtual_manipulator.json");
  for (const Value& one : file.find("cases")->items) {
    SCOPED_TRACE(nameOf(one));
    for (const std::optional<Method> method : {std::optional<Method>(), std::optional(Method::Iterative)}) {
      const Case c = caseOf(file, one, method);
      int cold_steps = 0;
      State state = settledState(c.manipulator, nearby(c.X_WT), cold_steps);
      ASSERT_TRUE(state.begun);
      const Followed followed = follow(c.manipulator, c.X_WT, 0.0, state);
      EXPECT_LE(followed.steps, 8);
      EXPECT_TRUE(followed.is_unique);
      EXPECT_EQ(followed.p_WP, followed.at.tip.X_WT.translation());
      expectMet(c, followed.at);
    }
  }
}

TEST(ManipulatorGolden, ThePlanarAngleOfTheThesisHasItsGlobalMinimum) {
  const Value file = golden("virtual_manipulator.json");
  int compared = 0;
  for (const Value& one : file.find("planar")->items) {
    SCOPED_TRACE(one.find("name")->text);
    const Vec3 gains = threeOf(*one.find("K"));
    const Value& pivot = *one.find("pivot");
    const Vec3 p_WJ = kMetrePerMillimetre * Vec3(pivot.items.at(0).number, pivot.items.at(1).number, 0.0);
    Wanted wanted;
    wanted.chain = test::chainOf({test::turning(Vec3::UnitZ(), p_WJ)},
                                 test::tipAt(p_WJ + kMetrePerMillimetre * Vec3(numberOf(one, "Lv"), 0, 0)));
    wanted.orientation = Orientation::Angle;
    wanted.kp_N_per_m = kNewtonPerMetre * Vec3(gains.x(), gains.y(), 1.0);
    wanted.ko_N_m_per_rad = kMetrePerMillimetre * gains.z();
    wanted.tolerance = 1e-12;
    const Value& p = *one.find("p");
    const Pose X_WT =
        test::poseOf(test::about(Vec3::UnitZ(), numberOf(one, "theta_r")) * test::tipAt(Vec3::Zero()).linear(),
                     kMetrePerMillimetre * Vec3(p.items.at(0).number, p.items.at(1).number, 0.0));
    const Global found = minEnergy(test::made(wanted), X_WT);
    EXPECT_NEAR(std::remainder(found.at.theta[0] - numberOf(one, "theta"), 2.0 * kPi), 0.0, 3e-12);
    EXPECT_NEAR(1e3 * found.at.energy_J, numberOf(one, "cost"), 1e-13 * numberOf(one, "cost") + 1e-20);
    const Vec3 wrench = threeOf(*one.find("wrench"));
    EXPECT_NEAR(found.at.f_W.x(), wrench.x(), 1e-9);
    EXPECT_NEAR(found.at.f_W.y(), wrench.y(), 1e-9);
    EXPECT_NEAR(1e3 * found.at.m_W.z(), wrench.z(), 1e-8);
    ++compared;
  }
  EXPECT_EQ(compared, 32);
}

TEST(ManipulatorGolden, TheCodeOfTheThesisAsCorrected) {
  const Value file = golden("virtual_manipulator.json");
  int compared = 0;
  for (const Value& one : file.find("corrected_code_5_2")->items) {
    SCOPED_TRACE(compared);
    const Vec3 p_WJ = kMetrePerMillimetre * threeOf(*one.find("pivot"));
    const double kp = kNewtonPerMetre * numberOf(one, "kp");
    ASSERT_EQ(numberOf(one, "kp"), numberOf(one, "kz"));
    Wanted wanted;
    wanted.chain = test::chainOf({test::turning(Vec3::UnitZ(), p_WJ)},
                                 test::tipAt(p_WJ + kMetrePerMillimetre * Vec3(numberOf(one, "Lv"), 0, 0)));
    wanted.kp_N_per_m = Vec3::Constant(kp);
    wanted.ko_N_m_per_rad = kMetrePerMillimetre * numberOf(one, "ktheta");
    wanted.law = ForceLaw::Thesis52;
    const Pose X_WT =
        test::poseOf(test::about(Vec3::UnitZ(), numberOf(one, "theta_r")) * test::tipAt(Vec3::Zero()).linear(),
                     kMetrePerMillimetre * threeOf(*one.find("p")));
    const ThesisPull pull = thesisPull(test::made(wanted), X_WT);
    ASSERT_TRUE(pull.is_unique);
    EXPECT_NEAR(std::remainder(pull.theta_rad - numberOf(one, "theta_v"), 2.0 * kPi), 0.0, 4e-15);
    EXPECT_NEAR(pull.error_rad, numberOf(one, "e_theta"), 4e-15);
    // Forces of some 30 N, of angles and lengths within a few ulp.
    EXPECT_LE((kp * (pull.p_WP - X_WT.translation()) + pull.f_along_T_W - threeOf(*one.find("force"))).norm(), 1e-12);
    const Vec3 t_W = test::about(Vec3::UnitZ(), numberOf(one, "theta_v")) * Vec3::UnitY();
    EXPECT_NEAR(pull.f_along_T_W.dot(t_W), numberOf(one, "tangential_component"), 1e-12);
    EXPECT_NEAR(1e3 * pull.moment_W.z(), numberOf(one, "moment_not_rendered"), 1e-11);
    ++compared;
  }
  EXPECT_EQ(compared, 30);
}

}  // namespace underact::manipulator
