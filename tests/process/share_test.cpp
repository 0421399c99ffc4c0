// The program that shares an arm is asked to end, loses its terminal or its reader, is killed, or its guard is: what
// the arm is told then.
#include "device/remote/share.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <optional>

#include "device/remote/remote_arm.h"
#include "tests/process/own_guard.h"
#include "tests/process/wired_program.h"
#include "tests/support/comes.h"
#include "tests/support/processes.h"
#include "tests/support/scratch_folder.h"

namespace underact {
namespace {

using device::remote::KeyFolder;
using device::remote::RemoteArm;
using test::comes;

constexpr const char* kEnd = "Zero force. The arm is no longer shared.";

/// A program that has the arm and pushes, tick after tick, until it goes.
class Seat {
 public:
  Seat(const std::string& address, const KeyFolder& keys) {
    const Result<device::remote::Address> where = device::remote::readAddress(address);
    const Result<device::remote::Endpoint> endpoint = device::remote::endpointOf(where.value(), keys);
    EXPECT_TRUE(endpoint);
    auto opened = RemoteArm::open(endpoint.value(), *arm::findPreset(arm::kDefaultArm), 1000);
    EXPECT_TRUE(opened) << opened.problems().front().sentence;
    if (opened) arm_ = std::move(opened).value();
    if (arm_) thread_ = std::thread(&Seat::run, this);
  }
  ~Seat() {
    ends_ = true;
    if (thread_.joinable()) thread_.join();
  }
  bool isIn() const { return arm_ != nullptr; }

 private:
  void run() {
    safety::GateState state;
    state.level = 1.0;
    const safety::GatedForce force = safety::gate({5.0}, state, {Vec3(0.5, 0.0, 0.0), true, false, {}}, 0.001).force;
    for (arm::Sample sample; !ends_;) {
      arm_->read(sample);
      arm_->write(force);
    }
  }
  std::unique_ptr<RemoteArm> arm_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

/// share-arm with an arm behind a wire, and one who pushes with it.
class SharedWire : public testing::Test {
 protected:
  SharedWire() { ::setenv("UNDERACT_KEYS", keys_.path().c_str(), 1); }
  ~SharedWire() override { ::unsetenv("UNDERACT_KEYS"); }
  void share(bool terminal = false) {
    program_.emplace(UNDERACT_SHARING_PROGRAM,
                     std::vector<std::string>{"share-arm", "--force", "--device", "wire", "--listen", "127.0.0.1:0"},
                     terminal);
    const std::string line = program_->lineWith("--device remote:");
    address_ = line.substr(line.find("remote:") + 7);
    while (!address_.empty() && address_.back() < ' ') address_.pop_back();  // of a terminal
    sitDown();
  }
  void sitDown() {
    seat_.reset();
    seat_ = std::make_unique<Seat>(address_, KeyFolder(keys_.path()));
    ASSERT_TRUE(seat_->isIn());
    ASSERT_TRUE(comes([&] { return pushes(); }));
  }
  bool pushes() { return program_->arm().last_N() > 0.1; }
  bool rests() { return program_->arm().last_N() == 0.0; }
  pid_t guardBut(pid_t other = -1) {
    pid_t found = -1;
    comes([&] {
      for (const pid_t one : test::childrenOf(program_->pid(), "underact-guard")) found = one == other ? found : one;
      return found > 0;
    });
    return found;
  }
  void expectCleanEnd() {
    int status = -1;
    ASSERT_TRUE(program_->ends(status));
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(comes([&] { return rests(); }));
  }

  test::ScratchFolder keys_;
  std::optional<test::WiredProgram> program_;
  std::string address_;
  std::unique_ptr<Seat> seat_;
};

}  // namespace

TEST_F(SharedWire, WhateverAsksItToEndEndsItWithZeroForceAndItsWords) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    SCOPED_TRACE(signal);
    share();
    program_->send(signal);
    EXPECT_EQ(program_->lineWith(kEnd), kEnd);
    expectCleanEnd();
    seat_.reset();
  }
}

TEST_F(SharedWire, ATerminalThatIsClosedEndsItWithZeroForce) {
  share(true);
  program_->closeOutput();
  expectCleanEnd();
}

TEST_F(SharedWire, GoesOnWhenNobodyReadsItAnyMore) {
  share();
  program_->send(SIGPIPE);
  program_->closeOutput();
  sitDown();  // two lines for nobody
  sitDown();
  program_->send(SIGTERM);
  expectCleanEnd();
}

TEST_F(SharedWire, AReaderWhoPausesHoldsUpNothing) {
  share();
  program_->fillOutput();
  for (int times = 0; times < 30; ++times) sitDown();  // three lines each
  seat_.reset();
  EXPECT_TRUE(comes([&] { return rests(); }));
  sitDown();
  program_->send(SIGTERM);
  expectCleanEnd();
}

TEST_F(SharedWire, KilledItLeavesZeroForceByTheGuardsWord) {
  share();
  program_->send(SIGKILL);
  program_->waitUntilGone();
  EXPECT_TRUE(comes([&] { return rests(); })) << program_->arm().last_N() << " N for good";
}

TEST_F(SharedWire, StoppedItLeavesZeroForceByTheGuardsWord) {
  share();
  program_->send(SIGSTOP);
  EXPECT_TRUE(comes([&] { return rests(); })) << program_->arm().last_N() << " N for good";
}

TEST_F(SharedWire, AKilledGuardIsMissedAndTheNextOneSaysTheLastWord) {
  share();
  const pid_t first = guardBut();
  ASSERT_GT(first, 0);
  ASSERT_EQ(::kill(first, SIGKILL), 0);
  const pid_t second = guardBut(first);
  ASSERT_GT(second, 0);
  EXPECT_EQ(program_->lineWith("was replaced"), "The arm's guard had ended and was replaced by another one.");
  ASSERT_TRUE(comes([&] { return pushes(); }));  // where the machine is busy, a force may just have come too late
  program_->send(SIGKILL);
  program_->waitUntilGone();
  EXPECT_TRUE(comes([&] { return rests(); })) << program_->arm().last_N() << " N for good";
}

TEST(SharedArm, OfWhichNoGuardStartsAtAnotherRateSaysSoAndThenThatOneIsBack) {
  const test::ScratchFolder keys;
  const KeyFolder folder(keys.path());
  const test::OwnGuard own;
  int wire[2];
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, wire), 0);
  const test::WiredArm arm(wire[0]);
  device::remote::ShareOptions options{
      device::remote::readAddress("127.0.0.1:0").value(), folder.own().value(), {}, *arm::findPreset(arm::kDefaultArm)};
  options.guard_program = own.path();
  std::mutex mutex;
  std::string told;
  const auto isSignificant = [&](const char* words) {
    const std::scoped_lock lock(mutex);
    return told.find(words) != std::string::npos;
  };
  auto share =
      device::remote::Share::open(std::make_unique<test::WirePort>(wire[1]), options, [&](const std::string& sentence) {
        const std::scoped_lock lock(mutex);
        told += sentence + "\n";
      });
  ASSERT_TRUE(share);
  EXPECT_TRUE(isSignificant("A guard watches the arm"));
  own.hide();
  {
    const auto endpoint = device::remote::endpointOf(share.value()->address(), folder);
    ASSERT_TRUE(endpoint);
    const auto seat = RemoteArm::open(endpoint.value(), options.arm, 500);
    ASSERT_TRUE(seat);
    EXPECT_TRUE(comes([&] { return isSignificant("Nothing guards the arm"); })) << told;
    own.bringBack();
  }
  EXPECT_TRUE(comes([&] { return isSignificant("was replaced by another one"); })) << told;  // at its own rate again
  share.value().reset();
  ::close(wire[1]);
}

}  // namespace underact
