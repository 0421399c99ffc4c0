#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/arm/arm_text.h"
#include "core/arm/solid_place.h"
#include "core/arm/urdf.h"
#include "core/chain/inverse.h"
#include "tests/support/property.h"
#include "tests/support/scratch_folder.h"

namespace underact::arm {
namespace {

namespace fs = std::filesystem;

using test::Random;

/// Words of both formats, some of them where they do harm.
const std::vector<std::string> kWords{"\"type\": \"prismatic\"",
                                      "revolute",
                                      "classic",
                                      "\"joints\"",
                                      "\"axis\": [0, 0, 0]",
                                      "null",
                                      "1e308",
                                      "-1e308",
                                      "1e-320",
                                      "0",
                                      "nan",
                                      "\"min_deg\": 5",
                                      "[[",
                                      "]",
                                      "}",
                                      "{",
                                      "<joint",
                                      "</joint>",
                                      "<link name=\"x\"/>",
                                      "<mimic/>",
                                      "floating",
                                      "<!DOCTYPE a>",
                                      "&#0;",
                                      "&lt;",
                                      "<![CDATA[",
                                      "-->",
                                      "<!--",
                                      "xyz=\"1 2 3\"",
                                      "rpy=\"9e9 0 0\"",
                                      "\"",
                                      "'",
                                      "\xff",
                                      "/>",
                                      "<visual><geometry><mesh filename=\"package://a/../b.stl\" scale=\"1 1 -1\"/>"
                                      "</geometry></visual>",
                                      "filename=\"../../../../etc/passwd\"",
                                      "\"type\": \"mesh\", \"file\": \"a.stl\"",
                                      "\"scale_mm_per_unit\": [1, -1, 1000]",
                                      "package://",
                                      "..",
                                      "/"};

/// Names of meshes, as files from anybody have them.
const std::vector<std::string> kMeshNames{"meshes/a.stl",
                                          "../meshes/a.stl",
                                          "package://robot/meshes/a.stl",
                                          "package://robot/../../secret.stl",
                                          "file:///etc/passwd",
                                          "/etc/passwd",
                                          "linked/a.stl"};

std::string mutated(std::string text, Random& random) {
  const std::size_t changes = 1 + random.below(6);
  for (std::size_t change = 0; change < changes && !text.empty(); ++change) {
    const std::size_t at = random.below(text.size()), far = std::min(text.size() - at, 1 + random.below(40));
    switch (random.below(6)) {
      case 0:
        text[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        text.erase(at, far);
        break;
      case 2:
        text.insert(at, text.substr(random.below(text.size()), far));
        break;
      case 3:
        text.insert(at, kWords[random.below(kWords.size())]);
        break;
      case 4:
        text.replace(at, far, kWords[random.below(kWords.size())]);
        break;
      default:
        if (text[at] >= '0' && text[at] <= '9') text[at] = static_cast<char>('0' + random.below(10));
        break;
    }
  }
  return text;
}

/// The folder of the arm of this test, with a package, a secret beside it and a link that leads there.
const fs::path& folderOfArm() {
  static const test::ScratchFolder scratch;
  static const fs::path folder = [] {
    const fs::path root = fs::canonical(scratch.path());
    for (const char* name : {"robot/package.xml", "robot/meshes/a.stl", "robot/urdf/meshes/a.stl", "secret/a.stl",
                             "secret.stl", "a.stl"}) {
      fs::create_directories((root / name).parent_path());
      std::ofstream(root / name) << "text";
    }
    fs::create_directory_symlink(root / "secret", root / "robot/urdf/linked");
    return root / "robot/urdf";
  }();
  return folder;
}

/// Each mesh is a file of the package that the arm is in, or has a sentence.
void expectSoundMeshes(Model model) {
  ASSERT_TRUE(model.folder.empty());
  model.folder = folderOfArm().string();
  const std::string package = folderOfArm().parent_path().string() + "/";
  for (const LinkSolid& solid : model.solids) {
    const auto* const mesh = std::get_if<MeshSolid>(&solid.form);
    if (mesh == nullptr) continue;
    ASSERT_TRUE(isMeshScale(mesh->m_per_unit));
    const Result<std::string> file = fileOfSolid(model, *mesh);
    ASSERT_TRUE(file ? (file.value() + "/").starts_with(package) : !file.problems().front().sentence.empty())
        << mesh->name;
  }
}

/// What reads is an arm that everything can be asked of; what does not has its problems, each a sentence.
void expectSound(const Result<Model>& read) {
  if (!read) {
    ASSERT_FALSE(read.problems().empty());
    for (const Problem& problem : read.problems()) ASSERT_FALSE(problem.sentence.empty());
    return;
  }
  const Model& model = read.value();
  const std::size_t count = model.chain.joints.size();
  ASSERT_TRUE(count >= 1 && count <= kMaxJoints);
  ASSERT_EQ(model.rows.size(), count);
  ASSERT_EQ(model.joints.size(), count);
  ASSERT_TRUE(model.masses.empty() || model.masses.size() == count);
  const std::vector<double> home(count, 0.1);
  const Pose X_WT = chain::forward(model.chain, home);
  ASSERT_TRUE(X_WT.matrix().allFinite());
  const chain::Inverse inverse = chain::inverseOf(model.chain);
  const chain::InverseSolutions found = chain::solveAll(inverse, X_WT);
  for (std::size_t i = 0; i < found.count; ++i) {
    for (std::size_t joint = 0; joint < count; ++joint) ASSERT_TRUE(std::isfinite(found.all[i].q[joint]));
  }
  expectSoundMeshes(model);
  for (const ArmForm form : {ArmForm::ModifiedDh, ArmForm::Exponentials, ArmForm::Urdf}) {
    const Result<std::string> text = textOf(model, form);
    ASSERT_TRUE(text || !text.problems().empty());
  }
}

TEST(ArmMutation, NoNameOfAMeshLeadsOutOfWhatWasOpened) {
  Random random({322});
  Model model;
  model.folder = folderOfArm().string();
  const std::string package = folderOfArm().parent_path().string() + "/";
  int found = 0;
  for (int draw = 0; draw < test::sweep(3000, 100000); ++draw) {
    std::string name = kMeshNames[random.below(kMeshNames.size())];
    if (random.below(4) > 0) name = mutated(name, random);
    if (random.below(3) == 0) name.insert(random.below(name.size() + 1), random.below(2) == 0 ? "../" : "/");
    const Result<std::string> file = fileOfSolid(model, {name, Vec3::Ones(), {}});
    found += file ? 1 : 0;
    ASSERT_TRUE(file ? (file.value() + "/").starts_with(package) : !file.problems().front().sentence.empty()) << name;
  }
  EXPECT_GT(found, 100) << "hardly any name is still one of a file";
}

TEST(ArmMutation, FilesAreAnArmOrSayWhatIsWrong) {
  Random random({321});
  std::vector<std::string> texts, robots;
  for (const Model& model : models()) {
    texts.emplace_back(fileOf(model.name));
    for (const ArmForm form : {ArmForm::Exponentials, ArmForm::Urdf}) {
      const Result<std::string> text = textOf(model, form);
      if (text) (form == ArmForm::Urdf ? robots : texts).push_back(text.value());
    }
  }
  ASSERT_GE(robots.size(), 5U);
  for (const std::string& name : kMeshNames) {  // an arm that is drawn by meshes
    Model model = *findModel("ur5e");
    for (const std::size_t link : {std::size_t{0}, std::size_t{3}})
      model.solids.push_back({link, Pose::Identity(), MeshSolid{name, Vec3(1.0, -1.0, 1e-3), {}}});
    texts.push_back(textOf(model, ArmForm::ModifiedDh).value());
    robots.push_back(textOf(model, ArmForm::Urdf).value());
  }
  const int draws = test::sweep(3000, 100000);
  int arms = 0, urdf_arms = 0;
  for (int draw = 0; draw < draws && !testing::Test::HasFailure(); ++draw) {
    const std::string text = mutated(texts[random.below(texts.size())], random);
    SCOPED_TRACE(text);
    const Result<Model> read = readArm(text, "a.json");
    arms += read ? 1 : 0;
    expectSound(read);
  }
  for (int draw = 0; draw < draws && !testing::Test::HasFailure(); ++draw) {
    const std::string text = mutated(robots[random.below(robots.size())], random);
    SCOPED_TRACE(text);
    const UrdfEnds ends{random.below(2) == 0 ? "base_link" : "", random.below(2) == 0 ? "tip" : ""};
    const Result<Model> read = readUrdf(text, "a.urdf", ends);
    urdf_arms += read ? 1 : 0;
    expectSound(read);
  }
  EXPECT_GT(arms, draws / 50) << "hardly any of the files is still an arm";
  EXPECT_GT(urdf_arms, draws / 50);
  RecordProperty("arms", arms);
  RecordProperty("urdf_arms", urdf_arms);
}

}  // namespace
}  // namespace underact::arm
