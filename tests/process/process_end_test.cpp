#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "app/guard/watch.h"
#include "tests/process/wired_program.h"
#include "tests/support/comes.h"

namespace underact {
namespace {

using namespace std::chrono_literals;
using test::comes;

/// The servo at work on the arm, which dies in that way.
class Program : public test::WiredProgram {
 public:
  explicit Program(const std::string& ending, const std::string& guard = UNDERACT_GUARD)
      : WiredProgram(UNDERACT_DYING_PROGRAM, {guard, ending}) {}
};

void expectZeroAfterDeath(const std::string& ending, int signal) {
  Program program(ending);
  ASSERT_EQ(program.line(), "pushing");
  ASSERT_GT(program.arm().pushes(), 0) << "else there is nothing to end";
  if (signal != 0) program.send(signal);
  program.waitUntilGone();
  EXPECT_TRUE(comes([&] { return program.arm().last_N() == 0.0; })) << program.arm().last_N() << " N for good";
  const std::int64_t pushes = program.arm().pushes();
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(program.arm().pushes(), pushes);
}

}  // namespace

TEST(ProcessEnd, ASegmentationFaultLeavesZeroForce) {
  expectZeroAfterDeath("segv", 0);
}
TEST(ProcessEnd, AnAbortLeavesZeroForce) {
  expectZeroAfterDeath("abort", 0);
}
TEST(ProcessEnd, AnExitWithoutCleaningUpLeavesZeroForce) {
  expectZeroAfterDeath("exit", 0);
}
TEST(ProcessEnd, AKillLeavesZeroForce) {
  expectZeroAfterDeath("wait", SIGKILL);
}
TEST(ProcessEnd, ATerminationLeavesZeroForce) {
  expectZeroAfterDeath("wait", SIGTERM);
}
TEST(ProcessEnd, AnOrderlyEndLeavesZeroForceToo) {
  expectZeroAfterDeath("return", 0);
}

TEST(ProcessEnd, WithoutAGuardAKillLeavesTheForce) {  // what the tests above would see if there were none
  Program program("wait", "/there/is/none");
  ASSERT_EQ(program.line(), "pushing");
  program.send(SIGKILL);
  program.waitUntilGone();
  std::this_thread::sleep_for(300ms);
  EXPECT_GT(program.arm().last_N(), 0.1);
}

TEST(ProcessEnd, AProgramThatStandsStillPushesNoMoreAndSaysSoWhenItGoesOn) {
  Program program("wait");
  ASSERT_EQ(program.line(), "pushing");
  program.send(SIGSTOP);
  ASSERT_TRUE(comes([&] { return program.arm().last_N() == 0.0; }));
  std::this_thread::sleep_for(1s);
  EXPECT_EQ(program.arm().last_N(), 0.0);
  const std::int64_t pushes = program.arm().pushes();
  program.send(SIGCONT);
  EXPECT_EQ(program.line(), "fault stood_still");
  // A tick that was at work when it was stopped may still write what it had found, one frame; the arm may read that
  // frame after the line was read here. The tick after it is the fault's.
  const std::int64_t frames = program.arm().frames();
  ASSERT_TRUE(comes([&] { return program.arm().frames() > frames + 200; }));
  EXPECT_LE(program.arm().pushes(), pushes + 1);
  EXPECT_EQ(program.arm().last_N(), 0.0);
}

TEST(GuardDuty, IsReadFromItsTwoArgumentsAndNothingElse) {
  const auto read = [](std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "underact-guard");
    return guard::readDuty(static_cast<int>(arguments.size()), arguments.data());
  };
  ASSERT_TRUE(read({"100", "00ff4a"}));
  EXPECT_EQ(read({"100", "00ff4a"})->word, std::string("\0\xff\x4a", 3));
  EXPECT_EQ(read({"100", "00"})->limit_ns, 100);
  EXPECT_FALSE(read({}));
  EXPECT_FALSE(read({"100"}));
  EXPECT_FALSE(read({"0", "00"}));
  EXPECT_FALSE(read({"-5", "00"}));
  EXPECT_FALSE(read({"100x", "00"}));
  EXPECT_FALSE(read({"100", ""}));
  EXPECT_FALSE(read({"100", "0"}));
  EXPECT_FALSE(read({"100", "0g"}));
}

}  // namespace underact
