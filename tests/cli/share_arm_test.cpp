#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "device/remote/arm_side.h"
#include "device/remote/share.h"
#include "tests/cli/process.h"
#include "tests/cli/session.h"
#include "tests/support/arm_double.h"
#include "tests/support/comes.h"
#include "tests/support/pattern.h"
#include "tests/support/scratch_folder.h"

namespace underact::test {
namespace {

using cli::Exit;

/// "remote:HOST:PORT", as the sharing program says how it is opened.
std::string deviceOf(const Process& shared) {
  EXPECT_TRUE(shared.says("--device remote:"));
  const std::vector<PatternMatch> found = matchesOf("remote:[0-9.]+:[0-9]+", shared.output());
  return found.empty() ? "" : found[0].groups[0];
}

std::vector<std::string> runOf(const std::string& device, const char* seconds) {
  return {"run", shipped("02_sphere.json"), "--seconds", seconds, "--max-late", "1000000", "--device", device};
}

class ShareArm : public testing::Test {
 protected:
  ShareArm() { setenv("UNDERACT_KEYS", (scratch.path() + "/keys").c_str(), 1); }
  ~ShareArm() override { unsetenv("UNDERACT_KEYS"); }
  ScratchFolder scratch;
};

TEST_F(ShareArm, PrintsTheLineThatTheOtherComputerNeeds) {
  const Outcome shown = runCli({"share-arm", "--show-key"});
  ASSERT_EQ(shown.exit, Exit::Success) << shown.err;
  const std::vector<PatternMatch> line = matchesOf("  underact-cli (share-arm --allow='[^']{40} [^']+')\n", shown.out);
  ASSERT_FALSE(line.empty()) << shown.out;
  // As it is, in a shell: whatever characters the key has.
  const ProcessOutcome allowed = shell(program() + " " + line[0].groups[1] + " 2>&1");
  EXPECT_EQ(allowed.exit, 0) << allowed.out;
  std::ifstream file(scratch.file("keys/arm_clients"));
  std::string key;
  file >> key;
  EXPECT_TRUE(says(shown.out, key)) << key;
  EXPECT_EQ(runCli({"share-arm", "--show-key"}).out, shown.out);
  EXPECT_NE(runCli({"share-arm", "--new-key"}).out, shown.out);
}

TEST_F(ShareArm, TakesEveryKeyThatCanBe) {
  for (const char first : std::string("-[{(<%$#@!*/?&=^:.+")) {
    const std::string key = first + std::string(39, '1');
    const Outcome outcome = runCli({"share-arm", "--trust=arm-pc:7878 " + key});
    if (outcome.exit == Exit::Success) {
      std::ifstream file(scratch.file("keys/arm_hosts"));
      std::string host, noted;
      file >> host >> noted;
      EXPECT_EQ(noted, key);
      EXPECT_TRUE(says(outcome.out, "--device remote:arm-pc:7878"));
    } else {
      EXPECT_TRUE(says(outcome.err, "is not a key")) << outcome.err;  // 5 characters beyond 32 bits
    }
  }
}

TEST_F(ShareArm, RefusesWhatCannotBe) {
  EXPECT_EQ(runCli({"share-arm", "--allow", "hello"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"share-arm", "--trust", "arm-pc"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"share-arm", "--listen", "a b"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"share-arm", "--arm", "toaster"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"share-arm", "--device", "remote"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"share-arm", "--device", "toaster"}).exit, Exit::Fault);
  const Outcome open = runCli({"share-arm", "--listen", "0.0.0.0:0", "--seconds", "0.1"});
  EXPECT_EQ(open.exit, Exit::Fault);
  EXPECT_TRUE(says(open.err, "Nobody's key is allowed")) << open.err;
  const Outcome unknown = runCli(runOf("remote:192.0.2.1", "0.1"));
  EXPECT_EQ(unknown.exit, Exit::Fault);
  EXPECT_TRUE(says(unknown.err, "is not known here")) << unknown.err;
  const Outcome nobody = runCli(runOf("remote:127.0.0.1:1", "0.1"));
  EXPECT_EQ(nobody.exit, Exit::Fault);
  EXPECT_TRUE(says(nobody.err, "No arm is shared at 127.0.0.1:1.")) << nobody.err;
}

TEST_F(ShareArm, LetsAnotherProgramPush) {
  Process shared(scratch, "shared", {"share-arm", "--force", "--listen", "127.0.0.1:0"});
  const std::string device = deviceOf(shared);
  EXPECT_TRUE(shared.says("Simulated arm is shared at 127.0.0.1:"));
  EXPECT_TRUE(says(shared.output(), ", with force, with passivity control."));
  Outcome outcome = runCli(runOf(device, "1"));
  for (int again = 0; again < 2 && outcome.exit == Exit::Fault; ++again) outcome = runCli(runOf(device, "1"));
  EXPECT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_GT(numberAt(lines(outcome.out).at(0), "peak_force_N"), 0.1);
  EXPECT_TRUE(shared.says("A program has the arm."));
  EXPECT_TRUE(shared.says("It pushes."));
  EXPECT_TRUE(shared.says("has released it. Zero force"));
  shared.kill(SIGINT);
  EXPECT_EQ(shared.end(), 0);
  EXPECT_TRUE(shared.says("Zero force. The arm is no longer shared."));
}

TEST_F(ShareArm, WithoutForceItOnlyShows) {
  Process shared(scratch, "shared", {"share-arm", "--listen", "127.0.0.1:0"});
  const Outcome outcome = runCli(runOf(deviceOf(shared), "0.5"));
  EXPECT_TRUE(outcome.exit == Exit::Success || says(outcome.out, "no_sample")) << outcome.err;
  EXPECT_TRUE(shared.says("A program has the arm, without force."));
  EXPECT_FALSE(says(shared.output(), "It pushes."));
}

TEST_F(ShareArm, AKilledProgramsForceEndsWithinFivePeriods) {
  Process shared(scratch, "shared", {"share-arm", "--force", "--listen", "127.0.0.1:0"});
  const std::string device = deviceOf(shared);
  Process client(scratch, "client", runOf(device, "60"));
  ASSERT_TRUE(shared.says("It pushes."));
  client.kill(SIGKILL);
  EXPECT_TRUE(shared.says("stopped sending. Zero force"));
  EXPECT_TRUE(shared.says("No force received: zero after "));
  for (const PatternMatch& pause :
       matchesOf("No force received: zero after ([0-9]+) more periods at most.", shared.output()))
    EXPECT_LT(std::stoi(pause.groups[1]), device::remote::kQuietPeriods);
  Process next(scratch, "next", runOf(device, "60"));
  EXPECT_TRUE(comes([&] {
    const std::string now = shared.output();
    return says(now.substr(now.find("stopped sending")), "It pushes.");
  })) << "it is free for the next";
}

TEST_F(ShareArm, WhenItIsKilledTheOtherProgramSaysWhy) {
  Process shared(scratch, "shared", {"share-arm", "--force", "--listen", "127.0.0.1:0"});
  Process client(scratch, "client", runOf(deviceOf(shared), "3"));
  ASSERT_TRUE(shared.says("It pushes."));
  shared.kill(SIGKILL);
  EXPECT_EQ(client.end(), 3);
  EXPECT_TRUE(client.says("The connection to the arm at 127.0.0.1:"));
  EXPECT_TRUE(client.says("then press Restart."));
  EXPECT_TRUE(client.says("\"kind\": \"no_sample\""));
}

TEST_F(ShareArm, AnotherUsersKeyIsTurnedAway) {
  Process shared(scratch, "shared", {"share-arm", "--force", "--listen", "127.0.0.1:0"});
  const std::string device = deviceOf(shared);
  std::ifstream file(scratch.file("keys/arm_key"));
  std::string key;
  file >> key;
  setenv("UNDERACT_KEYS", (scratch.path() + "/others").c_str(), 1);
  ASSERT_EQ(runCli({"share-arm", "--trust=" + device.substr(7) + " " + key}).exit, Exit::Success);
  const Outcome outcome = runCli(runOf(device, "0.1"));
  EXPECT_EQ(outcome.exit, Exit::Fault);
  EXPECT_TRUE(says(outcome.err, "your key is not known there")) << outcome.err;
  EXPECT_TRUE(shared.says("was refused"));
}

TEST_F(ShareArm, IsListedByANameThatCannotOperateATerminal) {
  ArmDouble arm;
  arm.title = "Omni\x1B]0;x\x07\u202E\nFORGED";
  const device::remote::KeyPair keys = device::remote::KeyFolder().own().value();
  const auto shared = device::remote::Share::open(std::make_unique<ArmDouble::Port>(arm),
                                                  {{}, keys, {keys.public_key}, arm.preset()}, [](const auto&) {});
  ASSERT_TRUE(shared) << shared.problems().front().sentence;
  const Outcome outcome = runCli({"devices"});
  EXPECT_TRUE(says(outcome.out, "\n  Omni ]0;x \\u202e FORGED, shared on this computer")) << outcome.out;
}

}  // namespace
}  // namespace underact::test
