#include "core/arm/model.h"

#include <underact/arm_files.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/arm/forward.h"
#include "core/base/units.h"
#include "core/chain/kinematics.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

const std::string kRow = R"({"alpha_deg": 0, "a_mm": 0, "d_mm": 0})";
const std::string kIdentity = "[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]";

std::string armWith(const std::string& first_row, const std::string& X_WB = kIdentity, const std::string& more = "") {
  std::string text = R"({"underact_arm": 1, "name": "a", "title": "b", "provenance": "c", "dh": [)" + first_row;
  for (int row = 1; row < 6; ++row) text += ", " + kRow;
  return text + "], \"X_WB\": " + X_WB + more + "}";
}

/// "KEY: sentence" of the one problem; empty for none, "several" for more.
std::string problemOf(const std::string& text) {
  const Result<Model> read = readArm(text, "a.json");
  if (read) return "";
  if (read.problems().size() != 1) return "several";
  return read.problems()[0].place.key + ": " + read.problems()[0].sentence;
}

}  // namespace

TEST(Model, EachShippedFileCanBeReadAndIsFoundByItsName) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(UNDERACT_SOURCE "/resources/arms")) {
    ++files;
    const Result<Model> read = readArmFile(entry.path().string());
    ASSERT_TRUE(read) << entry.path() << describe(read.problems()[0]);
    EXPECT_EQ(read.value().name, entry.path().stem().string());
    EXPECT_NE(read.value().provenance, "");
    ASSERT_NE(findModel(read.value().name), nullptr);
    for (const chain::DhRow& row : read.value().rows) EXPECT_LT(row.min, row.max);
  }
  EXPECT_EQ(models().size(), files);
  EXPECT_EQ(std::size(kArmFiles), files);
  EXPECT_EQ(presets().size(), 3U);  // omni-thesis, touch-measured, woodenhaptics
  EXPECT_EQ(sceneArms().size(), 13U);
}

TEST(Model, TheTableOfTheThesisIsItsStraightLineCode) {  // two derivations: rows of the table, and eq. 3.5 and 3.6
  test::Random random(test::Seed{20070441});
  for (const char* name : {"omni-thesis", "touch-measured", "woodenhaptics"}) {
    const Model& model = *findModel(name);
    const std::optional<Geometry> geometry = omniGeometry(model);
    ASSERT_TRUE(geometry);
    for (int i = 0; i < 1000; ++i) {
      JointAngles q_rad{};
      for (double& angle_rad : q_rad) angle_rad = random.between(-kPi, kPi);
      const Pose X_WT = tipPose(*geometry, q_rad);
      ASSERT_LE((linkFrames(model, q_rad)[5].matrix() - X_WT.matrix()).cwiseAbs().maxCoeff(), 2e-15);
      ASSERT_LE((chain::forward(model.chain, q_rad).matrix() - X_WT.matrix()).cwiseAbs().maxCoeff(), 2e-15);
    }
  }
}

TEST(Model, AnArmOfAnotherShapeHasNoStraightLineCode) {
  Model model = *findModel("omni-thesis");
  ASSERT_TRUE(omniGeometry(model));
  Model other = model;
  other.rows[1].d_m = 0.01;
  EXPECT_FALSE(omniGeometry(other));
  other = model;
  other.rows[4].alpha_rad = kPi / 2;
  EXPECT_FALSE(omniGeometry(other));
  other = model;
  other.X_WB.linear() = Mat3::Identity();
  EXPECT_FALSE(omniGeometry(other));
  other = model;
  other.X_NT.translation().z() = 0.01;
  EXPECT_FALSE(omniGeometry(other));
}

TEST(ArmFile, TakesTheRotationThatFewDecimalsMeanWithANote) {
  const Result<Model> read =
      readArm(armWith(kRow, "[[0.7071, -0.7071, 0, 0], [0.7071, 0.7071, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]"), "a.json");
  ASSERT_TRUE(read) << read.problems()[0].sentence;
  const Mat3 R = read.value().X_WB.linear();
  EXPECT_LE((R - Eigen::AngleAxisd(kPi / 4, Vec3::UnitZ()).toRotationMatrix()).cwiseAbs().maxCoeff(), 1e-15);
  ASSERT_EQ(read.value().notes.size(), 1u);
  EXPECT_EQ(read.value().notes[0].place.key, "X_WB");
  EXPECT_TRUE(readArm(armWith(kRow), "a.json").value().notes.empty());
}

TEST(ArmFile, NamesWhatIsWrongAndWhere) {
  EXPECT_EQ(problemOf(armWith(kRow)), "");
  EXPECT_NE(problemOf(armWith(R"({"alpha_deg": 0, "a_mm": 0})")).find("dh[0].d_mm: The key \"d_mm\" is missing"),
            std::string::npos);
  EXPECT_NE(problemOf(armWith(R"({"alpha_deg": 0, "a_mm": 2e6, "d_mm": 0})")).find("dh[0].a_mm: A length"),
            std::string::npos);
  EXPECT_NE(problemOf(armWith(R"({"alpha_deg": 0, "a_mm": 0, "d_mm": 0, "min_deg": 5, "max_deg": 5})")).find("dh[0]: "),
            std::string::npos);
  EXPECT_NE(
      problemOf(armWith(R"({"alpha_deg": 0, "a_mm": 0, "d_mm": 0, "limits_of_size": true})")).find("Only joint 5"),
      std::string::npos);
  EXPECT_NE(problemOf(armWith(kRow, "[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]]"))
                .find("not a rotation matrix"),
            std::string::npos);
  EXPECT_NE(problemOf(armWith(kRow, "[[1, 0], [0, 1]]")).find("X_WB: This must be a list of 4 rows"),
            std::string::npos);
  EXPECT_NE(problemOf(armWith(kRow, kIdentity, ", \"tool\": 1")).find("not known in an arm file"), std::string::npos);
  EXPECT_NE(
      problemOf(armWith(kRow, kIdentity, R"(, "device": {"continuous_force_N": 1, "encoder_counts_per_turn": [1, 1]})"))
          .find("This must be a list of 6 numbers, one for each joint."),
      std::string::npos);
  EXPECT_NE(problemOf(armWith(R"({"alpha_deg": 0, "a_mm": 0, "d_mm": 0, "max_deg": 5, "rest_deg": 6})"))
                .find("The joint's rest must be within its limits"),
            std::string::npos);
  EXPECT_NE(problemOf(armWith(R"({"alpha_deg": 0, "a_mm": 0, "d_mm": 0, "rest_mm": 6})"))
                .find("rests at an angle: \"rest_deg\""),
            std::string::npos);
  EXPECT_NE(problemOf(R"({"underact_arm": 2, "name": "a", "title": "b", "provenance": "c", "dh": [], "X_WB": )" +
                      kIdentity + "}"),
            "");
  EXPECT_FALSE(readArm("[", "a.json"));
  EXPECT_FALSE(readArmFile("/dev/null/nowhere/arm.json"));
}

}  // namespace underact::arm
