#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QRadioButton>
#include <QTableWidget>
#include <QToolButton>
#include <algorithm>
#include <cstdio>

#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "tests/stories/mesh_desk.h"

namespace underact::gui::test {
namespace {

constexpr double kRadius_mm = 30.0;

/// With one face twice, so that there is something to report.
QString ballFile() {
  static const QString kPath =
      temporaryFile("globe.stl", withFirstFaceTwice(ballStl(kRadius_mm, Vec3::Zero(), 48, 24)));
  return kPath;
}

QString meshSceneText(const QString& mesh) {
  return QString(R"({"underact_scene": 1, "title": "Ball", "constraints": [
    {"type": "mesh", "file": "%1", "side": "outside"}]})")
      .arg(mesh);
}

}  // namespace

TEST(MeshStory, ADroppedStlIsReportedOnAddedAndFelt) {
  Story story("02_sphere");
  drop(story, ballFile());
  EXPECT_EQ(story.host().scene().title, "Sphere");  // until somebody has read what it is
  ASSERT_TRUE(waitForMeshes(story));
  const QString report = story.find<QLabel>("dialog.mesh.report")->text();
  EXPECT_TRUE(report.contains("1 face was left out: it is a duplicate.")) << report.toStdString();
  EXPECT_TRUE(report.contains("The mesh is closed")) << report.toStdString();
  const QString counts = story.find<QLabel>("dialog.mesh.counts")->text();
  EXPECT_TRUE(counts.contains("2208 triangles") && counts.contains("60.0 mm")) << counts.toStdString();
  EXPECT_EQ(story.find<QComboBox>("dialog.mesh.side")->count(), 3);
  EXPECT_FALSE(story.find("dialog.mesh")->isModal());
  keepPicture(story, "dialog.mesh", "mesh_dialog");
  story.find<QPushButton>("dialog.mesh.new")->click();
  story.settle();
  EXPECT_EQ(story.host().scene().title, "globe");
  ASSERT_EQ(story.host().scene().constraints.size(), 1U);
  EXPECT_EQ(story.host().scene().constraints[0].side, target::Side::Outside);
  EXPECT_TRUE(story.window().isWindowModified());  // no file holds it

  handTo(story, {0.0, 0.0, 0.045});
  ASSERT_TRUE(story.perform("session.start"));
  story.run(2000);
  EXPECT_EQ(story.force_N(), 0.0);  // outside a wall
  EXPECT_EQ(story.view().patchDrawn(), 0U);
  handTo(story, {0.002, 0.001, 0.0292});
  EXPECT_GT(story.snapshot().report.force.f_T_W().z(), 0.05);  // pushed out
  EXPECT_GT(story.view().patchDrawn(), 6U);
  story.savePicture("mesh_ball");
  handTo(story, {0.0, 0.0, 0.045});
  EXPECT_EQ(story.force_N(), 0.0);
}

TEST(MeshStory, AddedToTheSceneItIsOneStepBackAndForth) {
  Story story("02_sphere");
  drop(story, ballFile());
  ASSERT_TRUE(waitForMeshes(story));
  story.find<QComboBox>("dialog.mesh.side")->setCurrentIndex(2);
  story.find<QCheckBox>("dialog.mesh.friction")->setChecked(true);
  story.find<QPushButton>("dialog.mesh.add")->click();
  story.settle();
  ASSERT_EQ(story.host().scene().constraints.size(), 2U);
  EXPECT_EQ(story.host().scene().constraints[1].name, "globe");
  EXPECT_EQ(story.host().scene().constraints[1].side, target::Side::Both);
  EXPECT_TRUE(story.host().scene().constraints[1].friction.has_value());
  EXPECT_GT(story.view().trianglesDrawn(), 0U);
  story.perform("edit.undo");
  EXPECT_EQ(story.host().scene().constraints.size(), 1U);
  EXPECT_EQ(story.view().trianglesDrawn(), 0U);
  story.perform("edit.redo");
  ASSERT_EQ(story.host().scene().constraints.size(), 2U);
  EXPECT_NE(meshOf(story, 1).surface, nullptr);
  EXPECT_GT(story.view().trianglesDrawn(), 0U);
}

TEST(MeshStory, AFileInMetresIsAskedAbout) {
  Story story("");
  drop(story, temporaryFile("metres.stl", ballStl(0.03, Vec3(1.0, 0.0, 0.0), 24, 12)));
  ASSERT_TRUE(waitForMeshes(story));
  const QString question = story.find<QLabel>("dialog.mesh.question")->text();
  EXPECT_TRUE(question.contains("Read as millimetres, the mesh is 0.06 mm long")) << question.toStdString();
  auto* likeliest = story.find<QRadioButton>("dialog.mesh.unit.0");
  EXPECT_TRUE(likeliest->text().contains("metres") && likeliest->text().contains("60.0 mm"));
  EXPECT_TRUE(likeliest->isChecked());
  auto* counts = story.find<QLabel>("dialog.mesh.counts");
  EXPECT_TRUE(counts->text().contains("60.0")) << counts->text().toStdString();
  keepPicture(story, "dialog.mesh", "mesh_unit_question");
  EXPECT_FALSE(story.find("dialog.mesh.add")->isEnabled());  // there is no scene to add it to
  story.find<QPushButton>("dialog.mesh.new")->click();
  story.settle();
  EXPECT_EQ(meshOf(story).scale_mm_per_unit, 1000.0);
  // It stood a metre beside the workspace. Floats hold a metre to 6e-8 of it.
  EXPECT_NEAR(meshOf(story).X_WM(0, 3), -1000.0, 1e-3);
}

TEST(MeshStory, AnOpenOneSaysWhyItIsNoWall) {
  Story story("02_sphere");
  drop(story, temporaryFile("open.stl", boxStl({20, 20, 20}, true)));
  ASSERT_TRUE(waitForMeshes(story));
  const QString report = story.find<QLabel>("dialog.mesh.report")->text();
  EXPECT_TRUE(report.contains("both sides only: it is open")) << report.toStdString();
  EXPECT_EQ(story.find<QComboBox>("dialog.mesh.side")->count(), 1);
}

TEST(MeshStory, ABrokenFileGivesASentenceAndTheSceneRunsOn) {
  Story story("02_sphere");
  story.perform("session.start");
  story.run(500);
  const std::uint64_t before = story.host().revision();
  drop(story, temporaryFile("broken.stl", QByteArray("solid of nothing\nthat anybody could read\n")));
  ASSERT_TRUE(waitForMeshes(story));
  auto* box = story.find<QMessageBox>("dialog.open_problems");
  ASSERT_NE(box, nullptr);
  EXPECT_FALSE(box->isModal());
  EXPECT_FALSE(box->informativeText().isEmpty());
  story.run(500);
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
  EXPECT_EQ(story.host().revision(), before);
  box->close();
}

TEST(MeshStory, WhatWasSaidOfAFileThatFailedGoesWithTheNextOne) {
  Story story("02_sphere");
  drop(story, temporaryFile("broken.stl", "solid nothing"));
  ASSERT_TRUE(waitForMeshes(story));
  QPointer<QWidget> shown = story.find("dialog.open_problems");
  ASSERT_NE(shown, nullptr);
  drop(story, temporaryFile("good.stl", ballStl(20.0, Vec3::Zero(), 24, 12)));
  ASSERT_TRUE(waitForMeshes(story));
  story.settle();
  EXPECT_TRUE(shown == nullptr || !shown->isVisible());
  drop(story, temporaryFile("broken.json", "{"));
  ASSERT_TRUE(story.find("dialog.problems")->isVisible());
  drop(story, temporaryFile("good.stl"));
  ASSERT_TRUE(waitForMeshes(story));
  EXPECT_FALSE(story.find("dialog.problems")->isVisible());
}

TEST(MeshStory, TheHintOfWhatThePointerWasOverIsGoneAfterADrop) {
  Story story("02_sphere");
  story.moveTo(story.find("panel.feel.button.edit.redo"), QPoint(8, 8));
  ASSERT_FALSE(story.find<QLabel>("status.tip")->text().isEmpty());
  drop(story, shippedScene("04_plane"));
  EXPECT_EQ(story.find<QLabel>("status.tip")->text(), QString());
}

TEST(MeshStory, ABigOneLoadsWhileTheServoRunsIsCancelledAndIsDrawnCoarser) {
  constexpr int kSectors = 560, kRings = 280;  // 312 480 triangles
  const QString path = temporaryFile("big.stl", ballStl(kRadius_mm, Vec3::Zero(), kSectors, kRings));
  Story story("02_sphere");
  story.perform("session.start");
  story.run(100);
  drop(story, path);
  ASSERT_TRUE(story.find("load")->isVisible());
  story.run(500);
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
  keepPicture(story, "load", "mesh_load");
  story.click(story.find("load.cancel"));
  EXPECT_FALSE(story.find("load")->isVisible());
  story.settle(300);
  EXPECT_EQ(story.window().findChild<QDialog*>("dialog.mesh"), nullptr);
  openMesh(story, path);
  const std::size_t felt = meshOf(story).surface->triangles.faces.size();
  EXPECT_EQ(felt, 2U * kSectors * (kRings - 1));
  EXPECT_LE(story.view().trianglesDrawn(), 100'000U);
  EXPECT_GT(story.view().trianglesDrawn(), 10'000U);
  double slowest_ms = 0.0;  // a number for the reader
  QObject::connect(&story.view(), &SceneView::drawn, &story.view(),
                   [&slowest_ms](double frame_ms) { slowest_ms = std::max(slowest_ms, frame_ms); });
  handTo(story, {0.0, 0.0, 0.05});
  story.settle(200);
  std::printf("%zu triangles drawn of %zu, a frame in %.1f ms at most\n", story.view().trianglesDrawn(), felt,
              slowest_ms);
}

TEST(MeshStory, ASceneWithAMeshIsSavedElsewhereAndOpenedAgain) {
  const QString name = QFileInfo(ballFile()).fileName();
  const QString first = temporaryFile("with_ball.json", meshSceneText(name).toUtf8());
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("scene.open", first));
  EXPECT_EQ(story.host().scene().title, "Sphere");  // until its mesh is there
  ASSERT_TRUE(waitForMeshes(story));
  EXPECT_EQ(story.host().scene().title, "Ball");
  const QString folder = QFileInfo(first).absolutePath() + "/elsewhere";
  ASSERT_TRUE(QDir().mkpath(folder));
  ASSERT_TRUE(story.perform("scene.save_as", folder + "/saved.json"));
  const Result<scene::Description> saved = scene::readSceneFile((folder + "/saved.json").toStdString());
  ASSERT_TRUE(saved);
  EXPECT_EQ(std::get<scene::Mesh>(saved.value().constraints[0].shape).file, ("../" + name).toStdString());
  ASSERT_TRUE(story.perform("scene.open", shippedScene("02_sphere")));
  ASSERT_TRUE(story.perform("scene.open", folder + "/saved.json"));
  ASSERT_TRUE(waitForMeshes(story));
  EXPECT_EQ(story.host().scene().title, "Ball");
  EXPECT_NE(meshOf(story).surface, nullptr);
}

TEST(MeshStory, ASceneWhoseMeshIsGoneSaysSoAndTheOldOneStays) {
  Story story("02_sphere");
  story.perform("scene.open", temporaryFile("gone.json", meshSceneText("gone.stl").toUtf8()));
  ASSERT_TRUE(waitForMeshes(story));
  auto* table = story.find<QTableWidget>("dialog.problems.table");
  ASSERT_TRUE(table->isVisible());
  EXPECT_EQ(table->item(0, 0)->text(), "2");  // the line of the constraint
  EXPECT_EQ(story.host().scene().title, "Sphere");
}

TEST(MeshStory, TheReportCanBeReadAgain) {
  Story story("02_sphere");
  EXPECT_FALSE(story.find("panel.shape.report")->isVisible());
  openMesh(story, ballFile());
  story.find<QToolButton>("panel.shape.report")->click();
  ASSERT_TRUE(waitForMeshes(story));
  const auto* report = story.find<QLabel>("dialog.mesh.report");
  ASSERT_NE(report, nullptr);
  EXPECT_TRUE(report->text().contains("The mesh is closed"));
  EXPECT_EQ(story.window().findChild<QPushButton*>("dialog.mesh.add"), nullptr);
}

}  // namespace underact::gui::test
