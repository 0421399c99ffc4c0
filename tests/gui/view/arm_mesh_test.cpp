// Meshes of an arm's file: read by the reader's process, drawn in place of the formula, and said where they are not.
#include "app/gui/view/arm_mesh.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <functional>

#include "app/gui/view/arm_picture.h"
#include "core/arm/urdf.h"
#include "core/scene/scene_arm.h"
#include "tests/gui/example.h"

namespace underact::gui {
namespace {

const Vec3 kMiddle_m(0.25, 0.0, 0.1);

/// A cube of edges of 2 about the origin.
constexpr const char* kCube = R"(
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)";

/// An arm of one joint whose link looks like that mesh, with its origin at kMiddle_m.
std::string robotText(const std::string& mesh) {
  return R"(<robot name="r"><link name="a"/><link name="b"><visual><origin xyz="0.25 0 0.1"/><geometry>
<mesh )" +
         mesh +
         R"(/></geometry></visual></link><link name="c"/>
<joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>
<joint name="t" type="fixed"><parent link="b"/><child link="c"/><origin xyz="0.4 0 0.2"/></joint></robot>)";
}

class ArmMeshTest : public testing::Test {
 protected:
  ArmMeshTest() {
    qputenv("UNDERACT_MESH_READER", UNDERACT_BINARY "/underact-mesh-reader");
    write("cube.obj", kCube);
    write("broken.stl", "solid no");
    write("part.dae", "<COLLADA/>");
  }
  std::string write(const char* name, const std::string& text) const {
    QFile file(folder_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text.data(), static_cast<qint64>(text.size()));
    return file.fileName().toStdString();
  }
  arm::Model armWith(const std::string& mesh) const {
    return arm::readArmFile(write("arm.urdf", robotText(mesh))).value();
  }
  QTemporaryDir folder_;
};

/// The least of its triangles' turns about their normals: above 0 where all go round as their normals say.
double minTurn(vtkPolyData& data) {
  double min = kInfinity;
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (data.GetPolys()->InitTraversal(); data.GetPolys()->GetNextCell(count, corners) != 0;) {
    const auto at = [&](int corner) { return Vec3(Eigen::Map<const Vec3>(data.GetPoint(corners[corner]))); };
    const Vec3 first = at(0), delta = at(1) - first, turn = delta.cross(at(2) - first);
    const Vec3 normal = Eigen::Map<const Vec3>(data.GetPointData()->GetNormals()->GetTuple3(corners[0]));
    min = std::min(min, turn.normalized().dot(normal));
  }
  return min;
}

bool comes(const std::function<bool()>& condition) {
  return QTest::qWaitFor(condition, 20000);
}

}  // namespace

TEST_F(ArmMeshTest, IsReadAndPlacedInMetres) {
  const arm::Model model = armWith(R"(filename="cube.obj" scale="0.04 0.02 0.01")");
  const ArmMeshes meshes = readArmMeshes(model, {});
  ASSERT_TRUE(meshes.problems.empty()) << meshes.problems[0].sentence;
  ASSERT_EQ(meshes.of_solids.size(), 1U);
  ASSERT_NE(meshes.of_solids[0], nullptr);
  EXPECT_EQ(meshes.of_solids[0]->body->GetNumberOfPolys(), 12);
  EXPECT_EQ(meshes.of_solids[0]->low, Vec3::Constant(-1.0));
  EXPECT_EQ(meshes.of_solids[0]->high, Vec3::Constant(1.0));
  const ArmSolids arm = solidsOf(model, meshes);
  EXPECT_EQ(arm.solids[0].link, 1U);
  const std::vector<ArmSolid> alone{arm.solids[0]};
  const auto drawn = meshOfLink(alone, 1, {});
  double bounds[6];
  drawn->GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis) {
    const double half_mm = Vec3(40, 20, 10)[axis], middle_mm = 1e3 * kMiddle_m[axis];
    EXPECT_NEAR(bounds[2 * axis], middle_mm - half_mm, 1e-3);
    EXPECT_NEAR(bounds[2 * axis + 1], middle_mm + half_mm, 1e-3);
  }
  EXPECT_GT(minTurn(*drawn), 0.999);
  EXPECT_EQ(readArmMeshes(model, {}).of_solids[0], meshes.of_solids[0]);  // in use: not read again
}

TEST_F(ArmMeshTest, AMirroredOneKeepsItsOutsideOutside) {
  const arm::Model model = armWith(R"(filename="cube.obj" scale="0.04 -0.02 0.01")");
  const std::vector<ArmSolid> alone{solidsOf(model, readArmMeshes(model, {})).solids[0]};
  EXPECT_GT(minTurn(*meshOfLink(alone, 1, {})), 0.999);
}

TEST_F(ArmMeshTest, OneThatIsNotDrawnIsSaidWithItsLineAndTheRestIsDrawn) {
  for (const char* name : {"broken.stl", "none.stl", "../cube.obj", "package://nowhere/cube.obj", "part.dae"}) {
    const arm::Model model = armWith("filename=\"" + std::string(name) + "\"");
    const ArmMeshes meshes = readArmMeshes(model, {});
    ASSERT_EQ(meshes.problems.size(), 1U) << name;
    EXPECT_EQ(meshes.problems[0].place.line, 2) << name;
    EXPECT_NE(meshes.problems[0].sentence.find("is not drawn"), std::string::npos) << meshes.problems[0].sentence;
    EXPECT_EQ(meshes.of_solids[0], nullptr) << name;
    arm::Model bare = model;
    bare.solids.clear();
    EXPECT_EQ(solidsOf(model, meshes).solids.size(), solidsOf(bare).solids.size()) << name;  // by formula
    arm::Model with_box = model;
    with_box.solids.push_back({1, Pose::Identity(), arm::BoxSolid{Vec3::Constant(0.1)}});
    EXPECT_TRUE(std::holds_alternative<BoxForm>(solidsOf(with_box, readArmMeshes(with_box, {})).solids[0].form))
        << name;
  }
}

TEST_F(ArmMeshTest, IsDrawnInTheViewOnceItIsRead) {
  scene::Description scene;
  scene.arm = write("bare.urdf", robotText(R"(filename="none.obj")"));
  ASSERT_TRUE(scene::readSceneArm(scene).empty());
  test::Shown shown(scene);
  shown.view.present(servo::Snapshot());
  const QPoint middle = shown.view.screenOf(kMiddle_m).toPoint();
  const QImage before = shown.view.picture();
  QSignalSpy read(&shown.view, &SceneView::armRead);
  scene.arm = write("arm.urdf", robotText(R"(filename="cube.obj" scale="0.03 0.03 0.03")"));
  ASSERT_TRUE(scene::readSceneArm(scene).empty());
  shown.view.setScene(scene);
  ASSERT_TRUE(comes([&] { return read.count() > 1; }));  // the scene is shown, and then its mesh is read
  EXPECT_TRUE(shown.view.armProblems().empty());
  const QImage after = shown.view.picture();
  EXPECT_NE(after.pixelColor(middle), before.pixelColor(middle));
  EXPECT_LT(after.pixelColor(middle).lightness(), 200);  // of the arm, on a light ground

  scene.arm = write("lost.urdf", robotText(R"(filename="lost.obj")"));
  ASSERT_TRUE(scene::readSceneArm(scene).empty());
  shown.view.setScene(scene);
  ASSERT_TRUE(comes([&] { return !shown.view.armProblems().empty(); }));
  EXPECT_EQ(shown.view.armProblems()[0].place.line, 2);
}

TEST_F(ArmMeshTest, ForgetsAReadMeshWithItsArm) {
  ArmPicture picture;
  picture.setArm(armWith(R"(filename="cube.obj")"));
  EXPECT_TRUE(picture.isReading());
  picture.setArm(*arm::findModel("ur5e"));
  EXPECT_FALSE(picture.isReading());
  EXPECT_FALSE(picture.takeRead());
}

}  // namespace underact::gui
