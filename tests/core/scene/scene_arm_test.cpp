// A scene whose arm is from a file: which arm it has, what is said of a file that cannot be used, and that a recorded
// scene needs the file no more.
#include "core/scene/scene_arm.h"

#include <filesystem>

#include "core/arm/arm_text.h"
#include "core/arm/mechanism.h"
#include "core/scene/compile.h"
#include "core/scene/edit.h"
#include "core/scene/load_meshes.h"
#include "core/scene/mesh_names.h"
#include "core/scene/write.h"
#include "tests/core/scene/scene_support.h"
#include "tests/support/arm_files.h"
#include "tests/support/scratch_folder.h"

namespace underact::scene {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBall = R"({"type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 30})";

std::string sceneWithArm(const std::string& arm, const std::string& more = "") {
  return "{\"underact_scene\": 1, \"title\": \"t\",\n\"arm\": \"" + arm + "\",\n" + more + "\"constraints\": [" +
         kBall + "]}";
}

/// The first sentence, with the last part of the file's name and the line.
std::string firstProblem(const Result<Description>& read) {
  if (read) return "none";
  const Problem& first = read.problems().front();
  return fs::path(first.place.file).filename().string() + ":" + std::to_string(first.place.line) + ": " +
         first.place.key + ": " + std::string(first.sentence);
}

class SceneArm : public testing::Test {
 protected:
  Result<Description> read(const std::string& arm) const {
    return readSceneFile(folder.write("scene.json", sceneWithArm(arm)));
  }
  std::string problemWith(const std::string& arm_text) const {
    folder.write("mine.json", arm_text);
    return firstProblem(read("mine.json"));
  }
  test::ScratchFolder folder;
};

TEST_F(SceneArm, FromAFileHasItsLengthsLimitsEncodersAndForce) {
  folder.write("mine.json", test::armFile("140", "0.5"));
  const Result<Description> scene = read("mine.json");
  ASSERT_TRUE(scene) << firstProblem(scene);
  EXPECT_EQ(armOf(scene.value()).name, "mine");
  EXPECT_EQ(armOf(scene.value()).counts_per_turn[0], 8192.0);
  EXPECT_EQ(modelOf(scene.value()).rows.at(2).a_m, 0.14);
  const tick::TickProgram program = compile(scene.value()).value();
  EXPECT_EQ(program.geometry.upper_m, 0.14);
  EXPECT_EQ(program.geometry.fore_m, 0.12);
  EXPECT_EQ(program.joint_limits.max_rad[0], 0.75);
  EXPECT_EQ(program.limits.max_force_N, 0.5);
}

TEST_F(SceneArm, FileOfAnArmThatShipsIsThatArmToTheBit) {
  for (const arm::Preset& preset : arm::sceneArms()) {
    folder.write("mine.json", std::string(arm::fileOf(preset.name)));
    const Description by_file = read("mine.json").value(), by_name = read(preset.name).value();
    EXPECT_EQ(findArm(by_name), &preset);
    EXPECT_TRUE(haveSameArm(by_file, by_name));
    EXPECT_FALSE(isSame(by_file, by_name)) << "saved, they are two files";
    const tick::TickProgram a = compile(by_file).value(), b = compile(by_name).value();
    EXPECT_EQ(a.geometry, b.geometry);
    EXPECT_EQ(a.joint_limits, b.joint_limits);
    EXPECT_EQ(a.limits.max_force_N, b.limits.max_force_N);
  }
}

TEST_F(SceneArm, NameIsRelativeToTheFolderOfTheSceneOrAbsolute) {
  fs::create_directory(folder.file("arms"));
  const std::string path = folder.write("arms/mine.json", test::armFile("140"));
  for (const std::string& name : {std::string("arms/mine.json"), std::string("./arms/../arms/mine.json"), path})
    EXPECT_EQ(armOf(read(name).value()).geometry.upper_m, 0.14) << name;
}

TEST_F(SceneArm, MistakesHaveTheLineInTheFileOfTheArm) {
  folder.write("mine.json", test::armFile("140", "0.5", "continous_force_N"));
  const std::string misspelt = test::joined(test::linesOf(read("mine.json").problems()));
  EXPECT_NE(misspelt.find("15:5: device.continous_force_N: The key \"continous_force_N\" is not known in a device "
                          "description. Did you mean \"continuous_force_N\"?"),
            std::string::npos)
      << misspelt;
  EXPECT_EQ(problemWith("{").substr(0, 12), "mine.json:1:");
  const std::string no_device = test::armFileWithoutDevice("140");
  EXPECT_EQ(problemWith(no_device),
            "mine.json:1: device: The arm of a scene with the geometry of table 3.1 of the thesis is a haptic device, "
            "which needs \"encoder_counts_per_turn\" and \"continuous_force_N\" here: \"device\": "
            "{\"encoder_counts_per_turn\": [4096, 4096, 4096, 4096, 4096, "
            "4096], \"continuous_force_N\": 1}.");
  EXPECT_EQ(problemWith(std::string(arm::fileOf("panda"))), "none");
}

TEST_F(SceneArm, FileThatCannotBeReadIsAProblemOfTheScene) {
  const Result<Description> none = read("gone.json");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.problems().size(), 1U);
  EXPECT_EQ(firstProblem(none).substr(0, 34), "scene.json:2: arm: The arm " + folder.path().substr(0, 7))
      << firstProblem(none);
  EXPECT_NE(firstProblem(none).find("gone.json: "), std::string::npos);
  folder.write("mine.json", std::string(kLargestArmFile + 1, ' '));
  EXPECT_EQ(firstProblem(read("mine.json")).substr(0, 18), "scene.json:2: arm:");
}

TEST_F(SceneArm, AllProblemsOfTheSceneAreToldBesideThoseOfItsArm) {
  folder.write("mine.json", "{}");
  const Result<Description> both =
      readSceneFile(folder.write("scene.json", sceneWithArm("mine.json", "\"combine\": \"add\",\n")));
  ASSERT_FALSE(both);
  EXPECT_EQ(firstProblem(both).substr(0, 22), "scene.json:3: combine:");
  EXPECT_GT(both.problems().size(), 2U);
  EXPECT_EQ(both.problems().back().place.file, folder.file("mine.json"));
}

TEST_F(SceneArm, NamesAreCorrected) {
  const auto toldOf = [](const std::string& arm) { return firstProblem(readScene(sceneWithArm(arm), "s")); };
  EXPECT_NE(toldOf("touch-mesured").find("Did you mean \"touch-measured\"?"), std::string::npos);
}

TEST_F(SceneArm, OfAnotherFormIsNamedOrAFileOrUrdf) {
  const tick::TickProgram by_name = compile(read("ur5e").value()).value();
  ASSERT_FALSE(arm::solvesInTick(by_name.geometry));
  EXPECT_EQ(by_name.limits.max_force_N, 5.0) << "its file does not say";
  folder.write("mine.urdf", arm::textOf(*arm::findModel("ur5e"), arm::ArmForm::Urdf).value());
  const Result<Description> by_file = read("mine.urdf");
  ASSERT_TRUE(by_file) << firstProblem(by_file);
  const arm::Mechanism& arm = *compile(by_file.value()).value().geometry.mechanism;
  EXPECT_EQ(arm.chain.joints.size(), 6U);
  EXPECT_EQ(arm.driven, by_name.geometry.mechanism->driven);
}

TEST_F(SceneArm, OfAnotherFormHasNoControlInJointSpace) {
  const std::string text = sceneWithArm("ur5e", "\"control\": {\"space\": \"joint\"},\n");
  EXPECT_NE(firstProblem(readScene(text, "s")).find("control.space: The control of joints follows the closed form"),
            std::string::npos)
      << firstProblem(readScene(text, "s"));
}

TEST_F(SceneArm, OfAnotherFormIsTheSameArmAgainFromARecording) {
  const Description scene = read("cobra-600").value();
  const Description again = readScene(writeScene(withoutFolders(scene)), "session.h5", NamedFiles::Closed).value();
  EXPECT_EQ(compile(again).value().geometry, compile(scene).value().geometry);
}

TEST_F(SceneArm, RecordedSceneContainsTheFileAndNeedsItNoMore) {
  const std::string path = folder.write("mine.json", test::armFile("140"));
  const Description scene = read("mine.json").value();
  const std::string recorded = writeScene(withoutFolders(scene));
  fs::remove(path);
  EXPECT_FALSE(readScene(sceneWithArm(path), "s"));
  const Result<Description> again = readScene(recorded, "session.h5", NamedFiles::Closed);
  ASSERT_TRUE(again) << firstProblem(again);
  EXPECT_EQ(again.value().arm, "mine.json");
  EXPECT_EQ(armTextOf(again.value()), test::armFile("140"));
  EXPECT_TRUE(haveSameArm(again.value(), scene));
  EXPECT_EQ(compile(again.value()).value().geometry, compile(scene).value().geometry);
  EXPECT_EQ(writeScene(withoutFolders(again.value())), recorded);
}

TEST_F(SceneArm, RecordedSceneOpensNoFile) {
  const std::string path = folder.write("mine.json", test::armFile("140"));
  EXPECT_TRUE(readScene(sceneWithArm(path), "s"));
  EXPECT_NE(firstProblem(readScene(sceneWithArm(path), "s", NamedFiles::Closed)).find("the recording does not say"),
            std::string::npos);
  EXPECT_NE(
      firstProblem(readScene(sceneWithArm("omni-thesis", "\"arm_text\": \"{}\",\n"), "s")).find("\"arm\" names none"),
      std::string::npos);
}

TEST_F(SceneArm, NoFolderOfTheDiskIsRecorded) {
  const std::string path = folder.write("mine.json", test::armFile("140"));
  EXPECT_EQ(writeScene(withoutFolders(read(path).value())).find(folder.path()), std::string::npos);
}

TEST_F(SceneArm, SavedElsewhereTheSceneFindsItsArm) {
  fs::create_directory(folder.file("deep"));
  folder.write("mine.json", test::armFile("140"));
  const Description named = namedFrom(read("mine.json").value(), folder.file("deep/copy.json"));
  EXPECT_EQ(named.arm, "../mine.json");
  EXPECT_EQ(armOf(named).geometry.upper_m, 0.14);
  folder.write("deep/copy.json", writeScene(named));
  const Result<Description> copy = readSceneFile(folder.file("deep/copy.json"));
  ASSERT_TRUE(copy) << firstProblem(copy);
  EXPECT_EQ(armOf(copy.value()).geometry.upper_m, 0.14);
}

TEST_F(SceneArm, OtherContentIsAnotherArmThoughTheNameIsTheSame) {
  folder.write("mine.json", test::armFile("140"));
  const Description before = read("mine.json").value();
  folder.write("mine.json", test::armFile("141"));
  const Description after = read("mine.json").value();
  EXPECT_FALSE(isSame(before, after));
  EXPECT_EQ(changeBetween(before, after), Change::Scene);
  EXPECT_EQ(changeBetween(before, before), Change::Gains);
  EXPECT_DOUBLE_EQ(armOf(withArmOf(after, before)).geometry.upper_m, 0.141);
}

TEST_F(SceneArm, WithoutOneThereIsTheDefaultArmAndAProblem) {
  Description scene = readScene(sceneWithArm("omni-thesis"), "s").value();
  scene.arm = "nowhere.json";
  EXPECT_EQ(findArm(scene), nullptr);
  EXPECT_EQ(armOf(scene).name, arm::kDefaultArm);
  EXPECT_EQ(modelOf(scene).name, arm::kDefaultArm);
  EXPECT_TRUE(armTextOf(scene).empty());
  EXPECT_FALSE(compile(scene));
}

}  // namespace
}  // namespace underact::scene
