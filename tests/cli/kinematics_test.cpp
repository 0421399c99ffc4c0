#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/arm/model.h"
#include "core/json/json.h"
#include "tests/cli/session.h"
#include "tests/core/arm/golden.h"
#include "tests/support/arm_files.h"

namespace underact::test {
namespace {

using cli::Exit;
using json::Value;

/// A part of a file, as text: lists of numbers only.
std::string numbersText(const Value& value) {
  if (value.kind == json::JsonKind::Number) return json::numberText(value.number);
  std::string list;
  for (const Value& item : value.items) list += (list.empty() ? "" : ", ") + numbersText(item);
  return "[" + list + "]";
}

/// A line {"KEY": field} of each case of a golden file.
std::string linesFrom(const Value& file, const char* key, const char* field) {
  std::string text;
  for (const Value& one : file.find("cases")->items) {
    text += std::string("{\"") + key + "\": " + numbersText(*one.find(field)) + "}\n";
  }
  return text;
}

std::vector<Value> commandAnswers(const std::vector<std::string>& command, const std::string& in,
                                  Exit exit = Exit::Success) {
  const Outcome outcome = runCli(command, in);
  EXPECT_EQ(outcome.exit, exit) << outcome.err;
  return lines(outcome.out);
}

double furthest(const Value& a, const Value& b) {  // of lists of numbers of the same shape
  if (a.kind == json::JsonKind::Number && b.kind == json::JsonKind::Number) return std::abs(a.number - b.number);
  if (a.items.size() != b.items.size()) return kInfinity;
  double furthest_so_far = 0.0;
  for (std::size_t index = 0; index < a.items.size(); ++index) {
    furthest_so_far = std::max(furthest_so_far, furthest(a.items[index], b.items[index]));
  }
  return furthest_so_far;
}

constexpr const char* kJoints = R"({"q_rad": [0.1, 0.5, 0.2, 0.3, 1.0, 0.4]})";

/// Joints within the limits of an arm, as a line.
std::string jointLine(const arm::Model& model) {
  std::string list;
  for (std::size_t i = 0; i < model.rows.size(); ++i) {
    const bool turns = model.rows[i].type == chain::JointType::Revolute;
    const double low = std::max(model.rows[i].min, -1.0), high = std::min(model.rows[i].max, 1.3);
    const double value = low + (0.3 + 0.1 * static_cast<double>(i)) * (high - low);
    list += (i == 0 ? "" : ", ") + json::numberText(turns ? value : 1e3 * value);
  }
  return "{\"q_rad\": [" + list + "]}\n";
}

}  // namespace

TEST(KinematicsCommands, ForwardMeetsTheGoldenPoses) {
  const Value file = golden("fk.json");
  const std::vector<Value> poses = commandAnswers({"fk"}, linesFrom(file, "q_rad", "q"));
  const std::vector<Value>& cases = file.find("cases")->items;
  ASSERT_EQ(poses.size(), cases.size());
  for (std::size_t index = 0; index < cases.size(); ++index) {
    EXPECT_LE(furthest(*poses[index].find("X_WT"), *cases[index].find("T")), 1e-10) << index;  // mm
  }
}

TEST(KinematicsCommands, InverseGivesTheCountsOfTheGoldenPosesAndEachReachesItsPose) {
  const Value file = golden("ik.json");
  const std::vector<Value> all = commandAnswers({"ik"}, linesFrom(file, "X_WT", "T"));
  const std::vector<Value>& cases = file.find("cases")->items;
  ASSERT_EQ(all.size(), cases.size());
  std::string joints;
  std::vector<std::size_t> owner;
  for (std::size_t index = 0; index < cases.size(); ++index) {
    const std::string& status = cases[index].find("status")->text;
    EXPECT_EQ(all[index].find("reachable")->boolean, status != "unreachable");
    EXPECT_EQ(all[index].find("singular")->boolean, status != "unreachable" && status != "regular") << status;
    const Value& solutions = *all[index].find("solutions");
    EXPECT_EQ(solutions.items.size(), cases[index].find("solutions")->items.size()) << status;
    for (const Value& one : solutions.items) {
      joints += "{\"q_rad\": " + numbersText(*one.find("q_rad")) + "}\n";
      owner.push_back(index);
      for (const char* part : {"shoulder", "elbow", "wrist"}) {
        EXPECT_EQ(std::abs(one.find("branch")->find(part)->number), 1.0);
      }
      if (status == "regular") {
        EXPECT_EQ(one.find("family")->kind, json::JsonKind::Null);
      }
      if (status == "shoulder_singular") {
        EXPECT_EQ(one.find("family")->text, "q1 free");
      }
    }
  }
  const std::vector<Value> again = commandAnswers({"fk"}, joints);
  ASSERT_EQ(again.size(), owner.size());
  for (std::size_t index = 0; index < again.size(); ++index) {
    EXPECT_LE(furthest(*again[index].find("X_WT"), *cases[owner[index]].find("T")), 1e-9) << index;  // mm
  }
}

TEST(KinematicsCommands, JacobianMeetsTheGoldenFile) {
  const Value file = golden("jacobian.json");
  const std::vector<Value> all = commandAnswers({"jacobian"}, linesFrom(file, "q_rad", "q"));
  const std::vector<Value>& cases = file.find("cases")->items;
  ASSERT_EQ(all.size(), cases.size());
  for (std::size_t index = 0; index < cases.size(); ++index) {
    EXPECT_LE(furthest(*all[index].find("J"), *cases[index].find("J")), 1e-12) << index;  // mm/rad
    EXPECT_NEAR(all[index].find("det_Jp")->number, cases[index].find("det_Jp")->number, 1e-8);
    EXPECT_NEAR(all[index].find("manipulability_Jp")->number, cases[index].find("manipulability_Jp")->number, 1e-8);
    const Value& wanted = *cases[index].find("cond_Jp");
    const Value& condition = *all[index].find("condition_Jp");
    ASSERT_EQ(condition.kind, wanted.kind) << index;
    if (wanted.kind == json::JsonKind::Number) {
      EXPECT_NEAR(condition.number / wanted.number, 1.0, 1e-12 * wanted.number);
    }
    const bool at_position = wanted.kind == json::JsonKind::Null;
    EXPECT_EQ(!all[index].find("singular")->items.empty(),
              at_position || cases[index].find("near_singular_J6")->boolean)
        << index;
  }
}

TEST(KinematicsCommands, ABadLineIsAnsweredAndTheOthersAllTheSame) {
  const std::string in = std::string(kJoints) + "\n[]\n{\"q_rad\": [1, 2]}\n{\"q\": [0,0,0,0,0,0]}\nnonsense\n" +
                         kJoints + "\n{\"q_rad\": [0,0,0,0,0,1e400]}\n";
  const std::vector<Value> all = commandAnswers({"fk"}, in, Exit::BadInput);
  ASSERT_EQ(all.size(), 7U);
  EXPECT_NE(all[0].find("X_WT"), nullptr);
  for (const std::size_t bad : {1U, 2U, 3U, 4U, 6U}) {
    EXPECT_NE(all[bad].find("error"), nullptr) << bad;
    EXPECT_EQ(all[bad].find("line")->number, static_cast<double>(bad + 1));
  }
  EXPECT_NE(all[5].find("X_WT"), nullptr);
  const std::string mirror = "{\"X_WT\": [[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}\n";
  EXPECT_NE(commandAnswers({"ik"}, mirror, Exit::BadInput).at(0).find("error"), nullptr);
}

TEST(KinematicsCommands, EveryShippedArmGoesThereAndBackByEveryMethod) {
  for (const arm::Model& model : arm::models()) {
    const std::string joints = jointLine(model);
    const std::string there = runCli({"fk", "--arm", model.name}, joints).out;
    for (const char* method : {"auto", "closed_form", "iterative"}) {
      const bool has_form = model.rows.size() <= 6;  // of the shipped arms
      if (method == std::string("closed_form") && !has_form) continue;
      const bool iterated = method == std::string("iterative") || !has_form;
      const std::vector<Value> all = commandAnswers({"ik", "--arm", model.name, "--method", method}, there);
      ASSERT_EQ(all.size(), 1U);
      EXPECT_TRUE(all[0].find("reachable")->boolean) << model.name << " " << method;
      ASSERT_FALSE(all[0].find("solutions")->items.empty()) << model.name << " " << method;
      for (const Value& one : all[0].find("solutions")->items) {
        const std::string back =
            runCli({"fk", "--arm", model.name}, "{\"q_rad\": " + numbersText(*one.find("q_rad")) + "}\n").out;
        // The iteration stops within 1e-9 m = 1e-6 mm; the closed forms are far nearer.
        EXPECT_LE(furthest(*lines(back).at(0).find("X_WT"), *lines(there).at(0).find("X_WT")), iterated ? 2e-6 : 1e-9)
            << model.name << " " << method;
      }
      const json::JsonKind branch = all[0].find("solutions")->items[0].find("branch")->kind;
      EXPECT_EQ(branch, iterated ? json::JsonKind::Null : json::JsonKind::Object) << model.name << " " << method;
    }
  }
}

TEST(KinematicsCommands, AnArmCanBeAFileAndAnUnknownOneIsWrongUsage) {
  const std::string file = std::string(UNDERACT_SOURCE) + "/resources/arms/omni-thesis.json";
  EXPECT_EQ(runCli({"fk", "--arm", file}, std::string(kJoints) + "\n").out,
            runCli({"fk"}, std::string(kJoints) + "\n").out);
  const Outcome unknown = runCli({"fk", "--arm", "omni"}, "");
  EXPECT_EQ(unknown.exit, Exit::Usage);
  EXPECT_NE(unknown.err.find("touch-measured"), std::string::npos);
  EXPECT_EQ(runCli({"jacobian", "--arm", "./none.json"}, "").exit, Exit::File);
  EXPECT_EQ(runCli({"ik", "--method", "guess"}, "").exit, Exit::Usage);
}

/// Joint 1 of a haptic arm turns about the vertical, so that no weight turns it.
TEST(KinematicsCommands, AHapticArmHasItsWeightAgainstY) {
  std::string text = armFile("130");
  const std::string joint = "\"max_rad\": 1.25";
  text.insert(text.find(joint), "\"mass\": {\"mass_kg\": 0.1, \"center_mm\": [0, 60, 0]}, ");
  const ScratchFile file(text, "haptic.json");
  const Value answer = commandAnswers({"statics", "--arm", file.path()}, std::string(kJoints) + "\n").at(0);
  const std::vector<Value>& torques = answer.find("holding_N_mm")->items;
  EXPECT_NEAR(torques.at(0).number, 0.0, 1e-9);
  EXPECT_GT(std::abs(torques.at(1).number), 1.0);
}

TEST(KinematicsCommands, APoseCopiedWithSixDecimalsIsTakenAsTheNearestRotation) {
  const std::string line =
      R"({"X_WT": [[-0.538830, -0.828716, -0.151298, 20.7], [0.824928, -0.555470, 0.104633, -23.1], )"
      R"([-0.170752, -0.068430, 0.982935, 31.1], [0, 0, 0, 1]]})";
  const std::vector<Value> all = commandAnswers({"ik"}, line + "\n");
  EXPECT_EQ(all.at(0).find("solutions")->items.size(), 8U);
}

/// Two links above a turntable, each joint from 0 to a full turn; a camera of 1 kg is fixed to the first link.
constexpr const char* kTurntable = R"(<robot name="r">
  <link name="base"/><link name="l1"><inertial><mass value="1"/></inertial></link><link name="l2"/><link name="l3"/><link name="tool"/>
  <link name="camera"><inertial><mass value="1"/></inertial></link><link name="stand"/>
  <joint name="j1" type="revolute"><parent link="base"/><child link="l1"/><origin xyz="0 0 0.1"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="6.2832"/></joint>
  <joint name="j2" type="revolute"><parent link="l1"/><child link="l2"/><origin xyz="0 0 0.3"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="6.2832"/></joint>
  <joint name="j3" type="revolute"><parent link="l2"/><child link="l3"/><origin xyz="0 0 0.3"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="6.2832"/></joint>
  <joint name="f" type="fixed"><parent link="l3"/><child link="tool"/><origin xyz="0 0 0.2"/></joint>
  <joint name="c" type="fixed"><parent link="l1"/><child link="camera"/><origin xyz="0.2 0 0"/></joint>
  <joint name="s" type="fixed"><parent link="base"/><child link="stand"/></joint>
</robot>)";

TEST(KinematicsCommands, AnAngleSaidToBeWithinItsLimitsIs) {
  const ScratchFile file(kTurntable, "TURN.URDF");
  const std::string there = runCli({"fk", "--arm", file.path()}, "{\"q_rad\": [4.7, 5.9, 0.6]}\n").out;
  for (const char* method : {"closed_form", "iterative"}) {
    const Value all =
        commandAnswers({"ik", "--arm", file.path(), "--method", method, "--prefer", "[4.7, 5.9, 0.6]"}, there).at(0);
    const Value& first = all.find("solutions")->items.at(0);
    EXPECT_TRUE(first.find("within_limits")->boolean) << method;
    EXPECT_NEAR(first.find("q_rad")->items.at(0).number, 4.7, 1e-6) << method;
    EXPECT_NEAR(first.find("q_rad")->items.at(1).number, 5.9, 1e-6) << method;
  }
}

TEST(KinematicsCommands, TheTipThatIsTakenIsSaidAndAnotherCanBeNamed) {
  const ScratchFile file(kTurntable, "turn.xacro");
  const std::string q = "{\"q_rad\": [0, 0, 0]}\n";
  const Outcome taken = runCli({"statics", "--arm", file.path()}, q);
  EXPECT_NE(taken.err.find("note: tip: Link \"tool\" is taken as the tip."), std::string::npos) << taken.err;
  // The camera, 0.2 m in front of joint 1, weighs on it.
  EXPECT_NEAR(std::abs(lines(taken.out).at(0).find("holding_N_mm")->items.at(0).number), 200 * 9.80665, 1.0);
  const Outcome named = runCli({"fk", "--arm", file.path(), "--tip", "l3"}, q);
  EXPECT_EQ(named.err, "");
  EXPECT_NEAR(lines(named.out).at(0).find("X_WT")->items[2].items[3].number, 700, 1e-9);
}

TEST(KinematicsCommands, APoseOfFourDecimalsIsTakenWithANoteAndTwoAreNot) {
  const auto turned = [](const char* half) {
    const std::string h = half;
    return "{\"X_WT\": [[" + h + ", -" + h + ", 0, 30], [" + h + ", " + h + ", 0, 20], [0, 0, 1, 0], [0, 0, 0, 1]]}\n";
  };
  const Outcome four = runCli({"ik"}, turned("0.7071"));
  EXPECT_EQ(lines(four.out).at(0).find("solutions")->items.size(), 8U);
  EXPECT_NE(four.err.find("note: \"X_WT\": This matrix is 6.8e-06 off a rotation"), std::string::npos) << four.err;
  EXPECT_EQ(runCli({"ik"}, turned("0.7071068")).err, "");
  const Value two = commandAnswers({"ik"}, turned("0.71"), Exit::BadInput).at(0);
  EXPECT_NE(two.find("error")->text.find("0.0029 off the nearest one"), std::string::npos);
}

}  // namespace underact::test
