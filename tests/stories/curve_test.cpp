#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <cmath>
#include <cstdio>

#include "app/gui/model/scene_loading.h"
#include "core/base/units.h"
#include "core/scene/read.h"
#include "tests/stories/mesh_desk.h"

namespace underact::gui::test {
namespace {

const scene::Curve& curveOf(Story& story, std::size_t index = 0) {
  return std::get<scene::Curve>(story.host().scene().constraints.at(index).shape);
}

/// A square of 40 mm in the plane z = 0, from corner to corner, open.
QString squareFile() {
  static const QString kPath =
      temporaryFile("square.csv", "x,y,z\n-20,-20,0\n20,-20,0\n20,20,0\n-20,20,0\n# back by \"closed\"\n");
  return kPath;
}

/// A helix in the unit of radius, count points.
QByteArray helix(int count, double radius, const Vec3& middle) {
  QByteArray text;
  for (int point = 0; point < count; ++point) {
    const double share = static_cast<double>(point) / (count - 1), angle_rad = 20.0 * kPi * share;
    text += QByteArray::number(middle.x() + radius * std::cos(angle_rad), 'g', 12) + ' ' +
            QByteArray::number(middle.y() + radius * std::sin(angle_rad), 'g', 12) + ' ' +
            QByteArray::number(middle.z() + radius * (share - 0.5), 'g', 12) + '\n';
  }
  return text;
}

}  // namespace

TEST(CurveStory, ADroppedFileOfPointsIsAskedAboutAddedFeltAndTakenBack) {
  Story story("02_sphere");
  drop(story, squareFile());
  ASSERT_TRUE(waitForMeshes(story));
  const auto* counts = story.find<QLabel>("dialog.curve.counts");
  ASSERT_NE(counts, nullptr);
  EXPECT_EQ(counts->text(), "4 points, 40.0 × 40.0 × 0.0 mm, length 120.0 mm.");
  EXPECT_FALSE(story.find("dialog.curve")->isModal());
  story.find<QComboBox>("dialog.curve.kind")->setCurrentIndex(1);
  story.find<QCheckBox>("dialog.curve.closed")->setChecked(true);
  EXPECT_TRUE(counts->text().contains("length 160.0 mm")) << counts->text().toStdString();
  keepPicture(story, "dialog.curve", "curve_dialog");
  story.find<QPushButton>("dialog.curve.add")->click();
  ASSERT_TRUE(waitForMeshes(story));
  ASSERT_EQ(story.host().scene().constraints.size(), 2U);
  EXPECT_EQ(story.host().scene().constraints[1].name, "square");
  EXPECT_EQ(curveOf(story, 1).kind, curve::CurveKind::Polyline);
  EXPECT_TRUE(curveOf(story, 1).closed);
  EXPECT_TRUE(story.window().isWindowModified());
  story.settle();
  EXPECT_EQ(story.window().findChild<QDialog*>("dialog.curve"), nullptr);

  story.perform("edit.undo");
  EXPECT_EQ(story.host().scene().constraints.size(), 1U);
  story.perform("edit.redo");
  ASSERT_EQ(story.host().scene().constraints.size(), 2U);
  handTo(story, {-0.025, 0.0, 0.0});
  ASSERT_TRUE(story.perform("session.start"));
  story.run(1000);
  EXPECT_NEAR(1e3 * story.snapshot().report.held[1].p_WP.x(), -20.0, 1e-9);  // on the side that closes it
}

TEST(CurveStory, AFileInMetresBecomesANewSceneThatIsSavedAndOpenedAgain) {
  Story story("");
  drop(story, temporaryFile("helix.txt", helix(400, 0.03, Vec3(1.0, 0.0, 0.0))));
  ASSERT_TRUE(waitForMeshes(story));
  const QString question = story.find<QLabel>("dialog.curve.question")->text();
  EXPECT_EQ(question, "In millimetres the curve would be 0.1 mm long. It is assumed to be in metres.");
  EXPECT_EQ(story.find<QDoubleSpinBox>("dialog.curve.scale")->value(), 1000.0);
  EXPECT_TRUE(story.find<QLabel>("dialog.curve.counts")->text().contains("60.0 × 60.0 × 30.0 mm"));
  EXPECT_FALSE(story.find("dialog.curve.add")->isEnabled());  // there is no scene to add it to
  story.perform("view.theme.dark");
  keepPicture(story, "dialog.curve", "curve_unit_question_dark");
  story.find<QPushButton>("dialog.curve.new")->click();
  ASSERT_TRUE(waitForMeshes(story));
  EXPECT_EQ(story.host().scene().title, "helix");
  EXPECT_EQ(curveOf(story).scale_mm_per_unit, 1000.0);
  EXPECT_NEAR(curveOf(story).X_WM(0, 3), -1000.0, 0.1);  // it stood a metre beside the workspace; 400 points of it
  EXPECT_EQ(curveOf(story).kind, curve::CurveKind::Spline);
  story.savePicture("curve_helix_dark");

  const QString saved = temporaryFile("helix_scene.json");
  ASSERT_TRUE(story.perform("scene.save_as", saved));
  const Result<scene::Description> read = scene::readSceneFile(saved.toStdString());
  ASSERT_TRUE(read);
  EXPECT_EQ(std::get<scene::Curve>(read.value().constraints[0].shape).file, "helix.txt");
  ASSERT_TRUE(story.perform("scene.open", shippedScene("02_sphere")));
  ASSERT_TRUE(story.perform("scene.open", saved));
  ASSERT_TRUE(waitForMeshes(story));
  EXPECT_EQ(curveOf(story).points->size(), 400U);
}

TEST(CurveStory, ALineThatIsNoPointIsToldAndTheSceneStays) {
  Story story("02_sphere");
  const std::uint64_t before = story.host().revision();
  ASSERT_TRUE(story.perform("curve.add", temporaryFile("broken.xyz", "0 0 0\n1 2\n1 2 three\n")));
  ASSERT_TRUE(waitForMeshes(story));
  auto* box = story.find<QMessageBox>("dialog.curve_problems");
  ASSERT_NE(box, nullptr);
  EXPECT_FALSE(box->isModal());
  EXPECT_TRUE(box->informativeText().contains("Line 2: A point is three numbers, not 2")) << "and where";
  EXPECT_TRUE(box->informativeText().contains("Line 3: \"three\" is not a number."))
      << box->informativeText().toStdString();
  EXPECT_EQ(story.host().revision(), before);
  box->close();
}

TEST(CurveStory, TwoPointsCannotBeClosedAndTheDialogSaysSo) {
  Story story("02_sphere");
  drop(story, temporaryFile("two.pts", "0 0 0\n30 0 0\n"));
  ASSERT_TRUE(waitForMeshes(story));
  story.find<QCheckBox>("dialog.curve.closed")->setChecked(true);
  story.find<QPushButton>("dialog.curve.add")->click();
  ASSERT_TRUE(waitForMeshes(story));
  const auto* refusal = story.find<QLabel>("dialog.curve.refusal");
  EXPECT_TRUE(refusal->isVisible());
  EXPECT_FALSE(refusal->text().isEmpty());
  EXPECT_EQ(story.host().scene().constraints.size(), 1U);
  story.find<QCheckBox>("dialog.curve.closed")->setChecked(false);
  story.find<QPushButton>("dialog.curve.add")->click();
  ASSERT_TRUE(waitForMeshes(story));
  EXPECT_EQ(story.host().scene().constraints.size(), 2U);
}

TEST(CurveStory, AMillionPointsAreMadeOnceAndNotInTheWindowsThread) {
  Story story("");
  drop(story, temporaryFile("million.txt", helix(1'000'000, 30.0, Vec3::Zero())));
  ASSERT_TRUE(waitForMeshes(story));
  story.find<QPushButton>("dialog.curve.new")->click();
  ASSERT_TRUE(waitForMeshes(story));
  ASSERT_EQ(story.host().scene().title, "million");
  const auto made = [&story] { return madeCurves(story.host().scene(), {}).at(0).curve.get(); };
  const curve::Curve* const first = made();
  QElapsedTimer clock;
  clock.start();
  ASSERT_TRUE(story.perform("gains.set", "kp", "x", 0.25));
  std::printf("an edit of a gain of a spline of a million points: %lld ms\n", clock.elapsed());
  EXPECT_EQ(made(), first);
  ASSERT_TRUE(story.perform("edit.undo"));
  EXPECT_EQ(made(), first);
}

}  // namespace underact::gui::test
