#include "core/servo/loop.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/scene/compile.h"
#include "tests/core/servo/scripted_port.h"
#include "tests/malloc/counter.h"

namespace underact::servo {
namespace {

Instance* instanceOf(double radius_mm, std::uint64_t revision) {
  scene::Description scene;
  scene.title = "Ball";
  scene.constraints.push_back({"ball", scene::Sphere{Vec3::Zero(), radius_mm}, target::Side::Both, {}, {}});
  tick::TickProgram program = scene::compile(scene).value();
  tick::TickState state = tick::makeState(program);
  return new Instance{std::move(program), std::move(state), revision};
}

}  // namespace

TEST(Loop, AllocatesFreesAndLocksNothingThroughSwapsEditsFaultsLateTicksAndRecordings) {
  test::ScriptedPort::Seen seen;
  test::ScriptedPort port(seen);
  port.spoil = [](std::int64_t read, arm::Sample& sample) {
    if (read % 1000 == 900) sample.q_rad[1] = kNotANumber;
    return read % 97 != 0;
  };
  ServoLoop loop(port, 1'000'000, 100'000'000);
  const auto tap = std::make_unique<Tap>(1'000'000);
  for (std::uint64_t round = 1; round <= 8; ++round) {
    Command listen{round % 3 == 0 ? Order::EndRecord : Order::Record};
    if (listen.order == Order::Record) listen.tap = tap.get();
    ASSERT_TRUE(loop.send(listen));
    ASSERT_TRUE(loop.send({Order::Load, instanceOf(40.0 + static_cast<double>(round), round)}));
    ASSERT_TRUE(loop.send({Order::Retune, instanceOf(41.0 + static_cast<double>(round), round)}));
    ASSERT_TRUE(loop.send({Order::Start}));
    ASSERT_TRUE(loop.send({round % 2 == 0 ? Order::HoldToRun : Order::RunFreely}));
    {
      test::Watch watch;
      TickRecord record;
      for (int tick = 0; tick < 1000; ++tick) {
        const std::int64_t late_ns = tick % 50 == 7 ? 2'500'000 : 40'000;
        loop.tick({late_ns, late_ns / 1'000'000, LateCause::Woken});
        if (round % 2 == 0) tap->take(record);  // else it fills up
      }
      loop.reportStall(200'000'000);
      loop.tick({});
      EXPECT_EQ(watch.allocations(), 0) << round;
      EXPECT_EQ(watch.frees(), 0) << round;
      EXPECT_EQ(watch.locks(), 0) << round;
    }
    loop.reap();
  }
  ASSERT_NE(loop.takeHistory(), nullptr) << "else no fault was in it";
  EXPECT_GT(loop.snapshot().late.total, 100);
  EXPECT_TRUE(tap->begun());
}

}  // namespace underact::servo
