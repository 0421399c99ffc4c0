#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <sstream>

#include "core/json/json.h"
#include "tests/cli/session.h"
#include "tests/support/constraint_vectors.h"

namespace underact::test {
namespace {

using cli::Exit;

using json::Value;

constexpr const char* kSphere = R"({"name": "ball", "type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 50})";

/// The sceneAnswers of a scene to lines.
std::vector<Value> sceneAnswers(const std::string& scene, const std::string& in, Exit exit = Exit::Success) {
  const ScratchFile file(scene);
  const Outcome outcome = runCli({"target", file.path()}, in);
  EXPECT_EQ(outcome.exit, exit) << outcome.err;
  return lines(outcome.out);
}

Value answer(const std::string& scene, const std::string& line) {
  const std::vector<Value> all = sceneAnswers(scene, line + "\n");
  EXPECT_EQ(all.size(), 1U);
  return all.empty() ? Value{} : all[0];
}

TEST(Target, ByHandTheSphereDrawsTheStylusOutAndTheGateCuts) {
  const Value one = answer(sceneText(kSphere), R"({"p_mm": [30, 0, 0]})");
  EXPECT_NEAR((vectorAt(one, "q_mm") - Vec3(50, 0, 0)).norm(), 0.0, 1e-13);
  EXPECT_NEAR((vectorAt(one, "force_N") - Vec3(10, 0, 0)).norm(), 0.0, 1e-13);  // 0.5 N/mm, 20 mm
  EXPECT_NEAR((vectorAt(one, "safe_force_N") - Vec3(0.88, 0, 0)).norm(), 0.0, 1e-15);
  EXPECT_EQ(textAt(one, "status"), "unique");
  const Value& constraint = one.find("constraints")->items.at(0);
  EXPECT_EQ(textAt(constraint, "name"), "ball");
  EXPECT_EQ(vectorAt(constraint, "q_mm"), vectorAt(one, "q_mm"));
  EXPECT_EQ(vectorAt(constraint, "force_N"), vectorAt(one, "force_N"));
  EXPECT_EQ(textAt(constraint, "status"), "unique");
}

TEST(Target, BelowTheLimitTheSafeForceIsTheForce) {
  const Value one = answer(sceneText(kSphere), R"({"p_mm": [0, 0, 51]})");
  EXPECT_EQ(vectorAt(one, "safe_force_N"), vectorAt(one, "force_N"));
  EXPECT_NEAR(vectorAt(one, "force_N").z(), -0.5, 1e-13);
}

TEST(Target, TheCentreIsDegenerateAndPullsNowhere) {
  const Value one = answer(sceneText(kSphere), R"({"p_mm": [0, 0, 0]})");
  EXPECT_EQ(textAt(one, "status"), "degenerate");
  EXPECT_TRUE(isNullAt(one, "q_mm"));
  EXPECT_EQ(vectorAt(one, "force_N"), Vec3(0, 0, 0));
  EXPECT_EQ(vectorAt(one, "safe_force_N"), Vec3(0, 0, 0));
}

TEST(Target, ACentreOffTheOriginIsDegenerateForTheSameNumbersInTheLine) {
  const std::string sphere = R"({"type": "sphere", "center_mm": [10.1, -20.7, 30.3], "radius_mm": 25.5})";
  EXPECT_EQ(textAt(answer(sceneText(sphere), R"({"p_mm": [10.1, -20.7, 30.3]})"), "status"), "degenerate");
}

TEST(Target, AnUntouchedWallIsFree) {
  const std::string wall = R"({"type": "plane", "point_mm": [0, 0, 0], "normal": [0, 1, 0], "side": "outside"})";
  const std::vector<Value> all = sceneAnswers(sceneText(wall), "{\"p_mm\": [0, 5, 0]}\n{\"p_mm\": [0, -1, 0]}\n");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(textAt(all[0], "status"), "free");
  EXPECT_TRUE(isNullAt(all[0], "q_mm"));
  EXPECT_EQ(vectorAt(all[0], "force_N"), Vec3(0, 0, 0));
  EXPECT_EQ(textAt(all[1], "status"), "unique");
  EXPECT_NEAR(vectorAt(all[1], "force_N").y(), 0.5, 1e-13);
}

constexpr const char* kTwoPoints = R"({"name": "left", "type": "point", "position_mm": [-10, 0, 0]},
                                      {"name": "right", "type": "point", "position_mm": [10, 0, 0]})";

TEST(Target, SeveralConstraintsAddUpAndHaveNoCommonPoint) {
  const Value one = answer(sceneText(kTwoPoints), R"({"p_mm": [4, 2, 0]})");
  EXPECT_TRUE(isNullAt(one, "q_mm"));
  EXPECT_EQ(textAt(one, "status"), "unique");
  EXPECT_NEAR((vectorAt(one, "force_N") - Vec3(-4, -2, 0)).norm(), 0.0, 1e-13);
  ASSERT_EQ(one.find("constraints")->items.size(), 2U);
  EXPECT_NEAR((vectorAt(one.find("constraints")->items[0], "q_mm") - Vec3(-10, 0, 0)).norm(), 0.0, 1e-13);
  EXPECT_EQ(textAt(one.find("constraints")->items[1], "name"), "right");
}

TEST(Target, OfTheNearestOneAloneWhereTheSceneSaysSo) {
  const Value one = answer(sceneText(kTwoPoints, R"("combine": "nearest", )"), R"({"p_mm": [4, 2, 0]})");
  EXPECT_NEAR((vectorAt(one, "force_N") - Vec3(3, -1, 0)).norm(), 0.0, 1e-13);
  const std::vector<Value>& constraints = one.find("constraints")->items;
  EXPECT_EQ(vectorAt(constraints.at(0), "force_N"), Vec3(0, 0, 0));
  EXPECT_FALSE(constraints.at(0).find("acts")->boolean);
  EXPECT_TRUE(constraints.at(1).find("acts")->boolean);
}

TEST(Target, RemembersNothingBetweenLines) {
  const std::string pid = R"("control": {"law": "PID", "kd_N_s_per_mm": 0.01, "ki_N_per_mm_s": 5}, )";
  std::string in;
  for (int line = 0; line < 50; ++line) in += "{\"p_mm\": [" + std::to_string(30 + line % 2) + ", 0, 0]}\n";
  const std::vector<Value> all = sceneAnswers(sceneText(kSphere, pid), in);
  ASSERT_EQ(all.size(), 50U);
  EXPECT_EQ(vectorAt(all[0], "force_N"), vectorAt(all[48], "force_N"));
  EXPECT_NEAR(vectorAt(all[48], "force_N").x(), 10.0, 1e-13);
}

TEST(Target, OtherLinesAreAnsweredInOrderAroundBadOnes) {
  const std::string in =
      "{\"p_mm\": [30, 0, 0]}\n"
      "not json\n"
      "{\"p_mm\": [30, 0]}\n"
      "\n"
      "{\"pmm\": [1, 2, 3]}\n"
      "[1, 2, 3]\n"
      "{\"p_mm\": [1e999, 0, 0]}\n"
      "{\"p_mm\": [1, 2, 3], \"p_mm\": [1, 2, 3]}\n"
      "{\"p_mm\": [60, 0, 0]}";
  const std::vector<Value> all = sceneAnswers(sceneText(kSphere), in, Exit::BadInput);
  ASSERT_EQ(all.size(), 9U);
  EXPECT_NEAR(vectorAt(all[0], "q_mm").x(), 50.0, 1e-13);
  EXPECT_NEAR(vectorAt(all[8], "force_N").x(), -5.0, 1e-13);
  for (std::size_t index = 1; index < 8; ++index) {
    EXPECT_FALSE(textAt(all[index], "error").empty());
    EXPECT_EQ(numberAt(all[index], "line"), static_cast<double>(index + 1));
    EXPECT_EQ(all[index].keys.size(), 2U);
  }
  EXPECT_NE(textAt(all[4], "error").find("\"pmm\""), std::string::npos);
}

TEST(Target, TakesARotationAndRefusesWhatIsNone) {
  const std::string in =
      "{\"p_mm\": [30, 0, 0], \"R_WT\": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}\n"
      "{\"p_mm\": [30, 0, 0], \"R_WT\": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]}\n"  // a mirror
      "{\"p_mm\": [30, 0, 0], \"R_WT\": [[2, 0, 0], [0, 1, 0], [0, 0, 1]]}\n"
      "{\"p_mm\": [30, 0, 0], \"R_WT\": [1, 0, 0, 0, 1, 0, 0, 0, 1]}\n";
  const std::vector<Value> all = sceneAnswers(sceneText(kSphere), in, Exit::BadInput);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(textAt(all[0], "status"), "unique");
  for (std::size_t index = 1; index < 4; ++index) {
    EXPECT_NE(textAt(all[index], "error").find("R_WT"), std::string::npos);
  }
}

TEST(Target, FarAwayAndVeryNearItIsFinite) {
  const std::string in =
      "{\"p_mm\": [1e100, 1e100, -1e100]}\n{\"p_mm\": [5e-324, 0, 0]}\n{\"p_mm\": [1e-12, 0, 0]}\n{\"p_mm\": [1e200, "
      "0, 0]}\n";
  const std::vector<Value> all = sceneAnswers(sceneText(kSphere), in, Exit::BadInput);
  ASSERT_EQ(all.size(), 4U);
  for (std::size_t index = 0; index < 3; ++index) {
    EXPECT_TRUE(vectorAt(all[index], "force_N").allFinite());
    EXPECT_TRUE(vectorAt(all[index], "safe_force_N").allFinite());
    EXPECT_LE(vectorAt(all[index], "safe_force_N").norm(), 0.88 * (1 + 1e-15));
  }
  EXPECT_FALSE(textAt(all[3], "error").empty());
}

std::string list(const Vec3& v) {
  return "[" + json::numberText(v.x()) + ", " + json::numberText(v.y()) + ", " + json::numberText(v.z()) + "]";
}

/// The golden shape as a scene file says it; empty where a scene file may not (beyond 1e6 mm).
std::string constraintText(const GoldenShape& golden) {
  if (golden.place.cwiseAbs().maxCoeff() > 1e6 || golden.radius > 1e6) return {};
  std::string text = R"({"type": ")" + golden.type + "\", ";
  const std::string radius = R"(, "radius_mm": )" + json::numberText(golden.radius);
  if (golden.type == "point") return text + R"("position_mm": )" + list(golden.place) + "}";
  if (golden.type == "sphere") return text + R"("center_mm": )" + list(golden.place) + radius + "}";
  if (golden.type == "circle") {
    return text + R"("center_mm": )" + list(golden.place) + R"(, "normal": )" + list(golden.direction) + radius + "}";
  }
  text += R"("point_mm": )" + list(golden.place) + ", ";
  if (golden.type == "line") return text + R"("direction": )" + list(golden.direction) + "}";
  if (golden.type == "plane") return text + R"("normal": )" + list(golden.direction) + "}";
  return text + R"("axis": )" + list(golden.direction) + radius + "}";
}

/// What converting mm to m costs near an axis or a centre (README of the vectors), mm.
double conversion(const GoldenShape& shape, const GoldenCase& one) {
  if (one.tag.find("near") == std::string::npos) return 0.0;
  const double ulp = 0x1p-52 * std::max(one.P.norm(), 0x1p-1000);
  return 8.0 * shape.radius * ulp / offAxis(shape, one.P);
}

/// Compares the answer to one golden case, all through text.
void expectGolden(const GoldenShape& shape, const GoldenCase& one, const Value& answer) {
  SCOPED_TRACE(shape.name + " " + one.tag + " at " + list(one.P));
  if (one.degenerate) {
    EXPECT_EQ(textAt(answer, "status"), "degenerate");
    EXPECT_TRUE(isNullAt(answer, "q_mm"));
    EXPECT_EQ(vectorAt(answer, "force_N"), Vec3(0, 0, 0));
    return;
  }
  const double extra = conversion(shape, one);
  ASSERT_EQ(textAt(answer, "status"), "unique");
  EXPECT_LE((vectorAt(answer, "q_mm") - one.Q).cwiseAbs().maxCoeff(), one.tol_Q + extra);
  EXPECT_LE((vectorAt(answer, "force_N") - one.force).cwiseAbs().maxCoeff(), one.tol_F + extra * one.kp.maxCoeff());
}

/// Runs the cases of a set, scene by scene of equal gain; how many.
int checkSet(const GoldenSet& set, bool euclidean) {
  const std::string constraint = constraintText(set.shape);
  if (constraint.empty()) return 0;
  for (const GoldenCase& one : set.cases) {
    const std::string control = R"("control": {"law": "P", "kp_N_per_mm": )" + list(one.kp) +
                                (euclidean ? R"(, "anisotropy": "euclidean"}, )" : "}, ");
    expectGolden(set.shape, one, answer(sceneText(constraint, control), "{\"p_mm\": " + list(one.P) + "}"));
  }
  return static_cast<int>(set.cases.size());
}

TEST(Target, MeetsEveryGoldenCaseThatASceneFileCanSay) {
  int count = 0;
  for (const GoldenSet& set : constraintVectors().sets) count += checkSet(set, false);
  for (const GoldenSet& set : constraintVectors().extreme) count += checkSet(set, false);
  EXPECT_GE(count, 500);
  RecordProperty("cases", count);
}

TEST(Target, MeetsTheGoldenCasesOfUnequalGainsAsTheThesisMeansThem) {
  int count = 0;
  for (const GoldenSet& set : constraintVectors().anisotropic) count += checkSet(set, true);
  EXPECT_GE(count, 15);
}

TEST(Target, RefusesEveryInvalidGoldenShape) {
  for (const GoldenShape& shape : constraintVectors().invalid) {
    const ScratchFile file(sceneText(constraintText(shape)));
    const Outcome outcome = runCli({"target", file.path()}, "{\"p_mm\": [0, 0, 0]}\n");
    EXPECT_EQ(outcome.exit, Exit::BadInput) << shape.name;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("error: "), std::string::npos) << outcome.err;
  }
}

TEST(Target, WithInfluenceTheTurnOfTheStylusSaysWhere) {
  const std::string ring =
      R"({"type": "circle", "center_mm": [0, 0, 0], "normal": [0, 0, 1], "radius_mm": 50, "influence": {"t": 0.5}})";
  // The first case of the golden file: tip along x, stylus along y, so half way between them.
  const Value one = answer(sceneText(ring), R"({"p_mm": [60, 0, 0], "R_WT": [[0, 1, 0], [0, 0, 1], [1, 0, 0]]})");
  EXPECT_LE((vectorAt(one, "q_mm") - Vec3(35.35533905932738, 35.35533905932738, 0.0)).norm(), 1e-12);
  EXPECT_LE((vectorAt(one, "force_N") - Vec3(-12.322330470336311, 17.67766952966369, 0.0)).norm(), 1e-12);
  // Without a turn the stylus stands along the axis: position alone.
  EXPECT_LE((vectorAt(answer(sceneText(ring), R"({"p_mm": [60, 0, 0]})"), "q_mm") - Vec3(50, 0, 0)).norm(), 1e-13);
}

// A robot of one joint, 50 mm long, its z pointing outward; stylus 60 mm out, turned by theta.
constexpr const char* kOneJoint =
    R"({"type": "virtual_manipulator", "joints": [{"type": "revolute", "axis": [0, 0, 1], "point_mm": [0, 0, 0]}],
    "X_WV_home": [[0, 0, 1, 50], [0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]], "orientation": "angle", "ko_N_mm_per_rad": 250})";

/// The line of a stylus whose z has the angle theta_rad in the plane of x and y.
std::string stylusLine(const Vec3& p_mm, double theta_rad) {
  std::ostringstream line;
  const double c = std::cos(theta_rad), s = std::sin(theta_rad);
  line << std::setprecision(17) << "{\"p_mm\": [" << p_mm.x() << ", " << p_mm.y() << ", " << p_mm.z()
       << "], \"R_WT\": [[0, " << s << ", " << c << "], [0, " << -c << ", " << s << "], [1, 0, 0]]}";
  return line.str();
}

TEST(Target, AVirtualManipulatorTellsOfItsTipMomentStepsAndJoints) {
  // Golden: the planar case "thesis gains, p outside", theta_r = 0.5, found with 32 digits.
  const Value one = answer(sceneText(kOneJoint), stylusLine({60, 0, 0}, 0.5));
  EXPECT_NEAR(vectorAt(one, "force_N").x(), -5.06384150135482, 1e-9);
  EXPECT_NEAR(vectorAt(one, "force_N").y(), 1.7854969421552571, 1e-9);
  EXPECT_NEAR(vectorAt(one, "moment_N_mm").z(), -107.12981652931542, 1e-7);
  EXPECT_NEAR(one.find("theta")->items.at(0).number, 0.0714807338827383, 1e-10);
  EXPECT_NEAR((vectorAt(one, "n") - Vec3(std::cos(0.0714807338827383), std::sin(0.0714807338827383), 0)).norm(), 0.0,
              1e-10);
  EXPECT_GT(one.find("steps")->number, 0.0);
  EXPECT_NEAR(vectorAt(one, "safe_force_N").norm(), 0.88, 1e-12);
  const Value& constraint = one.find("constraints")->items.at(0);
  EXPECT_EQ(vectorAt(constraint, "moment_N_mm"), vectorAt(one, "moment_N_mm"));
}

TEST(Target, SlidingJointsAreToldInMillimetresAndAClosedFormTakesNoSteps) {
  const Value one = answer(sceneText(R"({"type": "virtual_manipulator",
    "joints": [{"type": "prismatic", "axis": [2, 0, 0], "max": 40}, {"type": "prismatic", "axis": [0, 1, 0]}],
    "X_WV_home": [[1, 0, 0, 10], [0, 1, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]]})"),
                           R"({"p_mm": [80, -30, 7]})");
  EXPECT_NEAR(one.find("theta")->items.at(0).number, 40.0, 1e-12);  // at its limit
  EXPECT_NEAR(one.find("theta")->items.at(1).number, -30.0, 1e-12);
  EXPECT_NEAR((vectorAt(one, "q_mm") - Vec3(50, -30, 5)).norm(), 0.0, 1e-12);
  EXPECT_EQ(one.find("steps")->number, 0.0);
  EXPECT_EQ(vectorAt(one, "moment_N_mm"), Vec3(0, 0, 0));
}

TEST(Target, ARobotThatNothingSaysWhereToGoIsDegenerate) {
  const std::string circle =
      R"({"type": "virtual_manipulator", "joints": [{"type": "revolute", "axis": [0, 0, 1], "point_mm": [0, 0, 0]}],
    "X_WV_home": [[1, 0, 0, 50], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])";
  for (const char* method : {"auto", "iterative"}) {
    const Value one =
        answer(sceneText(circle + R"(, "solver": {"method": ")" + method + "\"}}"), R"({"p_mm": [0, 0, 9]})");
    EXPECT_EQ(textAt(one, "status"), "degenerate") << method;
    EXPECT_TRUE(isNullAt(one, "q_mm"));
    EXPECT_EQ(vectorAt(one, "force_N"), Vec3(0, 0, 0));
  }
}

TEST(Target, TheThesisForceLawAddsItsPullAlongTheRim) {
  const std::string law =
      std::string(kOneJoint).substr(0, std::string(kOneJoint).size() - 1) + R"(, "force_law": "thesis-5.2"})";
  const Value one = answer(sceneText(law), stylusLine({60, 0, 3}, 0.5));
  // theta_v = 0: 0.5 N/mm over -10 mm, the pull k e / L = 250 * 0.5 / 50 towards the stylus's own angle, 3 mm to the
  // plane.
  EXPECT_NEAR((vectorAt(one, "force_N") - Vec3(-5.0, 2.5, -1.5)).norm(), 0.0, 1e-10);
  EXPECT_NEAR(vectorAt(one, "moment_N_mm").z(), -125.0, 1e-8);
}

}  // namespace
}  // namespace underact::test
