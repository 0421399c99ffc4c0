#include <gtest/gtest.h>

#include <cstdlib>
#include <utility>

#include "core/record/replay.h"
#include "core/servo/loop.h"
#include "tests/core/servo/scripted_port.h"
#include "tests/session/rig.h"

namespace underact::record {
namespace {

servo::Instance* instanceOf(const scene::Description& scene, std::uint64_t revision) {
  tick::TickProgram program = test::programOf(scene);
  program.limits.max_late = SessionHeader{}.max_late;
  tick::TickState state = tick::makeState(program);
  return new servo::Instance{std::move(program), std::move(state), revision};
}

}  // namespace

// What goes wrong goes into the ticks, too: samples that are missing, old or no numbers, late ticks, a servo that stood
// still, an arm that begins anew, a clock that runs away.
TEST(Replay, OfASessionFullOfFaultsIsTheSameToTheBit) {
  const test::ScratchFolder folder;
  test::ScriptedPort::Seen seen;
  test::ScriptedPort port(seen);
  std::int64_t back_ns = 0;
  port.tip = [](std::int64_t read) { return Vec3(0.0, 0.0, 0.05 + 1e-5 * static_cast<double>(read % 400)); };
  std::int64_t ahead_ns = 0;
  port.spoil = [&back_ns, &ahead_ns](std::int64_t read, arm::Sample& sample) {
    if (read % 630 > 600) ahead_ns += 30'000'000;  // now and then its clock runs away
    sample.time_ns += ahead_ns;
    if (read % 400 == 350) sample.q_rad[1] = kNotANumber;
    if (read % 2500 == 0) back_ns = sample.time_ns;  // unplugged: its clock begins again
    sample.epoch = static_cast<std::uint32_t>(read / 2500);
    sample.time_ns -= back_ns + (read % 211 == 0 ? 1'000'000 : 0);
    return read % 97 != 0 && read % 1700 > 30;
  };
  servo::ServoLoop loop(port, 1'000'000, 100'000'000);
  servo::Tap tap(1'000'000);
  scene::Description scene = test::sphereScene();
  scene.control.law = scene::LawType::PID;
  scene.control.gains.kd_N_s_per_mm.setConstant(0.002);
  scene.control.gains.ki_N_per_mm_s.setConstant(0.5);
  ASSERT_TRUE(loop.send({servo::Order::Load, instanceOf(scene, 1)}));
  ASSERT_TRUE(loop.send({servo::Order::Start}));
  for (int tick = 0; tick < 100; ++tick) loop.tick({});
  servo::Command record{servo::Order::Record};
  record.tap = &tap;
  ASSERT_TRUE(loop.send(record));
  for (int tick = 0; tick < 5000; ++tick) {
    const bool late = tick % 50 == 7 || tick % 900 < 30;  // now and then, and so often in a row that it is a fault
    const std::int64_t late_ns = late ? 2'500'000 : 40'000;
    if (tick % 1111 == 500) loop.reportStall(200'000'000);
    loop.tick({late_ns, late_ns / 1'000'000, servo::LateCause::Woken});
    if (tick % 150 == 0) loop.send({servo::Order::Start});
  }
  Result<SessionWriter> writer = SessionWriter::create(folder.file("s.h5"), {});
  ASSERT_TRUE(writer);
  ASSERT_TRUE(writer.value().begin(tap.firstTick(), tap.firstRevision(), tap.start(), scene).empty());
  int told = 0, ended = 0, odd = 0;
  for (servo::FaultMark fault; tap.take(fault);) {
    ++(fault.from_servo ? told : ended);
    odd += fault.fault.kind == FaultKind::OddClock ? 1 : 0;
    ASSERT_TRUE(writer.value().add(fault).empty());
  }
  for (servo::TickRecord row; tap.take(row);) ASSERT_TRUE(writer.value().add(row).empty());
  ASSERT_TRUE(writer.value().end({}).empty());
  EXPECT_GT(told, 1) << "else the servo never stood still while it pushed";
  EXPECT_GT(ended, 10);
  EXPECT_GT(odd, 1);
  Result<Session> session = Session::open(folder.file("s.h5"));
  const Result<Verified> verified = verifyReplay(session.value());
  ASSERT_TRUE(verified) << verified.problems().front().sentence;
  EXPECT_FALSE(verified.value().differs.has_value())
      << verified.value().differs->tick << ' ' << verified.value().differs->column;
  EXPECT_EQ(verified.value().ticks, 5000) << verified.value().unknown;
}

// A session of 0.1.0 (of the golden one's day) names no time of its gate: it went by the arm's clock. In this one that
// clock runs at half its rate, at 150 times it (Stop is asked meanwhile, and the force stays), and back; samples are
// missing, one is no number, the arm begins anew, the servo stands still. It is not to be recorded anew.
TEST(Replay, OfASessionOfTheFirstVersionIsTheSameToTheBit) {
  Result<Session> session = Session::open(std::string(UNDERACT_TEST_DATA) + "/golden/session_0_1_0.h5");
  ASSERT_TRUE(session) << session.problems().front().sentence;
  EXPECT_EQ(session.value().info().header.gate_time, GateTime::Arm);
  double stuck_N = 0.0;
  const Problems problems = session.value().eachBlock(
      [&stuck_N](const Block& block, std::int64_t) {
        for (const servo::TickRecord& row : unpackTicks(block)) {
          if (row.tick == 350 + 185) stuck_N = row.f_sent_T_W.norm();
        }
        return true;
      },
      [](const Gap&) {});
  EXPECT_TRUE(problems.empty());
  EXPECT_NEAR(stuck_N, 0.88, 1e-9) << "else it does not hold what it is kept for";
  const Result<Verified> verified = verifyReplay(session.value());
  ASSERT_TRUE(verified) << verified.problems().front().sentence;
  EXPECT_FALSE(verified.value().differs.has_value())
      << verified.value().differs->tick << ' ' << verified.value().differs->column;
  EXPECT_EQ(verified.value().ticks, 400) << verified.value().unknown;
}

// Late ticks leave deadlines out, and the gate counts them: they have to come out of the file as they went in.
TEST(Replay, OfASessionWithLateTicksCountsTheirDeadlinesToTheBit) {
  const test::ScratchFolder folder;
  test::ScriptedPort::Seen seen;
  test::ScriptedPort port(seen);
  servo::ServoLoop loop(port, 333'333, 0);
  servo::Tap tap(333'333);
  port.period_ns = 333'333;
  const scene::Description scene = test::sphereScene();
  ASSERT_TRUE(loop.send({servo::Order::Load, instanceOf(scene, 1)}));
  servo::Command record{servo::Order::Record};
  record.tap = &tap;
  ASSERT_TRUE(loop.send(record));
  test::Random random(test::Seed{12});
  for (int tick = 0; tick < 4000; ++tick) {
    if (tick % 700 == 0) loop.send({servo::Order::Start});
    if (tick % 700 == 600) loop.send({servo::Order::Stop});
    const std::int64_t late_ns = random.below(5) == 0 ? static_cast<std::int64_t>(random.below(9'999'999)) : 12'345;
    loop.tick({late_ns, late_ns / 333'333, servo::LateCause::Woken});
  }
  SessionHeader header;
  header.rate_hz = 3000;
  Result<SessionWriter> writer = SessionWriter::create(folder.file("s.h5"), header);
  ASSERT_TRUE(writer);
  ASSERT_TRUE(writer.value().begin(tap.firstTick(), tap.firstRevision(), tap.start(), scene).empty());
  for (servo::TickRecord row; tap.take(row);) ASSERT_TRUE(writer.value().add(row).empty());
  ASSERT_TRUE(writer.value().end({}).empty());
  Result<Session> session = Session::open(folder.file("s.h5"));
  EXPECT_EQ(session.value().info().header.gate_time, GateTime::Servo);
  const Result<Verified> verified = verifyReplay(session.value());
  ASSERT_TRUE(verified) << verified.problems().front().sentence;
  EXPECT_FALSE(verified.value().differs.has_value())
      << verified.value().differs->tick << ' ' << verified.value().differs->column;
  EXPECT_EQ(verified.value().ticks, 4000) << verified.value().unknown;
}

// Recorded once by a release build; every other build, and every later one, must come to the same bits. Where the
// tick's arithmetic or memory was changed on purpose: UNDERACT_UPDATE_GOLDEN=1 records it anew.
TEST(Replay, OfTheSessionInTheRepositoryIsTheSameToTheBitInThisBuild) {
  const std::string path = std::string(UNDERACT_TEST_DATA) + "/golden/session.h5";
  if (std::getenv("UNDERACT_UPDATE_GOLDEN") != nullptr) {
    const auto host = test::makeHost(servo::Clock::Manual, "probe");
    scene::Description scene = test::sceneAt(std::string(UNDERACT_SOURCE) + "/scenes/20_scara.json");
    ASSERT_TRUE(host->load(scene).empty());
    host->start();
    host->run(1000);
    const auto recorder = Recorder::start(*host, path, {.name = "golden"});
    ASSERT_TRUE(recorder);
    host->run(150);
    scene.control.gains.kp_N_per_mm *= 0.7;
    ASSERT_TRUE(host->edit(scene).empty());
    host->run(150);
    ASSERT_TRUE(recorder.value()->stop().empty());
  }
  Result<Session> session = Session::open(path);
  ASSERT_TRUE(session) << session.problems().front().sentence;
  const Result<Verified> verified = verifyReplay(session.value());
  ASSERT_TRUE(verified) << verified.problems().front().sentence;
  EXPECT_FALSE(verified.value().differs.has_value())
      << verified.value().differs->tick << ' ' << verified.value().differs->column;
  EXPECT_EQ(verified.value().ticks, 300) << verified.value().unknown;
}

}  // namespace underact::record
