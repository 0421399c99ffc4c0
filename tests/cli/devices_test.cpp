#include <gtest/gtest.h>

#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;

TEST(Devices, AreListedWithWhatIsMissing) {
  const Outcome outcome = runCli({"devices"});
  EXPECT_EQ(outcome.exit, Exit::Well);
  EXPECT_NE(outcome.out.find("Simulated arm"), std::string::npos);
  EXPECT_NE(outcome.out.find("(--device simulated)"), std::string::npos);
  EXPECT_NE(outcome.out.find("WoodenHaptics"), std::string::npos);
}

TEST(Devices, AreObjectsForPrograms) {
  const Outcome outcome = runCli({"devices", "--json"});
  EXPECT_EQ(outcome.exit, Exit::Well);
  bool has_simulated = false;
  for (const json::Value& device : lines(outcome.out)) {
    EXPECT_FALSE(textAt(device, "kind").empty());
    EXPECT_FALSE(textAt(device, "title").empty());
    has_simulated = has_simulated || textAt(device, "device") == "simulated";
  }
  EXPECT_TRUE(has_simulated);
}

TEST(Devices, ThatDoNotExistAreRefusedWithThoseThatDo) {
  const Outcome outcome = runCli({"run", shipped("02_sphere.json"), "--seconds", "0.1", "--device", "toaster"});
  EXPECT_EQ(outcome.exit, Exit::Fault);
  EXPECT_NE(outcome.err.find("\"toaster\""), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("simulated, openhaptics, wooden"), std::string::npos) << outcome.err;
}

TEST(Devices, AreHeldByAPersonAndTheSimulatedArmByAHand) {
  const std::string scene = shipped("02_sphere.json");
  EXPECT_EQ(runCli({"run", scene, "--seconds", "0.1"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"run", scene, "--seconds", "0.1", "--device", "wooden", "--hand", "probe"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"run", scene, "--seconds", "0.1", "--device", "wooden", "--fast"}).exit, Exit::Usage);
}

// The whole way of an arm that is none of the simulation's: opened by its name, ticked by its driver's clock, recorded.
TEST(Devices, RunASceneByTheirOwnClock) {
  const ScratchFile csv("", "touch.csv");
  const std::string command = "UNDERACT_OPENHAPTICS=" UNDERACT_STAND_IN " " + program() + " run " +
                              shipped("02_sphere.json") +
                              " --seconds 0.3 --max-late 100000 --device openhaptics --record " + csv.path() + " 2>&1";
  ProcessOutcome outcome = shell(command);
  for (int again = 0; again < 2 && outcome.exit == 3; ++again) outcome = shell(command);  // a busy machine stood still
  EXPECT_EQ(outcome.exit, 0) << outcome.out;
  EXPECT_NE(outcome.out.find("by the arm's own clock"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\"ticks\": 300"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace underact::test
