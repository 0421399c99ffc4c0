// Meshes of arm files: read and written in each form, and which files their names mean.
#include "core/arm/solid_place.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/arm/arm_text.h"
#include "core/arm/urdf.h"
#include "tests/support/scratch_folder.h"

namespace underact::arm {
namespace {

namespace fs = std::filesystem;

std::string robotWithMesh(const std::string& mesh) {
  return R"(<robot name="r"><link name="a"/><link name="b">
    <visual><origin xyz="0 0 0.1"/><geometry>)" +
         mesh + R"(</geometry></visual>
    <visual><geometry><sphere radius="0.02"/></geometry></visual></link>
    <joint name="j" type="continuous"><parent link="a"/><child link="b"/><origin xyz="1 0 0"/><axis xyz="0 0 1"/></joint>
    </robot>)";
}

std::string armWithMesh(const std::string& keys) {
  return R"({"underact_arm": 1, "name": "a", "title": "t", "provenance": "p",
    "joints": [{"axis": [0, 0, 1], "point_mm": [0, 0, 0]}],
    "X_WT_home": [[1, 0, 0, 200], [0, 1, 0, 0], [0, 0, 1, 50], [0, 0, 0, 1]],
    "solids": [{"link": 1, "type": "mesh", )" +
         keys + "}]}";
}

MeshSolid meshOf(const Model& model) {
  return std::get<MeshSolid>(model.solids.at(0).form);
}

std::string meshProblem(const Result<Model>& model) {
  return model ? "" : std::string(model.problems()[0].sentence) + " @" + model.problems()[0].place.key;
}

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

/// A workspace with two packages, an arm in one of them, a folder that is none, and a secret beside them.
class SolidPlace : public testing::Test {
 protected:
  SolidPlace() {
    for (const char* name : {"ws/one/package.xml", "ws/two/package.xml", "ws/one/urdf/arm.urdf",
                             "ws/one/urdf/meshes/near.stl", "ws/one/meshes/link.stl", "ws/two/meshes/hand.stl",
                             "ws/three/far.stl", "secret.stl", "alone/arm.json", "alone/part.stl"})
      write(root_ / name, "text");
    fs::create_symlink(root_ / "secret.stl", root_ / "ws/one/meshes/linked.stl");
    fs::create_symlink(root_ / "ws/three", root_ / "alone/linked");
    fs::create_symlink("link.stl", root_ / "ws/one/meshes/inner.stl");
  }

  /// Where a name leads from the folder of an arm's file, seen from the root; else its sentence.
  std::string whereIs(const std::string& name, const std::string& folder = "ws/one/urdf") {
    Model model;
    model.folder = (root_ / folder).string();
    const Result<std::string> file = fileOfSolid(model, {name, Vec3::Ones(), {"arm.urdf", 7, 0, "filename"}});
    if (file) return fs::relative(file.value(), fs::canonical(root_)).string();
    EXPECT_EQ(file.problems().at(0).place.line, 7) << name;
    return file.problems().at(0).sentence;
  }

  test::ScratchFolder scratch_;
  fs::path root_ = scratch_.path();
};

}  // namespace

TEST(MeshSolid, IsReadFromBothFormatsInMetres) {
  const Model urdf =
      readUrdf(robotWithMesh(R"(<mesh filename="package://p/m.stl" scale="0.001 -0.001 0.002"/>)"), "r.urdf", {})
          .value();
  ASSERT_EQ(urdf.solids.size(), 2U);
  EXPECT_EQ(urdf.solids[0].link, 1U);
  EXPECT_EQ(urdf.solids[0].X_WS.translation(), Vec3(1.0, 0.0, 0.1));
  EXPECT_EQ(meshOf(urdf).name, "package://p/m.stl");
  EXPECT_EQ(meshOf(urdf).m_per_unit, Vec3(0.001, -0.001, 0.002));
  EXPECT_EQ(meshOf(urdf).place.line, 2);
  EXPECT_EQ(meshOf(readUrdf(robotWithMesh(R"(<mesh filename="m.stl"/>)"), "r.urdf", {}).value()).m_per_unit,
            Vec3::Ones());
  const Model json =
      readArm(armWithMesh(R"("file": "m.obj", "scale_mm_per_unit": [1000, 1000, -1000])"), "a.json").value();
  EXPECT_EQ(meshOf(json).name, "m.obj");
  EXPECT_EQ(meshOf(json).m_per_unit, Vec3(1.0, 1.0, -1.0));
  EXPECT_EQ(meshOf(json).place.line, 4);
  EXPECT_EQ(meshOf(readArm(armWithMesh(R"("file": "m.obj")"), "a.json").value()).m_per_unit, Vec3::Constant(1e-3));
}

TEST(MeshSolid, ComesBackInEveryForm) {
  const Model model =
      readArm(armWithMesh(R"("file": "a \"b\" & <c>.stl", "scale_mm_per_unit": [1000, 20, -3])"), "a.json").value();
  for (const ArmForm form : {ArmForm::Exponentials, ArmForm::ModifiedDh, ArmForm::Urdf}) {
    const std::string text = textOf(model, form).value();
    const Model back = (form == ArmForm::Urdf ? readUrdf(text, "b.urdf", {}) : readArm(text, "b.json")).value();
    EXPECT_EQ(meshOf(back).name, meshOf(model).name) << text;
    EXPECT_LT((meshOf(back).m_per_unit - meshOf(model).m_per_unit).norm(), 1e-15) << text;
    EXPECT_LT((back.solids[0].X_WS.matrix() - model.solids[0].X_WS.matrix()).norm(), 1e-12) << text;
  }
}

TEST(MeshSolid, WithoutANameOrASizeIsAnErrorAtItsKey) {
  const auto json = [](const std::string& keys) { return meshProblem(readArm(armWithMesh(keys), "a.json")); };
  const auto urdf = [](const std::string& mesh) {  // a note: a picture moves nothing
    const Problems notes = readUrdf(robotWithMesh(mesh), "r.urdf", {}).value().notes;
    return notes.empty() ? "" : std::string(notes[0].sentence) + " @" + notes[0].place.key;
  };
  EXPECT_NE(json(R"("scale_mm_per_unit": [1, 1, 1])").find("file"), std::string::npos);
  EXPECT_NE(json(R"("file": "")").find("@solids[0].file"), std::string::npos);
  EXPECT_NE(json(R"("file": ")" + std::string(kLongestMeshName + 1, 'a') + "\"").find("1024"), std::string::npos);
  EXPECT_NE(json(R"("file": "m.stl", "scale_mm_per_unit": [1, 0, 1])").find("@solids[0].scale_mm_per_unit"),
            std::string::npos);
  EXPECT_NE(json(R"("file": "m.stl", "size_mm": [1, 1, 1])").find("size_mm"), std::string::npos);
  EXPECT_NE(urdf("<mesh/>").find("@filename"), std::string::npos);
  EXPECT_NE(urdf(R"(<mesh filename="a.stl" scale="1 1"/>)").find("@scale"), std::string::npos);
  EXPECT_NE(urdf(R"(<mesh filename="a.stl" scale="1e9 1 1"/>)").find("@scale"), std::string::npos);
  EXPECT_NE(urdf(R"(<mesh filenam="a.stl"/>)").find("filename"), std::string::npos);
}

TEST_F(SolidPlace, NamesAreRelativeToTheArmsFileAndStayInItsPackage) {
  EXPECT_EQ(whereIs("meshes/near.stl"), "ws/one/urdf/meshes/near.stl");
  EXPECT_EQ(whereIs("../meshes/link.stl"), "ws/one/meshes/link.stl");
  EXPECT_EQ(whereIs("../meshes/inner.stl"), "ws/one/meshes/link.stl");  // a link that stays within
  EXPECT_EQ(whereIs("./meshes/../meshes/near.stl"), "ws/one/urdf/meshes/near.stl");
  EXPECT_EQ(whereIs("part.stl", "alone"), "alone/part.stl");
  EXPECT_NE(whereIs("none.stl", "alone").find("no such file"), std::string::npos);
}

TEST_F(SolidPlace, PackagesAreLookedForAboveWhereTheyArePackages) {
  EXPECT_EQ(whereIs("package://one/meshes/link.stl"), "ws/one/meshes/link.stl");
  EXPECT_EQ(whereIs("package://two/meshes/hand.stl"), "ws/two/meshes/hand.stl");
  EXPECT_EQ(whereIs("package://meshes/near.stl"), "ws/one/urdf/meshes/near.stl");  // below the file itself
  EXPECT_EQ(whereIs("package://alone/part.stl", "alone"), "alone/part.stl");
  EXPECT_NE(whereIs("package://three/far.stl").find("no such package"), std::string::npos);  // no package.xml
  EXPECT_NE(whereIs("package://ws/three/far.stl").find("no such package"), std::string::npos);
  EXPECT_NE(whereIs("package://one/meshes/none.stl").find("no such file"), std::string::npos);
}

TEST_F(SolidPlace, APackageIsFoundByTheNameInItsManifest) {  // a folder as out of an archive
  write(root_ / "ws/gripper-main/package.xml", "<?xml version=\"1.0\"?>\n<package><name>gripper</name></package>");
  write(root_ / "ws/gripper-main/meshes/jaw.stl", "text");
  write(root_ / "ws/gripper-main/urdf/arm.urdf", "text");
  EXPECT_EQ(whereIs("package://gripper/meshes/jaw.stl", "ws/gripper-main/urdf"), "ws/gripper-main/meshes/jaw.stl");
  EXPECT_EQ(whereIs("package://gripper/meshes/jaw.stl", "ws/gripper-main"), "ws/gripper-main/meshes/jaw.stl");
  EXPECT_NE(whereIs("package://gripper/../two/meshes/hand.stl", "ws/gripper-main/urdf").find("leads out"),
            std::string::npos);
  EXPECT_NE(whereIs("package://grip/meshes/jaw.stl", "ws/gripper-main/urdf").find("no such package"),
            std::string::npos);
}

TEST_F(SolidPlace, NoNameLeadsOut) {
  for (const std::string& name :
       {std::string("../../../secret.stl"), std::string("../../three/far.stl"), (root_ / "secret.stl").string(),
        "file://" + (root_ / "secret.stl").string(), std::string("http://example.org/a.stl"),
        std::string("../meshes/linked.stl"), std::string("package://one/../../secret.stl"),
        std::string("package://../secret.stl"), std::string("package:///secret.stl"), std::string("package://"),
        std::string("../../../none.stl"), std::string("a\0b.stl", 7), std::string("a\nb.stl")}) {
    EXPECT_NE(whereIs(name).find("leads out"), std::string::npos) << name << ": " << whereIs(name);
  }
  for (const char* name : {"../secret.stl", "linked/far.stl", "package://linked/far.stl", "../ws/one/meshes/link.stl"})
    EXPECT_NE(whereIs(name, "alone").find("leads out"), std::string::npos) << name << ": " << whereIs(name, "alone");
}

TEST_F(SolidPlace, AnArmOfNoFileHasNoMeshes) {
  Model model = readArm(armWithMesh(R"("file": "part.stl")"), "a.json").value();
  EXPECT_TRUE(model.folder.empty());
  EXPECT_NE(fileOfSolid(model, meshOf(model)).problems().at(0).sentence.find("recording"), std::string::npos);
  EXPECT_TRUE(solidProblems(model).empty());
  write(root_ / "alone/arm.json", armWithMesh(R"("file": "part.stl")"));
  write(root_ / "alone/lost.json", armWithMesh(R"("file": "lost.stl")"));
  model = readArmFile((root_ / "alone/arm.json").string()).value();
  EXPECT_TRUE(solidProblems(model).empty());
  EXPECT_EQ(fileOfSolid(model, meshOf(model)).value(), fs::canonical(root_ / "alone/part.stl").string());
  const Problems problems = solidProblems(readArmFile((root_ / "alone/lost.json").string()).value());
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].place.key, "solids[0].file");
  EXPECT_EQ(problems[0].place.line, 4);
}

}  // namespace underact::arm
