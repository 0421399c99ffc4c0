#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QTest>

#include "app/gui/files/load_strip.h"
#include "app/gui/mesh/mesh_dialog.h"
#include "core/mesh_file/load.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow meshFeature();
}

namespace underact::gui::test {

TEST(MeshFiles, ASceneWithoutAMeshHasNoReport) {
  Desk desk(meshFeature());
  EXPECT_FALSE(desk.perform("mesh.report"));
}

TEST(MeshFiles, AFileThatIsNoneIsToldAndTheSceneStays) {
  Desk desk(meshFeature());
  desk.perform("mesh.add", desk.fileOf("no.stl", "this is no mesh"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !desk.services().loads->isBusy(); }, 20'000));
  EXPECT_EQ(desk.scene().constraints.size(), 1U);
  EXPECT_EQ(desk.undoText(), QString());
  QTest::qWait(10);
  auto* told = desk.window().findChild<QWidget*>("dialog.mesh_problems");
  EXPECT_TRUE(told != nullptr && told->isVisible());
}

TEST(MeshDialog, AnOpenSurfaceIsNoWallAndAClosedOneIsOfferedAsOne) {
  mesh_file::Loaded loaded;
  loaded.facts.faces = 4;
  loaded.facts.parts = loaded.facts.closed_parts = 1;
  const MeshDialog closed("closed.stl", loaded, {}, true, nullptr);
  EXPECT_EQ(closed.findChild<QComboBox*>("dialog.mesh.side")->count(), 3);
  EXPECT_EQ(closed.constraint().side, target::Side::Outside);
  loaded.facts.closed_parts = 0;
  loaded.facts.borders = 1;
  loaded.facts.border_edges = 3;
  const MeshDialog open("open.stl", loaded, {}, true, nullptr);
  EXPECT_EQ(open.findChild<QComboBox*>("dialog.mesh.side")->count(), 1);
  EXPECT_EQ(open.constraint().side, target::Side::Both);
}

TEST(MeshDialog, FrictionIsWishedOnlyWhereItIsTicked) {
  MeshDialog dialog("a.stl", {}, {}, true, nullptr);
  EXPECT_FALSE(dialog.constraint().friction.has_value());
  dialog.findChild<QCheckBox*>("dialog.mesh.friction")->setChecked(true);
  dialog.findChild<QDoubleSpinBox*>("dialog.mesh.static")->setValue(0.8);
  ASSERT_TRUE(dialog.constraint().friction.has_value());
  EXPECT_DOUBLE_EQ(dialog.constraint().friction->static_share, 0.8);
}

}  // namespace underact::gui::test
