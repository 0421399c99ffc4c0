#include "core/scene/read.h"

#include <sys/stat.h>

#include "core/json/text.h"
#include "tests/core/scene/scene_support.h"

namespace underact::scene {
namespace {

using test::joined;
using test::problemsIn;
using test::sceneWith;

const std::string kAt = "2:1: ";
const std::string kPoint = R"({"type": "point", "position_mm": [0, 0, 0]})";

/// The only problem of a scene whose only constraint this is.
std::string problemOf(const std::string& constraint) {
  return joined(problemsIn(sceneWith(constraint)));
}

/// The only problem of a scene with these keys beside those it must have.
std::string problemWith(const std::string& keys) {
  return joined(
      problemsIn("{" + keys + "\n\"underact_scene\": 1, \"title\": \"t\", \"constraints\": [" + kPoint + "]}"));
}

/// "point", "sphere" and so on, as the reader lists them.
std::string allTypes(const char* last) {
  std::vector<std::string> types;
  eachShape([&types](const auto& shape) { types.emplace_back(typeName(shape)); });
  return json::listed(types, last);
}

TEST(ReadScene, TheExampleOfTheSceneReferenceIsRead) {
  const Result<Description> read = readScene(R"({
  "underact_scene": 1,
  "title": "Circle in a tilted plane",
  "about": "Thesis figure 4.12.",
  "arm": "omni-thesis",
  "control": {"law": "P", "kp_N_per_mm": 0.5},
  "constraints": [
    {"name": "rim", "type": "circle", "center_mm": [10, 20, 30], "normal": [-1, 1, -1], "radius_mm": 40}
  ]
})",
                                             "05_circle.json");
  ASSERT_TRUE(read) << joined(test::linesOf(read.problems()));
  const Description& scene = read.value();
  EXPECT_EQ(scene.title, "Circle in a tilted plane");
  EXPECT_EQ(scene.about, "Thesis figure 4.12.");
  EXPECT_EQ(scene.file, "05_circle.json");
  ASSERT_EQ(scene.constraints.size(), 1u);
  const Constraint& rim = scene.constraints[0];
  EXPECT_EQ(rim.name, "rim");
  EXPECT_EQ(rim.place.file, "05_circle.json");
  EXPECT_EQ(rim.place.line, 8);
  EXPECT_EQ(rim.place.column, 5);
  EXPECT_EQ(rim.place.key, "constraints[0]");
  EXPECT_EQ(std::get<Circle>(rim.shape).center_mm, Vec3(10, 20, 30));
  EXPECT_EQ(std::get<Circle>(rim.shape).normal, Vec3(-1, 1, -1));
  EXPECT_EQ(std::get<Circle>(rim.shape).radius_mm, 40.0);
}

TEST(ReadScene, TakesTheDocumentedDefaultOfEachAbsentKey) {
  const Description scene = readScene(sceneWith(kPoint), "").value();
  EXPECT_EQ(scene.arm, "omni-thesis");
  EXPECT_EQ(scene.about, "");
  EXPECT_EQ(scene.control.law, LawType::P);
  EXPECT_EQ(scene.control.gains.kp_N_per_mm, Vec3::Constant(0.5));
  EXPECT_EQ(scene.control.gains.kd_N_s_per_mm, Vec3::Zero());
  EXPECT_EQ(scene.control.anisotropy, Anisotropy::Weighted);
  EXPECT_EQ(scene.combine, tick::Combine::Sum);
  EXPECT_FALSE(scene.constraints[0].control);
  EXPECT_EQ(scene.constraints[0].side, target::Side::Both);
  EXPECT_EQ(scene.constraints[0].name, "point 1");
}

TEST(ReadScene, EveryTypeAndEveryKeyIsRead) {
  const Result<Description> read = readScene(R"({"$schema": "scene.schema.json", "underact_scene": 1.0, "title": "t",
  "arm": "touch-measured", "combine": "nearest", "simulation": {"integrator": "end_velocity", "substep_us": 12.5},
  "control": {"law": "PID", "kp_N_per_mm": [1, 2, 3], "kd_N_s_per_mm": 0.25, "ki_N_per_mm_s": [4, 5, 6],
              "anisotropy": "euclidean", "space": "cartesian"},
  "constraints": [
    {"type": "point", "position_mm": [1, 2, 3]},
    {"type": "sphere", "center_mm": [1, 2, 3], "radius_mm": 4, "side": "inside"},
    {"type": "line", "point_mm": [1, 2, 3], "direction": [0, 0, 4]},
    {"type": "plane", "point_mm": [1, 2, 3], "normal": [0, 4, 0], "side": "outside"},
    {"type": "cylinder", "point_mm": [1, 2, 3], "axis": [4, 0, 0], "radius_mm": 5, "side": "both"},
    {"type": "box", "center_mm": [1, 2, 3], "size_mm": [4, 5, 6], "R_WB": [[0, -1, 0], [1, 0, 0], [0, 0, 1]],
     "control": {}}
  ]})",
                                             "f");
  ASSERT_TRUE(read) << joined(test::linesOf(read.problems()));
  const Description& scene = read.value();
  EXPECT_EQ(scene.arm, "touch-measured");
  EXPECT_EQ(scene.combine, tick::Combine::Nearest);
  EXPECT_EQ(scene.simulation, (Simulation{Integrator::EndVelocity, 12.5}));
  EXPECT_EQ(integrationOf(scene.simulation).substep_ns, 12'500);
  EXPECT_EQ(scene.control.law, LawType::PID);
  EXPECT_EQ(scene.control.gains.kp_N_per_mm, Vec3(1, 2, 3));
  EXPECT_EQ(scene.control.gains.kd_N_s_per_mm, Vec3::Constant(0.25));
  EXPECT_EQ(scene.control.gains.ki_N_per_mm_s, Vec3(4, 5, 6));
  EXPECT_EQ(scene.control.anisotropy, Anisotropy::Euclidean);
  EXPECT_EQ(std::get<Point>(scene.constraints[0].shape).position_mm, Vec3(1, 2, 3));
  EXPECT_EQ(std::get<Sphere>(scene.constraints[1].shape).radius_mm, 4.0);
  EXPECT_EQ(scene.constraints[1].side, target::Side::Inside);
  EXPECT_EQ(std::get<Line>(scene.constraints[2].shape).direction, Vec3(0, 0, 4));
  EXPECT_EQ(std::get<Plane>(scene.constraints[3].shape).normal, Vec3(0, 4, 0));
  EXPECT_EQ(scene.constraints[3].side, target::Side::Outside);
  EXPECT_EQ(std::get<Cylinder>(scene.constraints[4].shape).axis, Vec3(4, 0, 0));
  const Box& box = std::get<Box>(scene.constraints[5].shape);
  EXPECT_EQ(box.size_mm, Vec3(4, 5, 6));
  EXPECT_EQ(box.R_WB * Vec3::UnitX(), Vec3::UnitY());  // rows in the file, not columns
  ASSERT_TRUE(scene.constraints[5].control);           // its own: the defaults, not the scene's
  EXPECT_EQ(controlOf(scene, 5).law, LawType::P);
  EXPECT_EQ(controlOf(scene, 4).law, LawType::PID);
}

TEST(ReadScene, EveryProblemIsToldAtOnceInTheOrderOfTheFile) {
  EXPECT_EQ(
      joined(problemsIn(R"({
  "underact_scene": 2,
  "title": "",
  "arm": "omnni",
  "control": {"law": "PI", "kp_N_per_mm": -1, "gain": 3},
  "combine": "add", "simulation": {"substep_us": 1, "step": 2, "integrator": "euler"},
  "constraints": [
    {"type": "sphere", "centre_mm": [0, 0], "radius_mm": -5},
    {"type": "line", "point_mm": [0, "a", 2e6], "direction": [0, 0, 0], "side": "inside"},
    7,
    {"name": "x", "type": "spere"},
    {"name": "x", "type": "point", "position_mm": [1e400, 0, 0]}
  ],
  "constraints": []
})")),
      R"(2:21: underact_scene: The scene has version 2, but this program only reads version 1. Use a newer version of Underact.
3:12: title: The title is empty; say in a few words what the scene lets you feel.
4:10: arm: The arm "omnni" is not known. Known arms: "omni-thesis", "touch-measured", "woodenhaptics", "abb-irb-120", "cobra-600", "iiwa7", "kr5", "panda", "planar-3", "puma-560", "stanford", "ur10e" and "ur5e"; or the name of an arm file, such as "my_arm.json".
5:22: control.law: This must be "P", "PD" or "PID"; here it is "PI".
5:43: control.kp_N_per_mm: A gain must be 0 or above, otherwise the arm pushes away; here it is -1.
5:47: control.gain: The key "gain" is not known in a control. Known keys: "law", "kp_N_per_mm", "kd_N_s_per_mm", "ki_N_per_mm_s", "anisotropy", "passivity", "space" and "velocity".
6:14: combine: This must be "sum" or "nearest"; here it is "add".
6:50: simulation.substep_us: This must be from 5 to 10000 µs; here it is 1.
6:53: simulation.step: The key "step" is not known in a simulation. Known keys: "integrator" and "substep_us".
6:78: simulation.integrator: This must be "mean_velocity", "end_velocity" or "trapezoidal"; here it is "euler".
8:5: constraints[0].center_mm: The key "center_mm" is missing; a sphere needs it.
8:24: constraints[0].centre_mm: The key "centre_mm" is not known in a sphere. Did you mean "center_mm"?
8:58: constraints[0].radius_mm: This must be above 0 mm; here it is -5.
9:38: constraints[1].point_mm[1]: This must be a number; here it is text.
9:43: constraints[1].point_mm[2]: This must lie within 1e6 mm (1 km); here it is 2e+06.
9:62: constraints[1].direction: A direction must not be [0, 0, 0]; any other length will do.
9:73: constraints[1].side: A line has no inside and no outside; remove "side".
10:5: constraints[2]: This must be an object, as in {"type": "point", "position_mm": [0, 0, 0]}; here it is a number.
11:27: constraints[3].type: The type "spere" is not known. Did you mean "sphere"? Known types: )" +
          allTypes("and") + R"(.
12:14: constraints[4].name: The name "x" is taken by constraints[3]; names must differ.
12:52: constraints[4].position_mm[0]: This is not a finite number; the largest is about 1.8e308.
14:3: constraints: The key "constraints" appears a second time; the first is on line 7. Remove one of them.
)");
}

TEST(ReadScene, NamesMissingKeysAtTheStartOfTheScene) {
  EXPECT_EQ(joined(problemsIn("\n {}")),
            "2:2: underact_scene: The key \"underact_scene\" is missing; a scene needs it.\n"
            "2:2: title: The key \"title\" is missing; a scene needs it.\n"
            "2:2: constraints: The key \"constraints\" is missing; a scene needs it.\n");
  EXPECT_EQ(problemOf("{}"), kAt + "constraints[0].type: The key \"type\" is missing; a constraint needs it.\n");
  EXPECT_EQ(problemOf(R"({"type": "box"})"),
            kAt + "constraints[0].center_mm: The key \"center_mm\" is missing; a box needs it.\n" + kAt +
                "constraints[0].size_mm: The key \"size_mm\" is missing; a box needs it.\n");
}

TEST(ReadScene, RefusesASceneThatIsNoObject) {
  EXPECT_EQ(joined(problemsIn("[]")), "1:1: : This must be an object in { }; here it is a list.\n");
  EXPECT_EQ(joined(problemsIn(" null")), "1:2: : This must be an object in { }; here it is null.\n");
}

TEST(ReadScene, AnotherVersionIsRefused) {
  const auto version = [](const std::string& number) {
    return joined(
        problemsIn(R"({"underact_scene": )" + number + R"(, "title": "t", "constraints": [)" + kPoint + "]}"));
  };
  EXPECT_EQ(version("1"), "");
  EXPECT_EQ(version("12"),
            "1:20: underact_scene: The scene has version 12, but this program only reads version 1. Use a newer "
            "version of Underact.\n");
  for (const char* number : {"0", "-1", "1.5", "1e400"}) {
    EXPECT_EQ(version(number), "1:20: underact_scene: This must be the number 1, the version of scene files.\n");
  }
  EXPECT_EQ(version("\"1\""), "1:20: underact_scene: This must be the number 1; here it is text.\n");
}

TEST(ReadScene, ThereAreOneTo64Constraints) {
  const auto many = [](int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += (i == 0 ? "" : ",") + kPoint;
    return joined(problemsIn(sceneWith(text)));
  };
  EXPECT_EQ(many(64), "");
  EXPECT_EQ(many(0), "1:52: constraints: A scene has 1 to 64 constraints; this one has 0.\n");
  EXPECT_EQ(many(65), "1:52: constraints: A scene has 1 to 64 constraints; this one has 65.\n");
}

TEST(ReadScene, AnUnknownKeyIsTakenForTheNearestKnownOne) {
  const auto meant = [](const std::string& key) {
    return problemOf(R"({"type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 1, ")" + key + R"(": 1})");
  };
  const std::string at = "2:60: constraints[0].";
  for (const char* slip : {"radius", "Radius_mm", "radus_mm", "raduis_mm", "radius_m"}) {
    EXPECT_EQ(meant(slip),
              at + slip + ": The key \"" + slip + "\" is not known in a sphere. Did you mean \"radius_mm\"?\n");
  }
  EXPECT_NE(meant("position_of_it")
                .find("Known keys: \"name\", \"type\", \"center_mm\", \"radius_mm\", \"side\", \"influence\", "
                      "\"friction\" and \"control\"."),
            std::string::npos);
  EXPECT_NE(problemWith(R"("control": {"kp": 1},)").find("Did you mean \"kp_N_per_mm\"?"), std::string::npos);
  EXPECT_NE(problemWith(R"("control": {"kd_N_per_mm": 1},)").find("Did you mean \"kd_N_s_per_mm\"?"),
            std::string::npos);
  EXPECT_NE(problemWith(R"("controll": {},)").find("Did you mean \"control\"?"), std::string::npos);
}

TEST(ReadScene, AKeyThatIsNoNameIsQuotedAndCutShort) {
  EXPECT_EQ(problemWith("\"\\n\\u0001\": 1,").substr(0, 53),
            "1:2: \"\\n\\u0001\": The key \"\\n\\u0001\" is not known in a");
  EXPECT_EQ(problemWith("\"" + std::string(5000, 'k') + "\": 1,").substr(0, 108),
            "1:2: \"" + std::string(40, 'k') + "...\": The key \"" + std::string(40, 'k') + "...\" is");
}

TEST(ReadScene, OfAnUnknownTypeTheOtherKeysAreNotJudged) {
  EXPECT_EQ(problemOf(R"({"type": "torus", "radius_mm": 1, "tube_mm": 2})"),
            "2:10: constraints[0].type: The type \"torus\" is not known. Known types: " + allTypes("and") + ".\n");
}

TEST(ReadScene, NamesWhatThisVersionDoesNotHave) {
  EXPECT_EQ(problemOf(R"({"type": "point", "position_mm": [0, 0, 0], "influence": {"t": 0.5}})"),
            "2:45: constraints[0].influence: A point has no influence; only a circle, a cylinder and a sphere have. "
            "Remove it.\n");
  for (const char* key : {"friction", "search"}) {
    EXPECT_NE(problemWith("\"" + std::string(key) + "\": {},").find("This belongs in a constraint, as in"),
              std::string::npos);
    EXPECT_NE(problemWith("\"control\": {\"" + std::string(key) + "\": 1},").find("This belongs in a constraint"),
              std::string::npos);
  }
  for (const char* key : {"damping"}) {
    const std::string sentence = std::string(": \"") + key + "\" is not in this version of Underact.\n";
    EXPECT_EQ(problemWith("\"" + std::string(key) + "\": {},"), "1:2: " + std::string(key) + sentence);
    EXPECT_EQ(problemWith("\"control\": {\"" + std::string(key) + "\": 1},"),
              "1:14: control." + std::string(key) + sentence);
  }
  EXPECT_EQ(problemWith(R"("velocity": {"filter": "raw"},)"),
            "1:2: velocity: This belongs in the control, as in \"control\": {\"law\": \"PD\", \"velocity\": "
            "{\"filter\": \"kalman\"}}.\n");
  EXPECT_EQ(problemWith(R"("control": {"passivity": "on"},)"),
            "1:27: control.passivity: This must be \"observe\", \"off\" or \"control\"; here it is \"on\".\n");
  EXPECT_EQ(problemWith(R"("control": {"space": "joint"},)"), "");
  EXPECT_EQ(problemWith(R"("control": {"space": "tool"},)"),
            "1:23: control.space: This must be \"cartesian\" or \"joint\"; here it is \"tool\".\n");
}

TEST(ReadScene, EveryVelocityFilterWithItsSettings) {
  const auto velocityIn = [](const std::string& velocity) {
    return readScene(test::sceneWith(R"({"type": "point", "position_mm": [0, 0, 0], "control": {"velocity": )" +
                                     velocity + "}}"),
                     "test")
        .value()
        .constraints[0]
        .control->velocity;
  };
  EXPECT_EQ(velocityIn(R"({"filter": "kalman"})"), Velocity(KalmanFilter{}));
  EXPECT_EQ(velocityIn(R"({"filter": "kalman", "noise_mm": 0.02, "acceleration_mm_per_s2": 3000})"),
            Velocity(KalmanFilter{0.02, 3000.0}));
  EXPECT_EQ(velocityIn(R"({"filter": "low_pass", "time_constant_ms": 5})"), Velocity(LowPassFilter{5.0}));
  EXPECT_EQ(velocityIn(R"({"filter": "adaptive_window", "window": 16, "noise_mm": 0.2})"),
            Velocity(AdaptiveWindowFilter{16.0, 0.2}));
  EXPECT_EQ(velocityIn(R"({"filter": "raw"})"), Velocity(RawFilter{}));
  EXPECT_EQ(Control{}.velocity, Velocity(KalmanFilter{})) << "the usual one";
}

TEST(ReadScene, AVelocityFilterHasItsOwnSettingsAndNoOthers) {
  const auto problem = [](const std::string& velocity) {
    return problemWith(R"("control": {"velocity": )" + velocity + "},");
  };
  EXPECT_EQ(problem(R"({})"),
            "1:26: control.velocity.filter: The key \"filter\" is missing; a velocity filter needs it.\n");
  EXPECT_EQ(problem(R"("kalman")"),
            "1:26: control.velocity: This must be an object, as in {\"filter\": \"kalman\"}; here it is text.\n");
  EXPECT_EQ(
      problem(R"({"filter": "median", "window": 3})"),
      "1:37: control.velocity.filter: This must be \"kalman\", \"low_pass\", \"adaptive_window\" or \"raw\"; here it "
      "is \"median\".\n");
  EXPECT_EQ(problem(R"({"filter": "raw", "noise_mm": 1})"),
            "1:44: control.velocity.noise_mm: This is for \"kalman\" and \"adaptive_window\", not for the filter "
            "\"raw\". Change the filter, or remove this.\n");
  EXPECT_EQ(problem(R"({"filter": "low_pass", "time_constant_ms": -1})"),
            "1:69: control.velocity.time_constant_ms: This must be from 0 to 1000; here it is -1.\n");
  EXPECT_EQ(problem(R"({"filter": "adaptive_window", "window": 2.5})"),
            "1:66: control.velocity.window: This must be a whole number from 1 to 32; here it is 2.5.\n");
  EXPECT_EQ(problem(R"({"filter": "adaptive_window", "window": 33, "noise_mm": -0.1})"),
            "1:66: control.velocity.window: This must be a whole number from 1 to 32; here it is 33.\n"
            "1:82: control.velocity.noise_mm: This must be from 0 to 1000; here it is -0.1.\n");
  EXPECT_EQ(problem(R"({"filter": "kalman", "noise_mm": 0})"),
            "1:59: control.velocity.noise_mm: This must be from 1e-06 to 1000; here it is 0.\n");
  EXPECT_EQ(
      problem(R"({"filter": "kalman", "acceleration_mm_per_s2": 1e999})").find("acceleration_mm_per_s2: This must"),
      std::string("1:73: control.velocity.").size());
}

TEST(ReadScene, WrongKindsSayWhatIsAllowed) {
  EXPECT_EQ(problemWith("\"about\": 3,"), "1:11: about: This must be text in double quotes; here it is a number.\n");
  EXPECT_EQ(problemWith("\"control\": \"P\","),
            "1:13: control: This must be an object, as in {\"law\": \"P\", \"kp_N_per_mm\": 0.5}; here it is text.\n");
  EXPECT_EQ(problemWith("\"control\": {\"law\": 1},"),
            "1:21: control.law: This must be \"P\", \"PD\" or \"PID\"; here it is a number.\n");
  EXPECT_EQ(
      problemWith("\"control\": {\"kp_N_per_mm\": \"1\"},"),
      "1:29: control.kp_N_per_mm: This must be a number, or a list of 3 numbers for x, y and z; here it is text.\n");
  EXPECT_EQ(problemWith("\"control\": {\"kp_N_per_mm\": [1, 2]},"),
            "1:29: control.kp_N_per_mm: This must be a list of 3 numbers, as in [0, 30, 0]; here it has 2.\n");
  EXPECT_EQ(problemWith("\"$schema\": 1,"),
            "1:13: $schema: This must be text in double quotes; here it is a number.\n");
  EXPECT_EQ(
      problemOf(R"({"type": "point", "position_mm": 5})"),
      "2:34: constraints[0].position_mm: This must be a list of 3 numbers, as in [0, 30, 0]; here it is a number.\n");
  EXPECT_EQ(problemOf(R"({"type": "point", "position_mm": [true, null, {}]})"),
            "2:35: constraints[0].position_mm[0]: This must be a number; here it is true or false.\n"
            "2:41: constraints[0].position_mm[1]: This must be a number; here it is null.\n"
            "2:47: constraints[0].position_mm[2]: This must be a number; here it is an object in { }.\n");
  EXPECT_EQ(problemOf(R"({"type": "point", "position_mm": [0, 0, 0], "name": ""})"),
            "2:53: constraints[0].name: The name is empty; write one, or remove the key to get a default name.\n");
  EXPECT_EQ(problemOf(R"({"type": 3})"),
            "2:10: constraints[0].type: This must be " + allTypes("or") + "; here it is a number.\n");
}

TEST(ReadScene, MadeUpNamesNeverMeetOthers) {
  const Description scene =
      readScene(
          sceneWith(kPoint + ", " + R"({"name": "point 1", "type": "point", "position_mm": [0, 0, 0]})" + "," + kPoint),
          "")
          .value();
  EXPECT_EQ(scene.constraints[0].name, "point 1'");
  EXPECT_EQ(scene.constraints[1].name, "point 1");
  EXPECT_EQ(scene.constraints[2].name, "point 3");
}

TEST(ReadScene, ALongListOfProblemsIsCutAndSaysSo) {
  std::string keys;
  for (int i = 0; i < 100'000; ++i) keys += "\"zz" + std::to_string(i) + "\": 1, ";
  const std::vector<std::string> lines = problemsIn("{" + keys + "\"underact_scene\": 1}");
  ASSERT_EQ(lines.size(), 101u);
  EXPECT_NE(lines.back().find("The file has 99902 more problems."), std::string::npos) << lines.back();
}

TEST(ReadScene, TheNearestKeyIsLookedForTenTimesAndTheRestListTheKnownOnes) {
  std::string keys;
  for (int i = 0; i < 15; ++i) keys += "\"titlx" + std::string(static_cast<std::size_t>(i % 2), 'x') + "\": 1, ";
  for (int i = 0; i < 15; ++i) keys += "\"abou" + std::to_string(i) + "\": 1, ";
  const std::vector<std::string> lines =
      problemsIn("{" + keys + "\"underact_scene\": 1, \"title\": \"t\", \"constraints\": [" + kPoint + "]}");
  const auto with = [&](const char* words) {
    return std::count_if(lines.begin(), lines.end(),
                         [&](const std::string& line) { return line.find(words) != std::string::npos; });
  };
  EXPECT_EQ(with("Did you mean"), 10);
  EXPECT_EQ(with("Known keys"), 7);
  EXPECT_EQ(with("appears a second time"), 13);
}

TEST(ReadSceneFile, SaysWhyAFileCannotBeRead) {
  const std::string missing = ::testing::TempDir() + "/no_such_scene.json";
  const Result<Description> none = readSceneFile(missing);
  ASSERT_FALSE(none);
  EXPECT_EQ(describe(none.problems()[0]), missing + ": error: The file cannot be opened: No such file or directory.");
  const Result<Description> folder = readSceneFile(::testing::TempDir());
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.problems()[0].sentence, "This is a folder, not a scene file.");
  EXPECT_EQ(folder.problems()[0].place.line, 0);
}

TEST(ReadSceneFile, RefusesWhatIsTooLargeToBeAScene) {
  const std::string path = ::testing::TempDir() + "/large_scene.json";
  std::ofstream(path) << sceneWith(kPoint) << std::string(json::kLargestFile, ' ');
  const Result<Description> large = readSceneFile(path);
  std::filesystem::remove(path);
  ASSERT_FALSE(large);
  EXPECT_EQ(large.problems()[0].sentence, "The file is larger than 16 MiB; a scene is far smaller.");
  const Result<Description> endless = readSceneFile("/dev/zero");
  ASSERT_FALSE(endless);
}

const std::string kRing = R"({"type": "circle", "center_mm": [0, 0, 0], "normal": [0, 0, 1], "radius_mm": 50, )";

TEST(ReadScene, AnInfluenceIsReadWithItsDefaults) {
  const Result<Description> read =
      readScene(test::sceneWith(kRing + R"("influence": {"t": 0.25, "stylus_axis": "-z"}})"), "test.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(read.value().constraints[0].influence, (Influence{0.25, StylusAxis::MinusZ, 5.0}));
}

TEST(ReadScene, NamesEachErrorOfAnInfluence) {
  const auto problem = [](const std::string& rest) { return problemOf(kRing + rest + "}"); };
  EXPECT_NE(problem(R"("influence": {})").find("influence.t: The key \"t\" is missing"), std::string::npos);
  EXPECT_NE(problem(R"("influence": {"t": 1.5})").find("from 0 (orientation only) to 1"), std::string::npos);
  EXPECT_NE(problem(R"("influence": {"t": 0, "blend_deg": 31})").find("from 0 to 30 degrees"), std::string::npos);
  EXPECT_NE(problem(R"("influence": {"t": 0, "stylus_axis": "x"})").find("\"+z\" or \"-z\""), std::string::npos);
  EXPECT_NE(problem(R"("influence": 0.5)").find("an object"), std::string::npos);
  EXPECT_NE(problem(R"("influence": {"t": 0, "T": 1})").find("not known in an influence"), std::string::npos);
  EXPECT_NE(problem(R"("influence": {"t": 0}, "control": {"kp_N_per_mm": [1, 2, 3]})").find("gains' own metric"),
            std::string::npos);
  EXPECT_EQ(problem(R"("influence": {"t": 0}, "control": {"kp_N_per_mm": [1, 2, 3], "anisotropy": "euclidean"})"), "");
  EXPECT_NE(
      problemOf(
          R"({"type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 5, "side": "outside", "influence": {"t": 1}})")
          .find("A wall has no influence"),
      std::string::npos);
}

namespace {

/// A constraint with a joint and a home; extra: further keys, each with its comma before it.
std::string robotWith(const std::string& joint, const std::string& extra = "",
                      const std::string& home = "[[1, 0, 0, 50], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]") {
  return R"({"type": "virtual_manipulator", "joints": [)" + joint + R"(], "X_WV_home": )" + home + extra + "}";
}

const char* const kTurning = R"({"type": "revolute", "axis": [0, 0, 2], "point_mm": [1, 2, 3]})";

}  // namespace

TEST(ReadScene, AVirtualManipulatorIsReadWithAllItsKeysAndItsDefaults) {
  const VirtualManipulator plain =
      std::get<VirtualManipulator>(readScene(test::sceneWith(robotWith(kTurning)), "").value().constraints[0].shape);
  ASSERT_EQ(plain.joints.size(), 1u);
  EXPECT_EQ(plain.joints[0], (Joint{chain::JointType::Revolute, {0, 0, 2}, {1, 2, 3}}));
  EXPECT_EQ(plain.X_WV_home(0, 3), 50.0);
  EXPECT_EQ(plain.orientation, manipulator::Orientation::None);
  EXPECT_EQ(plain.solver, Solver{});
  EXPECT_EQ(plain.force_law, manipulator::ForceLaw::Energy);
  const std::string sliding =
      R"({"type": "prismatic", "axis": [1, 0, 0], "min": -5, "max": 7, "stiffness_N_per_mm": 0.25, "rest": 2})";
  const VirtualManipulator full = std::get<VirtualManipulator>(
      readScene(
          test::sceneWith(robotWith(
              std::string(kTurning) + ", " + sliding,
              R"(, "orientation": "full", "ko_N_mm_per_rad": 250, "solver": {"method": "iterative", "max_steps": 7, "tolerance": 1e-6})")),
          "")
          .value()
          .constraints[0]
          .shape);
  EXPECT_EQ(full.joints[1], (Joint{chain::JointType::Prismatic, {1, 0, 0}, Vec3::Zero(), -5.0, 7.0, 0.25, 2.0}));
  EXPECT_EQ(full.orientation, manipulator::Orientation::Full);
  EXPECT_EQ(full.ko_N_mm_per_rad, 250.0);
  EXPECT_EQ(full.solver, (Solver{SolverMethod::Iterative, 7, 1e-6}));
}

TEST(ReadScene, OfVeryManyConstraintsOrJointsOnlyTheFirstAreRead) {
  std::string points, joints;
  for (int i = 0; i < 1000; ++i) points += (i == 0 ? "" : ",") + std::string(i < 64 ? kPoint : "{}");
  EXPECT_EQ(joined(problemsIn(sceneWith(points))),
            "1:52: constraints: A scene has 1 to 64 constraints; this one has 1000.\n");
  for (int i = 0; i < 1000; ++i)
    joints += (i == 0 ? "" : ",") + std::string(R"({"type": "prismatic", "axis": [1, 0, 0]})");
  const std::vector<std::string> of_robot = problemsIn(sceneWith(robotWith(joints)));
  ASSERT_EQ(of_robot.size(), 1U);
  EXPECT_NE(of_robot[0].find("joints: A virtual robot has 1 to 8 joints; this one has 1000."), std::string::npos);
}

TEST(ReadScene, NamesEachErrorOfAVirtualManipulator) {
  const auto expectSentence = [](const std::string& constraint, const std::string& part) {
    const std::string all = joined(problemsIn(test::sceneWith(constraint)));
    EXPECT_NE(all.find(part), std::string::npos) << constraint << "\n" << all;
  };
  expectSentence(robotWith(""), "joints: A virtual robot has 1 to 8 joints; this one has 0.");
  expectSentence(robotWith(R"({"type": "prismatic", "axis": [1, 0, 0], "point_mm": [0, 0, 0]})"),
                 "joints[0].point_mm: A prismatic joint has a direction but no point");
  expectSentence(robotWith(R"({"type": "revolute", "axis": [0, 0, 0], "point_mm": [0, 0, 0]})"),
                 "joints[0].axis: A direction must not be [0, 0, 0]");
  expectSentence(robotWith(R"({"type": "revolute", "axis": [0, 0, 1]})"),
                 "joints[0].point_mm: The key \"point_mm\" is missing");
  expectSentence(robotWith(R"({"type": "prismatic", "axis": [1, 0, 0], "min": 3, "max": 2})"),
                 "joints[0].min: The lower limit 3 is above the upper limit 2");
  expectSentence(robotWith(R"({"type": "prismatic", "axis": [1, 0, 0], "stiffness_N_mm_per_rad": 2})"),
                 "The spring of a prismatic joint is called \"stiffness_N_per_mm\".");
  expectSentence(robotWith(R"({"type": "prismatic", "axis": [1, 0, 0], "rest": 2})"),
                 "Without a spring the joint has no rest");
  expectSentence(robotWith(kTurning, "", "[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]"),
                 "A pose has 4 rows of 4 numbers; this one has 3.");
  expectSentence(robotWith(kTurning, "", "[[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]"),
                 "is not a rotation matrix");
  expectSentence(robotWith(kTurning, "", "[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 1]]"),
                 "The last row of a pose");
  expectSentence(robotWith(kTurning, R"(, "ko_N_mm_per_rad": 3)"), "The orientation \"none\" does not use this");
  expectSentence(robotWith(kTurning, R"(, "orientation": "angle", "ko_N_mm_per_rad": 3)"),
                 "lies along the joint's axis");
  expectSentence(robotWith(R"({"type": "prismatic", "axis": [1, 0, 0]})", R"(, "orientation": "angle")"),
                 "needs a chain with just one revolute joint");
  expectSentence(robotWith(kTurning, R"(, "solver": {"max_steps": 1.5})"), "This must be a whole number from 1 to 100");
  expectSentence(robotWith(kTurning, R"(, "solver": {"method": "closed_form"}, "orientation": "full")"),
                 "There is no closed form for this chain");
  expectSentence(robotWith(kTurning, R"(, "control": {"space": "joint"})"), "Set \"space\" to \"cartesian\"");
  expectSentence(robotWith(kTurning, R"(, "control": {"kp_N_per_mm": [1, 2, 3], "anisotropy": "euclidean"})"),
                 "is held in the gains' own metric");
  expectSentence(robotWith(kTurning, R"(, "influence": {"t": 1})"), "has no influence");
  expectSentence(robotWith(kTurning, R"(, "side": "inside")"), "has no inside and no outside");
}

}  // namespace
}  // namespace underact::scene
