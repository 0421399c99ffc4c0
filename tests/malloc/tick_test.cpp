#include <gtest/gtest.h>

#include <cstdlib>
#include <mutex>

#include "tests/malloc/counter.h"
#include "tests/support/robots.h"
#include "tests/support/tick_hand.h"

namespace underact::tick {
namespace {

using test::Hand;
using test::hold;
using test::Watch;

TEST(Watch, SeesAnAllocationHoweverItIsMade) {  // else the tests below would prove nothing
  const volatile int size = 100;
  void* volatile kept = nullptr;
  {
    Watch watch;
    kept = std::malloc(static_cast<std::size_t>(size));
    EXPECT_EQ(watch.allocations(), 1);
    std::free(kept);
    EXPECT_EQ(watch.frees(), 1);
  }
  {
    Watch watch;
    const std::vector<double> vector(static_cast<std::size_t>(size));
    kept = const_cast<double*>(vector.data());
    EXPECT_EQ(watch.allocations(), 1);
  }
  {
    Watch watch;
    const Eigen::VectorXd vector = Eigen::VectorXd::Zero(size);
    kept = const_cast<double*>(vector.data());
    EXPECT_EQ(watch.allocations(), 1);
  }
  {
    Watch watch;
    kept = std::aligned_alloc(64, 64 * static_cast<std::size_t>(size));
    EXPECT_EQ(watch.allocations(), 1);
    std::free(kept);
    kept = std::calloc(1, 8);
    kept = std::realloc(kept, 8 * static_cast<std::size_t>(size));
    std::free(kept);
    EXPECT_EQ(watch.allocations(), 3);
  }
}

TEST(Watch, SeesALock) {
  std::mutex mutex;
  Watch watch;
  mutex.lock();
  mutex.unlock();
  EXPECT_EQ(watch.locks(), 1);
}

TEST(Watch, SeesNothingWhenItIsOver) {
  { Watch watch; }
  const std::vector<double> vector(100);
  EXPECT_EQ(Watch().allocations(), 0);
}

/// Ticks through a motion with all that can befall one: released, restarted, not a number, missing, stale.
void expectQuiet(const TickProgram& program) {
  Hand hand(program);
  TickState spare = makeState(program);
  TickReport copy;
  std::vector<arm::JointAngles> script;
  for (int tick = 0; tick < 400; ++tick) script.push_back(test::scriptedAngles(37 * tick));
  script[50][2] = kNotANumber;
  Watch watch;
  for (std::size_t tick = 0; tick < script.size(); ++tick) {
    hand.input.engage = tick % 300 < 200;
    hand.input.restart = tick == 80;
    hand.input.has_sample = tick % 41 != 0;
    hand.feed(script[tick], tick % 53 == 0 ? 0.0 : 1e-3);
    copy = hand.report();
    (void)errorOf(copy);
    if (tick % 100 == 0) carryOver(hand.state(), spare);
  }
  EXPECT_EQ(watch.allocations(), 0);
  EXPECT_EQ(watch.frees(), 0);
  EXPECT_EQ(watch.locks(), 0);
}

TEST(Tick, AllocatesFreesAndLocksNothingWhateverTheScene) {
  for (const Combine combine : {Combine::Sum, Combine::Nearest}) {
    for (const shape::Shape& shape : test::middleShapes()) {
      for (const control::Law& law : test::everyLaw()) {
        for (const target::Side side : {target::Side::Both, target::Side::Outside, target::Side::Inside}) {
          SCOPED_TRACE(::testing::Message() << "shape " << shape.index() << ", law " << law.index());
          expectQuiet(makeProgram(test::thesisGeometry(), {hold(shape, law, side), hold(shape, law)}, combine,
                                  test::kTestLimits));
        }
      }
    }
  }
}

TEST(Tick, WithTheLimitsOfAHandToo) {
  expectQuiet(makeProgram(test::thesisGeometry(), {hold(test::middleShapes()[1], test::everyLaw()[2])}, Combine::Sum,
                          safety::limitsForHands(0.88, Vec3(0.15, 0.11, 0.13)),
                          arm::findPreset(arm::kDefaultArm)->limits));
}

TEST(Tick, UnderEveryVelocityFilterAndThePassivityControllerToo) {
  const Vec3 kp = Vec3::Constant(500.0), kd = Vec3::Constant(2.0);
  for (const control::Velocity& velocity :
       {control::Velocity(control::LowPass{}), control::Velocity(control::RawDifference{}),
        control::Velocity(control::AdaptiveWindow{32, Vec3::Constant(1e-4)}),
        control::Velocity(control::Kalman{16e-6, 8.0})}) {
    for (const Space space : {Space::Cartesian, Space::Joint}) {
      Entry entry = hold(test::middleShapes()[1], control::PD{kp, kd, velocity});
      entry.space = space;
      entry.passivity = control::Passivity::Control;
      expectQuiet(makeProgram(test::thesisGeometry(), {entry, entry}, Combine::Sum, test::kTestLimits));
    }
  }
}

TEST(Tick, WithInfluenceToo) {
  for (const shape::Shape& shape : test::middleShapes()) {
    Entry entry = hold(shape, test::everyLaw()[2]);
    entry.constraint.goal = target::InfluencedShape{shape, {0.5, 1.0, 0.1}};
    expectQuiet(makeProgram(test::thesisGeometry(), {entry}, Combine::Sum, test::kTestLimits));
  }
}

TEST(Tick, WithVirtualManipulatorsToo) {
  for (const manipulator::Manipulator& robot : test::everyRobot()) {
    expectQuiet(makeProgram(test::thesisGeometry(), {test::holdTo(robot, test::everyLaw()[2])}, Combine::Sum,
                            test::kTestLimits));
  }
}

TEST(Tick, InJointSpaceToo) {
  for (const shape::Shape& shape : test::middleShapes()) {
    Entry entry = hold(shape, test::everyLaw()[4]);
    entry.space = Space::Joint;
    expectQuiet(makeProgram(test::thesisGeometry(), {entry}, Combine::Sum, test::kTestLimits));
  }
}

TEST(Tick, WithSixtyFourConstraintsToo) {
  std::vector<Entry> entries;
  while (entries.size() < kMaxConstraints) {
    for (const shape::Shape& shape : test::middleShapes()) {
      if (entries.size() < kMaxConstraints) entries.push_back(hold(shape, test::everyLaw()[entries.size() % 6]));
    }
  }
  expectQuiet(makeProgram(test::thesisGeometry(), entries, Combine::Nearest, test::kTestLimits));
}

}  // namespace
}  // namespace underact::tick
