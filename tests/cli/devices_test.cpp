#include <gtest/gtest.h>

#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;

TEST(Devices, AreListedWithWhatIsMissing) {
  const Outcome outcome = runCli({"devices"});
  EXPECT_EQ(outcome.exit, Exit::Success);
  EXPECT_NE(outcome.out.find("Simulated arm"), std::string::npos);
  EXPECT_NE(outcome.out.find("(--device simulated)"), std::string::npos);
  EXPECT_NE(outcome.out.find("WoodenHaptics"), std::string::npos);
}

TEST(Devices, AreObjectsForPrograms) {
  const Outcome outcome = runCli({"devices", "--json"});
  EXPECT_EQ(outcome.exit, Exit::Success);
  bool has_simulated = false;
  for (const json::Value& device : lines(outcome.out)) {
    EXPECT_FALSE(textAt(device, "kind").empty());
    EXPECT_FALSE(textAt(device, "title").empty());
    has_simulated = has_simulated || textAt(device, "device") == "simulated";
  }
  EXPECT_TRUE(has_simulated);
}

TEST(Devices, RefusesAnUnknownKindAndListsTheKnownOnes) {
  const Outcome outcome = runCli({"run", shipped("02_sphere.json"), "--seconds", "0.1", "--device", "toaster"});
  EXPECT_EQ(outcome.exit, Exit::Fault);
  EXPECT_NE(outcome.err.find("\"toaster\""), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("simulated, openhaptics, wooden, haply, remote"), std::string::npos) << outcome.err;
}

TEST(Devices, AreTriedWithoutForceForAReport) {
  const Outcome outcome = runCli({"devices", "--report", "simulated", "--seconds", "0.3", "--words", "It felt round."});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_NE(outcome.out.find("Arm: simulated, Simulated arm\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("Remarks: It felt round.\n"), std::string::npos);
  EXPECT_NE(outcome.out.find("without a sample: 0"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("Joint 6: "), std::string::npos);
  EXPECT_NE(outcome.out.find("Trouble: none"), std::string::npos);
  EXPECT_EQ(runCli({"devices", "--report", "toaster"}).exit, Exit::Fault);
  EXPECT_EQ(runCli({"devices", "--out", "x.txt"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"devices", "--report", "simulated", "--seconds", "0.1", "--out", "/nowhere/x.txt"}).exit,
            Exit::File);
}

// What the driver says of the arm itself is in the report of a real one.
TEST(Devices, ReportWhatTheArmSaysOfItself) {
  const ScratchPath report("report.txt");
  const ProcessOutcome outcome = shell("UNDERACT_OPENHAPTICS='" UNDERACT_STAND_IN "' " + program() +
                                       " devices --report openhaptics --seconds 0.3 --out " + report.path() + " 2>&1");
  EXPECT_EQ(outcome.exit, 0) << outcome.out;
  const std::string text = shell("cat " + report.path()).out;
  EXPECT_NE(text.find("Not yet tested on hardware."), std::string::npos) << text;
  EXPECT_NE(text.find("What the arm reports about itself:\n"), std::string::npos) << text;
  EXPECT_NE(text.find("by the arm's own clock"), std::string::npos) << text;
}

TEST(Devices, AreHeldByAPersonAndTheSimulatedArmByAHand) {
  const std::string scene = shipped("02_sphere.json");
  EXPECT_EQ(runCli({"run", scene, "--seconds", "0.1"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"run", scene, "--seconds", "0.1", "--device", "wooden", "--hand", "probe"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"run", scene, "--seconds", "0.1", "--device", "wooden", "--fast"}).exit, Exit::Usage);
}

// The whole way of an arm that is none of the simulation's: opened by its name, ticked by its driver's clock, recorded.
TEST(Devices, RunASceneByTheirOwnClock) {
  const ScratchPath csv("touch.csv");
  const std::string command =
      "UNDERACT_OPENHAPTICS='" UNDERACT_STAND_IN "' " + program() + " run " + shipped("02_sphere.json") +
      " --seconds 0.3 --max-late 100000 --device openhaptics --overwrite --record " + csv.path() + " 2>&1";
  ProcessOutcome outcome = shell(command);
  for (int again = 0; again < 2 && outcome.exit == 3; ++again) outcome = shell(command);  // a busy machine stood still
  EXPECT_EQ(outcome.exit, 0) << outcome.out;
  EXPECT_NE(outcome.out.find("by the arm's own clock"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\"ticks\": 300"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace underact::test
