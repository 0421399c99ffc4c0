#include <deque>
#include <set>
#include <sstream>

#include "core/base/units.h"
#include "core/json/json.h"
#include "core/scene/compile.h"
#include "core/scene/fields.h"
#include "core/scene/load_meshes.h"
#include "core/scene/teaching.h"
#include "core/tick/state.h"
#include "tests/core/scene/scene_support.h"

namespace underact::scene {
namespace {

Description shipped(const std::string& name) {
  const Result<Description> read = readSceneFile(std::string(UNDERACT_SOURCE) + "/scenes/" + name + ".json");
  EXPECT_TRUE(read) << name << "\n" << test::joined(test::linesOf(read.problems()));
  Description scene = read ? read.value() : Description{};
  const Problems problems = loadMeshes(scene);
  EXPECT_TRUE(problems.empty()) << name << "\n" << test::joined(test::linesOf(problems));
  return scene;
}

/// Six words in a row that both have, or none.
std::string wordsInBoth(const std::string& one, const std::string& other) {
  std::istringstream words(one);
  std::deque<std::string> last;
  for (std::string word; words >> word;) {
    last.push_back(word);
    if (last.size() < 6) continue;
    std::string six = last[0];
    for (std::size_t index = 1; index < last.size(); ++index) six += " " + last[index];
    if (other.find(six) != std::string::npos) return six;
    last.pop_front();
  }
  return "";
}

TEST(ShippedScenes, EachReadsCompilesAndTellsPeopleWhatItIs) {
  const std::vector<std::filesystem::path> files = test::sceneFiles();
  EXPECT_GE(files.size(), 12u);
  for (const std::filesystem::path& file : files) {
    const Description scene = shipped(file.stem().string());
    EXPECT_TRUE(compile(scene)) << file;
    const Teaching teaching = teachingOf(file.string()).value_or(Teaching{});
    EXPECT_GE(scene.about.size() + teaching.feel.size() + teaching.try_this.size(), 80u) << file;
    for (const std::string& part : {teaching.feel, teaching.try_this})
      EXPECT_EQ(wordsInBoth(part, scene.about), "") << file << ": which stand below one another in the window";
    EXPECT_LE(scene.title.size(), 40u) << file;
  }
}

TEST(ShippedScenes, TheTestsOfTheThesisHaveItsNumbers) {
  const auto onlyShape = [](const std::string& name) {
    const Description scene = shipped(name);
    EXPECT_EQ(scene.constraints.size(), 1u);
    EXPECT_EQ(controlOf(scene, 0).law, LawType::P);
    EXPECT_EQ(controlOf(scene, 0).gains.kp_N_per_mm, Vec3::Constant(0.5));
    EXPECT_EQ(scene.constraints[0].side, target::Side::Both);
    EXPECT_NE(scene.about.find("Thesis figure"), std::string::npos) << name;
    return scene.constraints[0].shape;
  };
  EXPECT_TRUE(test::same(onlyShape("01_point"), Shape(Point{Vec3(0, 0, 0)})));
  EXPECT_TRUE(test::same(onlyShape("02_sphere"), Shape(Sphere{Vec3(0, 0, 0), 50})));
  EXPECT_TRUE(test::same(onlyShape("03_line"), Shape(Line{Vec3(0, 30, 0), Vec3(-1, -2, 1)})));
  EXPECT_TRUE(test::same(onlyShape("04_plane"), Shape(Plane{Vec3(0, 0, 0), Vec3(1, 1, 1)})));
  EXPECT_TRUE(test::same(onlyShape("05_circle"), Shape(Circle{Vec3(10, 20, 30), Vec3(-1, 1, -1), 40})));
  EXPECT_TRUE(test::same(onlyShape("06_cylinder"), Shape(Cylinder{Vec3(30, 0, 30), Vec3(-1, 1, -1), 30})));
}

TEST(ShippedScenes, TheBoxesLieWithinTheArmsWorkspace) {  // 160 x 120 x 70 mm about the middle
  for (const char* name : {"07_box_outside", "08_box_inside"}) {
    const Box box = std::get<Box>(shipped(name).constraints[0].shape);
    const Vec3 reach = box.center_mm.cwiseAbs() + box.size_mm / 2;
    EXPECT_TRUE((reach.array() <= Vec3(80, 60, 35).array()).all()) << name;
  }
}

TEST(ShippedScenes, TheRobotsAreWhatTheirTextsSay) {
  const auto robot = [](const std::string& name, std::size_t index = 0) {
    return std::get<VirtualManipulator>(shipped(name).constraints.at(index).shape);
  };
  for (const char* name : {"16_one_joint_robot", "17_thesis_force_law"}) {  // the thesis's own numbers
    EXPECT_EQ(robot(name).joints.size(), 1u);
    EXPECT_EQ(robot(name).X_WV_home(0, 3), 50.0);
    EXPECT_EQ(robot(name).ko_N_mm_per_rad, 250.0);
    EXPECT_EQ(shipped(name).control.gains.kp_N_per_mm, Vec3::Constant(0.5));
    EXPECT_EQ(robot(name).orientation, manipulator::Orientation::Angle);
  }
  EXPECT_EQ(robot("17_thesis_force_law").force_law, manipulator::ForceLaw::Thesis52);
  const auto compiled = [](const std::string& name, std::size_t index = 0) {
    return std::get<manipulator::Manipulator>(compile(shipped(name)).value().entries.at(index).constraint.goal);
  };
  EXPECT_EQ(compiled("18_sphere_of_two_joints").closed->kind, manipulator::ClosedFormKind::Sphere);
  EXPECT_EQ(compiled("19_four_bar", 1).closed->kind, manipulator::ClosedFormKind::Circle);
  EXPECT_EQ(robot("20_scara").joints.size(), 4u);
  EXPECT_EQ(robot("21_puma_560").joints.size(), 6u);
  // The small arm reaches a third of the real one's lengths from its shoulder.
  const manipulator::Manipulator small = compiled("22_out_of_reach");
  double reach_mm = 0.0;
  for (std::size_t i = 2; i < 4; ++i) {
    reach_mm += kMillimetrePerMetre * (small.chain.joints[i].p_WJ - small.chain.joints[i - 1].p_WJ).norm();
  }
  EXPECT_NEAR(reach_mm, (127.508 + 149.352) / 3.0, 1e-5);
}

TEST(ShippedScenes, EachBeamHasTheStiffnessThatItsTextNames) {
  for (const auto& [index, wanted_N_per_mm] : {std::pair{0, 0.03}, {1, 0.045}}) {
    const auto beam =
        std::get<VirtualManipulator>(shipped("23_two_beams").constraints.at(static_cast<std::size_t>(index)).shape);
    const double length_mm = (beam.X_WV_home.topRightCorner<3, 1>() - beam.joints[0].point_mm).norm();
    EXPECT_NEAR(length_mm, 0.8517 * 70.0, 1e-5);  // Howell 2001: the lever of a cantilever's pseudo-rigid body
    EXPECT_NEAR(beam.joints[0].stiffness / (length_mm * length_mm), wanted_N_per_mm, 1e-6);
  }
}

TEST(ShippedScenes, EachCarriesWhatItNeedsAndNothingElse) {
  const auto needs = [](const std::string& name) {
    const tick::TickProgram program = compile(shipped(name)).value();
    const std::size_t laws = (tick::bytesOf(makeState(program)) - sizeof(tick::TickState)) / sizeof(control::LawState);
    return std::string(program.needs.rate ? "rate " : "") + (program.needs.integral ? "integral " : "") +
           (program.needs.metric ? "metric " : "") + (program.needs.choice ? "choice " : "") + std::to_string(laws);
  };
  for (const char* name : {"01_point", "02_sphere", "03_line", "04_plane", "05_circle", "06_cylinder", "07_box_outside",
                           "08_box_inside", "11_soft_and_stiff_axes"}) {
    EXPECT_EQ(needs(name), "0") << name;
  }
  EXPECT_EQ(needs("09_wall"), "rate 1");
  EXPECT_EQ(needs("10_two_spheres_nearest"), "choice 0");
  EXPECT_EQ(needs("12_line_pid"), "rate integral 1");
}

// The schema is for editors; here it is held against the reader, key by key.

json::Value schema() {
  const std::string path = std::string(UNDERACT_SOURCE) + "/scenes/scene.schema.json";
  return json::parse(test::fileText(path), path).value();
}

std::set<std::string> propertiesOf(const json::Value& object) {
  const json::Value* properties = object.find("properties");
  return properties == nullptr ? std::set<std::string>{}
                               : std::set<std::string>(properties->keys.begin(), properties->keys.end());
}

std::set<std::string> wordsOf(const json::Value& list) {
  std::set<std::string> words;
  for (const json::Value& item : list.items) words.insert(item.text);
  return words;
}

/// What the reader itself names when it meets a key that is near to none: 'Known keys: "a", "b" and "c".'
std::set<std::string> keysKnownIn(const std::string& text) {
  std::set<std::string> keys;
  for (const std::string& line : test::problemsIn(text)) {
    const std::size_t start = line.find("Known keys: ");
    if (start == std::string::npos) continue;
    std::size_t at = start;
    while ((at = line.find('"', at)) != std::string::npos) {
      const std::size_t end = line.find('"', at + 1);
      keys.insert(line.substr(at + 1, end - at - 1));
      at = end + 1;
    }
  }
  return keys;
}

TEST(SceneSchema, KnowsTheKeysThatTheReaderKnowsAndNoOthers) {
  const json::Value root = schema();
  EXPECT_EQ(propertiesOf(root), keysKnownIn(R"({"qqqqqqqqqqqqqqqqqqqq": 1})"));
  const json::Value& defs = *root.find("$defs");
  EXPECT_EQ(propertiesOf(*defs.find("control")), keysKnownIn(R"({"control": {"qqqqqqqqqqqqqqqqqqqq": 1}})"));
  std::set<std::string> types;
  for (const json::Value& type : root.find("properties")->find("constraints")->find("items")->find("oneOf")->items) {
    const std::string name = type.find("$ref")->text.substr(std::string("#/$defs/").size());
    types.insert(name);
    EXPECT_EQ(propertiesOf(*defs.find(name)),
              keysKnownIn(test::sceneWith(R"({"type": ")" + name + R"(", "qqqqqqqqqqqqqqqqqqqq": 1})")))
        << name;
  }
  std::set<std::string> known;
  const std::vector<std::string> lines = test::problemsIn(test::sceneWith(R"({"type": "qqqqqqqqqqqqqqqqqqqq"})"));
  for (const std::string& type : types) {
    if (lines.at(0).find("\"" + type + "\"") != std::string::npos) known.insert(type);
  }
  EXPECT_EQ(types, known);
  EXPECT_EQ(types.size(), std::variant_size_v<Shape>);
}

TEST(SceneSchema, AsksForWhatTheReaderAsksFor) {
  const json::Value root = schema();
  const auto missing = [](const std::string& text) {
    std::set<std::string> keys;
    for (const std::string& line : test::problemsIn(text)) {
      const std::size_t start = line.find("The key \"");
      if (line.find("is missing") != std::string::npos)
        keys.insert(line.substr(start + 9, line.find('"', start + 9) - start - 9));
    }
    return keys;
  };
  EXPECT_EQ(wordsOf(*root.find("required")), missing("{}"));
  for (const json::Value& type : root.find("properties")->find("constraints")->find("items")->find("oneOf")->items) {
    const std::string name = type.find("$ref")->text.substr(std::string("#/$defs/").size());
    std::set<std::string> required = wordsOf(*root.find("$defs")->find(name)->find("required"));
    EXPECT_EQ(required.erase("type"), 1u);
    EXPECT_EQ(required, missing(test::sceneWith(R"({"type": ")" + name + R"("})"))) << name;
  }
}

TEST(SceneSchema, HasTheArmsAndTheJointsThatTheReaderHas) {  // the settings: settings_test.cpp
  const json::Value root = schema();
  std::set<std::string> joints, arms;
  for (const auto& word : kJointWords) joints.insert(word.word);
  const json::Value& joint = *root.find("$defs")->find("joint")->find("properties");
  EXPECT_EQ(wordsOf(*joint.find("type")->find("enum")), joints);
  for (const arm::Preset& preset : arm::sceneArms()) arms.insert(preset.name);
  EXPECT_EQ(wordsOf(*root.find("properties")->find("arm")->find("anyOf")->items.at(0).find("enum")), arms);
}

}  // namespace
}  // namespace underact::scene
