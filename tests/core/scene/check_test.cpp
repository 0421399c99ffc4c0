#include <cmath>

#include "core/base/units.h"
#include "core/json/json.h"
#include "core/scene/compile.h"
#include "core/scene/fields.h"
#include "tests/core/scene/random_scene.h"
#include "tests/support/constraint_vectors.h"

namespace underact::scene {
namespace {

using test::joined;
using test::linesOf;
using test::problemsIn;
using test::sceneWith;

std::string problemsOf(const std::string& constraint) {
  return joined(problemsIn(sceneWith(constraint)));
}

std::string problemsOf(const Description& scene) {
  return joined(linesOf(check(scene)));
}

Description sceneWithShape(const Shape& shape) {
  Description scene;
  scene.title = "t";
  scene.constraints.push_back({"it", shape, target::Side::Both, {}, {"f", 3, 5, "constraints[0]"}});
  return scene;
}

const std::vector<Shape> kOneOfEach = test::plainShapes(test::FillSizes{});

TEST(SceneRules, LengthsMustBeAboveZeroAndCoordinatesWithinAKilometre) {
  const std::string at = "2:57: constraints[0].radius_mm: ";
  const auto radius = [](const std::string& number) {
    return problemsOf(R"({"type": "sphere", "center_mm": [0, 0, 0], "radius_mm": )" + number + "}");
  };
  EXPECT_EQ(radius("1e-12"), "");
  EXPECT_EQ(radius("1e6"), "");
  EXPECT_EQ(radius("0"), at + "This must be above 0 mm; here it is 0.\n");
  EXPECT_EQ(radius("-0.0"), at + "This must be above 0 mm; here it is -0.0.\n");
  EXPECT_EQ(radius("-5"), at + "This must be above 0 mm; here it is -5.\n");
  EXPECT_EQ(radius("1e-999"), at + "This must be above 0 mm; here it is 0.\n");
  EXPECT_EQ(radius("1e-320"), at + "This is too close to 0 mm; the smallest value is 1e-100 mm.\n");
  EXPECT_EQ(radius("1000001"), at + "This must lie within 1e6 mm (1 km); here it is 1000001.\n");
  EXPECT_EQ(radius("1e400"), at + "This is not a finite number; the largest is about 1.8e308.\n");
  EXPECT_EQ(problemsOf(R"({"type": "box", "center_mm": [1e6, -1e6, -1000000.5], "size_mm": [1, 0, -2]})"),
            "2:42: constraints[0].center_mm[2]: This must lie within 1e6 mm (1 km); here it is -1000000.5.\n"
            "2:70: constraints[0].size_mm[1]: This must be above 0 mm; here it is 0.\n"
            "2:73: constraints[0].size_mm[2]: This must be above 0 mm; here it is -2.\n");
}

TEST(SceneRules, ADirectionMayHaveAnyLengthButZero) {
  const auto direction = [](const std::string& list) {
    return problemsOf(R"({"type": "line", "point_mm": [0, 0, 0], "direction": )" + list + "}");
  };
  EXPECT_EQ(direction("[0, 0, 1e-300]"), "");
  EXPECT_EQ(direction("[1e300, -1e300, 1e300]"), "");
  EXPECT_EQ(direction("[0, -0, 1e-999]"),
            "2:54: constraints[0].direction: A direction must not be [0, 0, 0]; any other length will do.\n");
  EXPECT_EQ(direction("[0, 1e999, 0]"),
            "2:58: constraints[0].direction[1]: This is not a finite number; the largest is about 1.8e308.\n");
}

TEST(SceneRules, TheMatrixOfABoxMustBeARotation) {
  const auto matrix = [](const std::string& rows) {
    return problemsOf(R"({"type": "box", "center_mm": [0, 0, 0], "size_mm": [1, 1, 1], "R_WB": )" + rows + "}");
  };
  const std::string no =
      "2:71: constraints[0].R_WB: This is not a rotation matrix: its rows must have length 1, be at right angles, and "
      "form a right-handed frame.\n";
  EXPECT_EQ(matrix("[[1, 0, 0], [0, 0, -1], [0, 1, 0]]"), "");
  EXPECT_EQ(matrix("[[1, 0, 0], [0, 1, 0], [0, 0, 1.0000001]]"), "");  // rounded, not wrong
  EXPECT_EQ(matrix("[[1, 0, 0], [0, 1, 0], [0, 0, -1]]"), no);         // a mirror
  EXPECT_EQ(matrix("[[1, 0, 0], [0.001, 1, 0], [0, 0, 1]]"), "");      // the nearest one is meant
  EXPECT_EQ(
      matrix("[[1, 0, 0], [0, 1, 0], [0, 0, 1.002]]"),
      "2:71: constraints[0].R_WB: This is not a rotation matrix: a number in it is 0.002 off the nearest one, and "
      "0.001 is allowed. Give at least four decimals, better six.\n");
  EXPECT_EQ(matrix("[[0, 0, 0], [0, 0, 0], [0, 0, 0]]"), no);
  EXPECT_EQ(matrix("[[1, 0, 0], [0, 1, 0], [0, 0, 1e999]]"),
            "2:101: constraints[0].R_WB[2][2]: This is not a finite number; the largest is about 1.8e308.\n");
  EXPECT_EQ(
      matrix("[[1, 0, 0], [0, 1]]"),
      "2:71: constraints[0].R_WB: This must be a list of 3 rows, as in [[1, 0, 0], [0, 1, 0], [0, 0, 1]]; here it has "
      "2.\n");
  EXPECT_EQ(matrix("[[1, 0, 0], [0, 1], [0, 0, \"1\"]]"),
            "2:83: constraints[0].R_WB[1]: This must be a row of 3 numbers; here it has 2.\n"
            "2:98: constraints[0].R_WB[2][2]: This must be a number; here it is text.\n");
}

TEST(SceneRules, OnlyAShapeWithSidesTakesASide) {
  for (const Shape& shape : kOneOfEach) {
    Description scene = sceneWithShape(shape);
    scene.constraints[0].side = target::Side::Outside;
    const bool sides = shape::hasSides(
        std::get<target::NearestOnShape>(compile(sceneWithShape(shape)).value().entries[0].constraint.goal).shape);
    EXPECT_EQ(check(scene).empty(), sides) << typeName(shape);
    EXPECT_EQ(hasSides(shape), sides) << typeName(shape);
  }
  EXPECT_EQ(problemsOf(R"({"type": "point", "position_mm": [0, 0, 0], "side": "both"})"),
            "2:45: constraints[0].side: A point has no inside and no outside; remove \"side\".\n");
  EXPECT_EQ(problemsOf(R"({"type": "plane", "point_mm": [0, 0, 0], "normal": [0, 1, 0], "side": "above"})"),
            "2:71: constraints[0].side: This must be \"both\", \"outside\" or \"inside\"; here it is \"above\".\n");
}

TEST(SceneRules, GainsAreNotNegativeAndNotAbsurd) {
  const auto control = [](const std::string& keys) {
    return problemsOf(R"({"type": "point", "position_mm": [0, 0, 0], "control": {)" + keys + "}}");
  };
  EXPECT_EQ(control(R"("kp_N_per_mm": 0)"), "");
  EXPECT_EQ(control(R"("kp_N_per_mm": [0, 1, 2])"), "");
  EXPECT_EQ(
      control(R"("kp_N_per_mm": [0, -1, 1e13])"),
      "2:76: constraints[0].control.kp_N_per_mm[1]: A gain must be 0 or above, otherwise the arm pushes away; here it "
      "is -1.\n2:80: constraints[0].control.kp_N_per_mm[2]: A gain must be at most 1e12; here it is 1e+13.\n");
  EXPECT_EQ(control(R"("kp_N_per_mm": 1e999)"),
            "2:72: constraints[0].control.kp_N_per_mm: This is not a finite number; the largest is about 1.8e308.\n");
}

TEST(SceneRules, AGainThatTheLawDoesNotUseIsNoSilentTypo) {
  const auto control = [](const std::string& keys) {
    return joined(problemsIn(
        R"({"control": {)" + keys +
        R"(}, "underact_scene": 1, "title": "t", "constraints": [{"type": "point", "position_mm": [0, 0, 0]}]})"));
  };
  EXPECT_EQ(control(R"("kd_N_s_per_mm": 0.1)"),
            "1:31: control.kd_N_s_per_mm: The control law P does not use this gain; PD (or PID) does. Change the "
            "control law, or remove the gain.\n");
  EXPECT_EQ(control(R"("law": "PD", "kd_N_s_per_mm": 1, "ki_N_per_mm_s": [0, 0, 1])"),
            "1:64: control.ki_N_per_mm_s: The control law PD does not use this gain; PID does. Change the control law, "
            "or remove the gain.\n");
  EXPECT_EQ(control(R"("law": "P", "kd_N_s_per_mm": 0, "ki_N_per_mm_s": [0, 0, 0])"), "");  // says what is so
  EXPECT_EQ(control(R"("law": "PID", "kd_N_s_per_mm": 1, "ki_N_per_mm_s": 1)"), "");
  EXPECT_EQ(control(R"("law": "PI", "ki_N_per_mm_s": 1)"),
            "1:21: control.law: This must be \"P\", \"PD\" or \"PID\"; here it is \"PI\".\n");
}

TEST(SceneRules, AZeroGainBesideOthersNeedsTheEuclideanMetric) {
  for (const Shape& shape : kOneOfEach) {
    Description scene = sceneWithShape(shape);
    const bool is_point = std::holds_alternative<Point>(shape);
    scene.control.gains.kp_N_per_mm = Vec3(0.5, 0.0, 0.5);
    const std::string problem = problemsOf(scene);
    EXPECT_EQ(problem.empty(), is_point) << typeName(shape);
    if (!is_point) {
      EXPECT_EQ(
          problem,
          std::string("3:5: constraints[0]: The gain along y is 0 while the others are larger, so no point of the ") +
              typeName(shape) +
              " is nearest in the gains' own metric. Set \"anisotropy\" to \"euclidean\" in the control, or give "
              "every axis a gain.\n");
    }
    EXPECT_EQ(static_cast<bool>(compile(scene)), is_point);
    scene.control.gains.kp_N_per_mm = Vec3(1.0, 1.0, 1e-13);
    EXPECT_EQ(problemsOf(scene).empty(), is_point) << typeName(shape);
    scene.control.anisotropy = Anisotropy::Euclidean;
    EXPECT_EQ(problemsOf(scene), "") << typeName(shape);
    EXPECT_TRUE(compile(scene)) << typeName(shape);
    scene.control.anisotropy = Anisotropy::Weighted;
    scene.control.gains.kp_N_per_mm.setZero();
    EXPECT_EQ(problemsOf(scene), "") << typeName(shape);
    EXPECT_TRUE(compile(scene)) << typeName(shape);
    scene.control.gains.kp_N_per_mm = Vec3(1.0, 0.5, 1e-6);
    EXPECT_EQ(problemsOf(scene), "") << typeName(shape);
    EXPECT_TRUE(compile(scene)) << typeName(shape);
  }
}

TEST(SceneRules, ItIsTheControlThatHoldsForTheConstraintThatCounts) {
  Description scene = sceneWithShape(Sphere{Vec3::Zero(), 1.0});
  scene.control.gains.kp_N_per_mm = Vec3(0.5, 0.0, 0.5);
  scene.constraints[0].control = Control{};
  EXPECT_EQ(problemsOf(scene), "");
  scene.constraints[0].control->gains.kp_N_per_mm = Vec3(0.0, 0.5, 0.5);
  EXPECT_EQ(problemsOf(scene).substr(0, 42), "3:5: constraints[0]: The gain along x is 0");
}

TEST(SceneRules, ASceneEditedInMemoryIsHeldToTheSameRules) {
  Description scene = sceneWithShape(Circle{Vec3(0, kNotANumber, 2e6), Vec3::Zero(), -1.0});
  scene.title = " \n";
  scene.arm = "stylus";
  scene.control.gains.kp_N_per_mm.x() = -kInfinity;
  scene.constraints.push_back({"it", Point{}, target::Side::Inside, {}, {}});
  scene.constraints.push_back({"", Box{}, target::Side::Both, {}, {}});
  EXPECT_EQ(problemsOf(scene),
            R"(0:0: title: The title is empty; say in a few words what the scene lets you feel.
0:0: arm: The arm "stylus" is not known. Known arms: "omni-thesis", "touch-measured", "woodenhaptics", "abb-irb-120", "cobra-600", "iiwa7", "kr5", "panda", "planar-3", "puma-560", "stanford", "ur10e" and "ur5e"; or the name of an arm file, such as "my_arm.json".
0:0: control.kp_N_per_mm[0]: This is not a finite number; the largest is about 1.8e308.
3:5: constraints[0].center_mm[1]: This is not a finite number; the largest is about 1.8e308.
3:5: constraints[0].center_mm[2]: This must lie within 1e6 mm (1 km); here it is 2e+06.
3:5: constraints[0].normal: A direction must not be [0, 0, 0]; any other length will do.
3:5: constraints[0].radius_mm: This must be above 0 mm; here it is -1.
0:0: constraints[1].name: The name "it" is taken by constraints[0]; names must differ.
0:0: constraints[1].side: A point has no inside and no outside.
0:0: constraints[2].name: The constraint has no name.
0:0: constraints[2].size_mm[0]: This must be above 0 mm; here it is 0.
0:0: constraints[2].size_mm[1]: This must be above 0 mm; here it is 0.
0:0: constraints[2].size_mm[2]: This must be above 0 mm; here it is 0.
)");
  scene.constraints.clear();
  EXPECT_NE(problemsOf(scene).find("constraints: A scene has 1 to 64 constraints; this one has 0."), std::string::npos);
  EXPECT_FALSE(compile(scene));
}

/// tests/golden/constraints.json, "invalid", as a constraint of a scene file; a NaN cannot be written in JSON.
std::string constraintOf(const test::GoldenShape& golden) {
  const auto list = [](const Vec3& v) {
    return "[" + json::numberText(v.x()) + ", " + json::numberText(v.y()) + ", " + json::numberText(v.z()) + "]";
  };
  const bool by_point = golden.type == "line" || golden.type == "plane" || golden.type == "cylinder";
  std::string text =
      "{\"type\": \"" + golden.type + "\", \"" + (by_point ? "point_mm" : "center_mm") + "\": " + list(golden.place);
  if (golden.type == "line") text += ", \"direction\": " + list(golden.direction);
  if (golden.type == "plane" || golden.type == "circle") text += ", \"normal\": " + list(golden.direction);
  if (golden.type == "cylinder") text += ", \"axis\": " + list(golden.direction);
  if (golden.type != "line" && golden.type != "plane") text += ", \"radius_mm\": " + json::numberText(golden.radius);
  return text + "}";
}

TEST(SceneRules, TheGoldenInvalidShapesAreRefusedEachAtItsOwnKey) {
  const std::vector<std::string> keys{"direction", "normal", "normal", "radius_mm", "radius_mm", "center_mm[0]"};
  const std::vector<test::GoldenShape>& invalid = test::constraintVectors().invalid;
  ASSERT_EQ(invalid.size(), keys.size());
  for (std::size_t i = 0; i < invalid.size(); ++i) {
    const Result<Description> read = readScene(sceneWith(constraintOf(invalid[i])), "f");
    ASSERT_FALSE(read) << constraintOf(invalid[i]);
    ASSERT_EQ(read.problems().size(), 1u) << joined(linesOf(read.problems()));
    EXPECT_EQ(read.problems()[0].place.key, "constraints[0]." + keys[i]);
    EXPECT_EQ(read.problems()[0].place.line, 2);
  }
}

}  // namespace
}  // namespace underact::scene
