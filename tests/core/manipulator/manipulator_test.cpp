#include "core/manipulator/manipulator.h"

#include <cmath>

#include "tests/core/manipulator/chains.h"

namespace underact::manipulator {
namespace {

Wanted ringWanted() {
  Wanted wanted;
  wanted.chain = test::ring();
  wanted.ko_N_m_per_rad = 0.25;
  return wanted;
}

/// The one problem that there is, or what is wrong instead.
std::string problemOf(Wanted wanted) {
  SourceLocation place;
  place.line = 7;
  const Result<Manipulator> made = makeManipulator(std::move(wanted), place);
  if (made) return "none";
  if (made.problems().size() != 1) return std::to_string(made.problems().size()) + " problems";
  EXPECT_EQ(made.problems()[0].place.line, 7);
  return made.problems()[0].sentence;
}

chain::Chain turns(std::size_t count) {
  return test::planarArm(std::vector<double>(count, 0.02));
}

}  // namespace

TEST(MakeManipulator, TakesUpToEightJoints) {
  for (std::size_t count = 1; count <= kMaxJoints; ++count) {
    Wanted wanted;
    wanted.chain = turns(count);
    EXPECT_EQ(problemOf(wanted), "none") << count;
  }
  Wanted wanted;
  wanted.chain = turns(kMaxJoints + 1);
  EXPECT_EQ(problemOf(wanted), "A virtual robot has at most 8 joints, not 9.");
}

TEST(MakeManipulator, RefusesGainsThatAreNone) {
  for (const double bad : {-1e-9, kNotANumber, kInfinity}) {
    Wanted place = ringWanted(), turn = ringWanted(), spring = ringWanted();
    place.kp_N_per_m.y() = bad;
    turn.ko_N_m_per_rad = bad;
    spring.spring[0] = bad;
    for (const Wanted& one : {place, turn, spring}) EXPECT_EQ(problemOf(one), "A stiffness must be 0 or above.");
  }
  for (const double bad : {kNotANumber, kInfinity, -kInfinity}) {
    Wanted wanted = ringWanted();
    wanted.rest[0] = bad;
    EXPECT_EQ(problemOf(wanted), "The rest position of a joint's spring is not a finite number.");
  }
}

TEST(MakeManipulator, RefusesASolverWithoutBounds) {
  for (const int steps : {0, -3, 101}) {
    Wanted wanted = ringWanted();
    wanted.max_steps = steps;
    EXPECT_EQ(problemOf(wanted), "The solver takes 1 to 100 steps.");
  }
  for (const double tolerance : {0.0, -1e-9, 0.02, kNotANumber, kInfinity}) {
    Wanted wanted = ringWanted();
    wanted.tolerance = tolerance;
    EXPECT_EQ(problemOf(wanted), "The solver's tolerance must be above 0 and at most 0.01.");
  }
  Wanted widest = ringWanted();
  widest.max_steps = 100;
  widest.tolerance = 0.01;
  EXPECT_EQ(problemOf(widest), "none");
}

TEST(MakeManipulator, AnAngleNeedsOneJointThatTurnsAndADirectionAcrossIt) {
  Wanted wanted = ringWanted();
  wanted.orientation = Orientation::Angle;
  EXPECT_EQ(problemOf(wanted), "none");
  wanted.chain = test::tube();
  EXPECT_EQ(problemOf(wanted), "none");
  const std::string one_alone = "The orientation \"angle\" needs a chain with just one revolute joint.";
  wanted.chain = test::ball();
  EXPECT_EQ(problemOf(wanted), one_alone);
  wanted.chain = test::chainOf({test::sliding(Vec3::UnitX())}, test::tipAt(Vec3::Zero()));
  EXPECT_EQ(problemOf(wanted), one_alone);
  wanted.chain = test::chainOf({test::turning(Vec3::UnitX(), Vec3::Zero())}, test::tipAt({0, 0.05, 0}));
  EXPECT_EQ(problemOf(wanted),
            "In the home pose the tip's z axis lies along the joint's axis, so it has no angle about that axis.");
}

TEST(MakeManipulator, TheThesissLawTakesOneJointAlone) {
  Wanted wanted = ringWanted();
  wanted.law = ForceLaw::Thesis52;
  EXPECT_EQ(problemOf(wanted), "none");
  EXPECT_FALSE(test::made(wanted).closed);
  wanted.chain = test::tube();
  EXPECT_EQ(problemOf(wanted), "The thesis's force law needs a chain with just one joint, a revolute one.");
}

TEST(MakeManipulator, AClosedFormIsThereOrIsRefused) {
  Wanted wanted = ringWanted();
  wanted.method = Method::ClosedForm;
  EXPECT_EQ(problemOf(wanted), "none");
  wanted.orientation = Orientation::Full;
  EXPECT_EQ(problemOf(wanted),
            "There is no closed form for this chain with these gains and this orientation; use the method \"auto\" or "
            "\"iterative\".");
}

TEST(MakeManipulator, SaysAllProblemsAtOnce) {
  Wanted wanted;
  wanted.chain = turns(9);
  wanted.kp_N_per_m.x() = -1.0;
  wanted.rest[2] = kNotANumber;
  wanted.max_steps = 0;
  wanted.tolerance = 0.0;
  wanted.orientation = Orientation::Angle;
  const Result<Manipulator> made = makeManipulator(wanted, {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.problems().size(), 6U);
}

TEST(MakeManipulator, WithoutAnyGainTheTipIsStillTheNearestPlace) {
  Wanted wanted;
  wanted.chain = test::ring();
  wanted.kp_N_per_m.setZero();
  EXPECT_EQ(test::made(wanted).kp_N_per_m, Vec3::Ones());
  wanted.orientation = Orientation::Axis;
  EXPECT_EQ(test::made(wanted).kp_N_per_m, Vec3::Ones());
  wanted.ko_N_m_per_rad = 0.1;  // the turn alone says where
  EXPECT_EQ(test::made(wanted).kp_N_per_m, Vec3::Zero());
}

TEST(MakeManipulator, KnowsItsScaleAndItsSprings) {
  Wanted wanted = ringWanted();
  EXPECT_NEAR(test::made(wanted).reach_m, 0.05, 1e-17);
  EXPECT_FALSE(test::made(wanted).bends);
  wanted.spring[0] = 0.3;
  EXPECT_TRUE(test::made(wanted).bends);
  wanted.chain = test::chainOf({test::sliding(Vec3::UnitX())}, test::tipAt(Vec3::Zero()));
  EXPECT_EQ(test::made(wanted).reach_m, 1.0);  // everything in one place: any scale will do
}

}  // namespace underact::manipulator
