#include "device/remote/remote_arm.h"

#include <gtest/gtest.h>

#include "core/servo/host.h"
#include "tests/support/comes.h"
#include "tests/support/shared_arm.h"

namespace underact::device::remote {
namespace {

using namespace std::chrono_literals;
using test::comes;
using test::SharedArm;

/// What only the gate can make: a force within 5 N, fully ramped.
safety::GatedForce gatedForRemote(const Vec3& f_T_W) {
  safety::GateState state;
  state.level = 1.0;
  return safety::gate({5.0}, state, {f_T_W, true, false, {}}, 0.001).force;
}

const Vec3 kPush_N(0.5, 0.0, 0.0);

/// A program at the other end, which ticks when it is told to.
struct Client {
  explicit Client(SharedArm& far_side, int rate_hz = 1000) : far(far_side) {
    auto opened = far.open(nullptr, rate_hz);
    EXPECT_TRUE(opened) << opened.problems().front().sentence;
    if (opened) arm = std::move(opened).value();
  }
  bool tick(const Vec3& f_T_W = kPush_N) {
    const bool has = arm->read(sample);
    arm->write(gatedForRemote(f_T_W));
    return has;
  }
  /// Ticks, as often as a servo, until the arm is pushed so.
  bool push(const Vec3& f_T_W = kPush_N) {
    const auto end = std::chrono::steady_clock::now() + 20s;
    while (std::chrono::steady_clock::now() < end) {
      tick(f_T_W);
      if ((far.arm.force_N() - f_T_W).norm() < 0.01) return true;
      if (arm->trouble().find("was released") != std::string::npos) return false;
    }
    return false;
  }
  bool rests() const { return far.arm.force_N() == Vec3::Zero(); }

  SharedArm& far;
  std::unique_ptr<RemoteArm> arm;
  arm::Sample sample;
};

std::string refusalReason(const Result<std::unique_ptr<RemoteArm>>& arm) {
  return arm ? "" : arm.problems().front().sentence;
}

bool says(const std::string& text, const char* words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST(RemoteArm, ShowsAndPushesTheArmThere) {
  SharedArm far;
  Client client(far);
  EXPECT_TRUE(says(client.arm->info().title, "Double at 127.0.0.1:"));
  EXPECT_EQ(client.arm->info().frozen_s, 0.5);
  EXPECT_TRUE(client.push());
  far.arm.placeTip(Vec3(0.03, 0.02, 0.05));
  EXPECT_TRUE(comes([&] {
    client.tick(Vec3::Zero());
    return (arm::tipPosition(far.arm.preset().geometry, client.sample.q_rad) - Vec3(0.03, 0.02, 0.05)).norm() < 1e-6;
  }));
  EXPECT_TRUE(says(far.told(), "A program has the arm.\n"));
  EXPECT_TRUE(comes([&] { return says(far.told(), "It pushes.\n"); }));
}

TEST(RemoteArm, PushesOnlyWhereThatWasAllowed) {
  SharedArm far(false);
  Client client(far);
  EXPECT_TRUE(says(client.arm->info().title, ", without force"));
  for (int tick = 0; tick < 500; ++tick) client.tick();
  EXPECT_EQ(far.arm.pushes(), 0);
  EXPECT_TRUE(comes([&] { return client.tick(); }));
}

// The thread's own zero, while the line stands and the servo does not tick.
TEST(RemoteArm, WithoutTicksItTellsZero) {
  SharedArm far;
  Client client(far);
  ASSERT_TRUE(client.push());
  EXPECT_TRUE(comes([&] { return client.rests(); }));
  std::this_thread::sleep_for(500ms);
  EXPECT_FALSE(says(far.told(), "stopped sending")) << "it says zero all the while";
  EXPECT_TRUE(client.push());
}

TEST(RemoteArm, ACutLastsUntilTheNextForce) {
  SharedArm far;
  Client client(far);
  ASSERT_TRUE(client.push());
  client.arm->cut();
  EXPECT_TRUE(comes([&] { return client.rests(); }));
  EXPECT_TRUE(client.push());
}

TEST(RemoteArm, TimeNeverRunsBackAndIsTheArmsOwn) {
  SharedArm far;
  Client client(far);
  std::int64_t before_ns = 0;
  for (int line = 0; line < 3; ++line) {
    for (int ticks = 0; ticks < 100;) {
      if (!client.tick(Vec3::Zero())) continue;
      ++ticks;
      ASSERT_GT(client.sample.time_ns, before_ns);
      before_ns = client.sample.time_ns;
    }
    const std::uint32_t epoch = client.sample.epoch;
    ASSERT_TRUE(client.arm->reopen().empty());
    ASSERT_TRUE(comes([&] { return client.tick(Vec3::Zero()); }));
    EXPECT_EQ(client.sample.epoch, epoch + 1);
  }
}

TEST(RemoteArm, TimeGoesOnAsTheArmsDoesWhenThatBeganAnew) {
  SharedArm far;
  Client client(far);
  ASSERT_TRUE(comes([&] { return client.tick(Vec3::Zero()); }));
  std::this_thread::sleep_for(300ms);
  far.end();
  far.share();
  far.cable().plug();
  ASSERT_TRUE(client.arm->reopen().empty());
  ASSERT_TRUE(comes([&] { return client.tick(Vec3::Zero()); }));
  const std::int64_t from_ns = client.sample.time_ns, began_ns = system::monotonicNow_ns();
  for (int tick = 0; tick < 50; ++tick) {
    std::this_thread::sleep_for(4ms);
    client.tick(Vec3::Zero());
  }
  EXPECT_GT(client.sample.time_ns - from_ns, (system::monotonicNow_ns() - began_ns) / 2);
}

TEST(RemoteArm, ALineThatIsHeldUpHasNoSampleAndTheArmNoForce) {
  SharedArm far;
  Client client(far);
  ASSERT_TRUE(client.push());
  far.cable().hold(true);
  EXPECT_TRUE(comes([&] { return !client.tick() && client.rests(); }));
  EXPECT_TRUE(comes([&] { return !client.tick() && !client.arm->trouble().empty(); }));
  EXPECT_TRUE(says(client.arm->trouble(), "no longer sends anything")) << client.arm->trouble();
}

TEST(RemoteArm, ALineThatIsHeldUpForAMomentComesBack) {
  bool comes_back = false;
  for (int attempt = 0; attempt < 5 && !comes_back; ++attempt) {  // a busy machine may make the moment too long
    SharedArm far;
    Client client(far);
    ASSERT_TRUE(client.push());
    far.cable().hold(true);
    ASSERT_TRUE(comes([&] { return !client.tick(); }));
    far.cable().hold(false);
    comes_back = client.push();
  }
  EXPECT_TRUE(comes_back) << "the line was never lost";
}

TEST(RemoteArm, ALostLineStaysLostUntilItIsOpenedAgain) {
  SharedArm far;
  Client client(far);
  ASSERT_TRUE(client.push());
  far.cable().cut();
  EXPECT_TRUE(comes([&] { return !client.tick() && client.rests(); }));
  EXPECT_TRUE(comes([&] { return says(client.arm->trouble(), "was lost"); })) << client.arm->trouble();
  const std::int64_t pushes = far.arm.pushes();
  for (int tick = 0; tick < 200; ++tick) EXPECT_FALSE(client.tick());
  EXPECT_EQ(far.arm.pushes(), pushes);
  EXPECT_TRUE(client.arm->reopen().empty());
  EXPECT_EQ(client.arm->trouble(), "");
  EXPECT_TRUE(client.push());
}

TEST(RemoteArm, WhenTheSharingProgramEndsItSaysSo) {
  SharedArm far;
  Client client(far);
  ASSERT_TRUE(client.push());
  far.end();
  EXPECT_TRUE(client.rests());
  EXPECT_TRUE(comes([&] { return !client.tick() && says(client.arm->trouble(), "no longer shared"); }))
      << client.arm->trouble();
  far.cable().pull();
  EXPECT_FALSE(client.arm->reopen().empty());
  EXPECT_TRUE(says(client.arm->trouble(), "No arm is shared at")) << client.arm->trouble();
  far.share();
  far.cable().plug();
  EXPECT_TRUE(client.arm->reopen().empty());
  EXPECT_TRUE(client.push());
}

TEST(RemoteArm, TheArmsOwnTroubleIsTold) {
  SharedArm far;
  Client client(far);
  ASSERT_TRUE(client.push());
  far.arm.stayLost(true);
  far.arm.lose(true);
  EXPECT_TRUE(comes([&] { return !client.tick() && client.rests(); }));
  EXPECT_TRUE(comes([&] { return says(client.arm->trouble(), "The double was unplugged. Plug it in."); }));
  EXPECT_TRUE(says(refusalReason(far.open()), "in use")) << "it is still this one's";
  const Problems problems = client.arm->reopen();
  ASSERT_FALSE(problems.empty());
  EXPECT_TRUE(says(problems.front().sentence, "The double is still unplugged.")) << problems.front().sentence;
  far.arm.stayLost(false);
  EXPECT_TRUE(client.arm->reopen().empty()) << "which opens the arm there, too";
  EXPECT_EQ(client.arm->trouble(), "");
  EXPECT_TRUE(client.push());
}

TEST(RemoteArm, OneAtATimeHasIt) {
  SharedArm far;
  auto first = std::make_unique<Client>(far);
  ASSERT_TRUE(first->push());
  const std::string why = refusalReason(far.open());
  EXPECT_TRUE(says(why, "in use by another program")) << why;
  EXPECT_TRUE(first->push());
  first.reset();
  // On a busy machine one may have fallen silent before it said goodbye.
  bool has_let_go = false;
  for (int round = 0; round < 5 && !has_let_go; ++round) {
    { EXPECT_TRUE(Client(far).push()); }
    has_let_go = comes([&] { return says(far.told(), "has released it"); });
  }
  EXPECT_TRUE(has_let_go) << far.told();
}

// A process that is killed says nothing any more.
TEST(RemoteArm, OneWhoFellSilentLosesItsPlace) {
  SharedArm far;
  auto first = std::make_unique<Client>(far);
  ASSERT_TRUE(first->push());
  far.cable().pull();
  EXPECT_TRUE(comes([&] { return first->rests(); }));
  EXPECT_TRUE(comes([&] { return says(far.told(), "stopped sending"); }));
  far.cable().plug();
  Client second(far);
  EXPECT_TRUE(second.push());
}

TEST(RemoteArm, SaysWhyItCannotBeOpened) {
  SharedArm far;
  Endpoint endpoint = far.endpoint();
  endpoint.own = far.stranger();
  EXPECT_TRUE(says(refusalReason(RemoteArm::open(endpoint, far.arm.preset(), 1000)), "your key is not known there"));
  EXPECT_TRUE(comes([&] { return says(far.told(), "was refused"); }));
  endpoint = far.endpoint();
  endpoint.server_key = far.stranger().public_key;
  EXPECT_TRUE(
      says(refusalReason(RemoteArm::open(endpoint, far.arm.preset(), 1000)), "not the arm whose key is known here"));
  EXPECT_TRUE(says(refusalReason(far.open("woodenhaptics")),
                   "the joints of \"omni-thesis\", but the scene is for \"woodenhaptics\". Share it with --arm"));
  far.cable().pull();
  EXPECT_TRUE(says(refusalReason(far.open()), "No arm is shared at 127.0.0.1:"));
}

TEST(RemoteArm, AnotherVersionIsRefusedInWords) {
  SharedArm far;
  const Endpoint endpoint = far.endpoint();
  const auto wire = connectTo(endpoint, 3000);
  ASSERT_TRUE(wire);
  Bytes hello = bytesOf(Hello{1, 1000, false, {"omni-thesis", far.arm.preset().geometry}});
  hello[4] = 2;
  wire.value()->send(hello);
  Bytes answer;
  ASSERT_TRUE(comes([&] { return wire.value()->receive(answer); }));
  const auto message = readMessage(answer);
  ASSERT_TRUE(message && std::get_if<Words>(&*message));
  EXPECT_TRUE(says(std::get<Words>(*message).text, "version 1 of the protocol, and this program speaks 2"));
}

TEST(RemoteArm, TicksAtTheRateOfWhoAsks) {
  SharedArm far;
  Client client(far, 500);
  EXPECT_TRUE(comes([&] { return client.tick(Vec3::Zero()); }));
  const std::int64_t from_ns = client.sample.time_ns;
  int samples = 0;
  for (std::int64_t last_ns = from_ns; samples < 200;) {
    if (!client.tick(Vec3::Zero()) || client.sample.time_ns == last_ns) continue;
    last_ns = client.sample.time_ns;
    ++samples;
  }
  EXPECT_TRUE(says(client.arm->fixedRateReason(), "keeps the rate"));
  EXPECT_TRUE(says(client.arm->listing().front(), "500 Hz"));
}

// What strangers send over a line that stands changes nothing for who has the arm.
TEST(RemoteArm, WhateverElseComesIsIgnored) {
  SharedArm far;
  Client client(far);
  ASSERT_TRUE(client.push());
  const auto wire = connectTo(far.endpoint(), 3000);
  ASSERT_TRUE(wire);
  for (int message = 0; message < 50; ++message) {
    wire.value()->send(Bytes(static_cast<std::size_t>(message * 13 % 200), static_cast<std::uint8_t>(message)));
    wire.value()->send(bytesOf(ForceMessage{1U << 20U, 1U << 20U, Vec3(0.0, 0.8, 0.0), true}));
    wire.value()->send(bytesOf(Bye{}));
    client.tick();
    ASSERT_EQ(far.arm.force_N().y(), 0.0);
  }
  EXPECT_TRUE(client.push());
}

// 20 ms each way: the force comes, late, and stays.
TEST(RemoteArm, BearsADelay) {
  SharedArm far;
  far.cable().delay(20.0, 1.0);
  Client client(far);
  EXPECT_TRUE(client.push());
}

TEST(Remote, IsNotSharedWithOthersAsLongAsNobodyIsAllowed) {
  test::ArmDouble arm;
  ShareOptions options{{"0.0.0.0", 0}, test::SharedArm().stranger(), {}, arm.preset()};
  const auto share = Share::open(std::make_unique<test::ArmDouble::Port>(arm), options, [](const std::string&) {});
  ASSERT_FALSE(share);
  EXPECT_TRUE(says(share.problems().front().sentence, "Nobody's key is allowed"));
}

TEST(Remote, TellsWhoAsksWhatIsSharedWithoutOpeningIt) {
  SharedArm far;
  Client client(far);
  const Result<Welcome> what = queryArm(far.endpoint(), 3000);
  ASSERT_TRUE(what) << what.problems().front().sentence;
  EXPECT_EQ(what.value().title, "Double");
  EXPECT_TRUE(what.value().allows_force);
  EXPECT_EQ(what.value().arm.preset, "omni-thesis");
  EXPECT_TRUE(client.push()) << "it is still that one's";
}

TEST(Remote, TheArmIsCutWhereItsTicksStandStill) {
  SharedArm far;
  EXPECT_TRUE(comes([&] { return far.told().empty(); }));
  EXPECT_EQ(far.arm.cuts(), 0);
  far.arm.hang(true);
  EXPECT_TRUE(comes([&] { return far.arm.cuts() > 0; }));
  far.arm.hang(false);
}

}  // namespace underact::device::remote
