#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>

#include "tests/stories/mesh_desk.h"
#include "tests/stories/picture_difference.h"

namespace underact::gui::test {
namespace {

QString boxFile() {
  static const QString kPath = temporaryFile("box.stl", boxStl({30, 20, 15}, false));
  return kPath;
}
QString seenBallFile() {
  static const QString kPath = temporaryFile("seen_ball.stl", ballStl(30.0, Vec3::Zero(), 48, 24));
  return kPath;
}

QImage viewOf(Story& story) {
  story.settle(300);  // a camera on its way arrives in 0.2 s
  return story.view().picture();
}

}  // namespace

TEST(MeshViewStory, TrianglesAndCutAreShownOnDemand) {
  Story story("");
  openMesh(story, seenBallFile());
  handTo(story, {0.0, 0.0, 0.032});
  const QImage plain = viewOf(story);
  ASSERT_TRUE(story.perform("layer.wires", true));
  const QImage wires = viewOf(story);
  EXPECT_GT(worstBlockDifference(plain, wires), kTolerance);
  ASSERT_TRUE(story.perform("layer.wires", false));
  EXPECT_LT(worstBlockDifference(plain, viewOf(story)), kTolerance);

  ASSERT_TRUE(story.perform("section.x", true));
  ASSERT_TRUE(story.perform("layer.section", true));
  const QImage across_x = viewOf(story);
  EXPECT_GT(worstBlockDifference(plain, across_x), kTolerance);
  ASSERT_TRUE(story.perform("section.y", true));
  EXPECT_GT(worstBlockDifference(across_x, viewOf(story)), kTolerance);
  story.savePicture("mesh_section");
}

TEST(MeshViewStory, TheCutFollowsTheStylusUntilItIsHeld) {
  Story story("");
  openMesh(story, seenBallFile());
  handTo(story, {0.0, 0.0, 0.032});
  Layers layers = story.view().layers();
  layers.arm = layers.target = layers.force = false;
  layers.section = true;
  layers.section_axis = 0;
  story.view().setLayers(layers);
  ASSERT_TRUE(story.perform("layer.section_follows", false));
  handTo(story, {0.020, 0.0, 0.050});
  const QImage still = viewOf(story);
  ASSERT_TRUE(story.perform("layer.section_follows", true));
  story.run(100);
  handTo(story, {0.0205, 0.0, 0.050});
  const QImage moved = viewOf(story);
  // Half a millimetre further on: only a cut that was still in the middle goes far.
  const auto changed = [&](const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    }
    return count;
  };
  EXPECT_GT(changed(still, moved), 2000);
}

TEST(MeshViewStory, CutAxisPlaceAndTrianglesAreRemembered) {
  {
    Story story("");
    openMesh(story, seenBallFile());
    story.perform("layer.wires", true);
    story.perform("section.x", true);
    story.perform("layer.section", true);
    ASSERT_TRUE(story.perform("section.place", 12.5));
  }
  Story story("02_sphere", {.first_start = false});
  EXPECT_TRUE(story.view().layers().wires);
  EXPECT_TRUE(story.view().layers().section);
  EXPECT_FALSE(story.view().layers().section_follows);
  EXPECT_EQ(story.view().layers().section_axis, 0);
  story.run(10);
  EXPECT_EQ(story.view().layers().section_mm.x(), 12.5);
  EXPECT_FALSE(story.find("section")->isVisible());  // a sphere cannot be cut
}

TEST(MeshViewStory, TheCutIsFilledAndGoesWhereTheSliderIs) {
  Story story("");
  openMesh(story, seenBallFile());
  EXPECT_FALSE(story.find("section")->isVisible());
  handTo(story, {0.0, 0.0, 0.010});
  story.bringToFront(&story.window());  // the mesh dialog had the keyboard
  story.key(Qt::Key_M, Qt::AltModifier);
  story.settle();
  auto* slider = story.find<QSlider>("section.slider");
  auto* number = story.find<QDoubleSpinBox>("section.number");
  ASSERT_TRUE(slider->isVisible());
  EXPECT_TRUE(slider->hasFocus());
  const double kShown_mm = 0.05 + 1e-9;                                             // half of the last digit
  EXPECT_NEAR(number->value(), 1e3 * story.snapshot().report.p_WT.z(), kShown_mm);  // it follows the stylus
  EXPECT_GT(story.view().cutPartsDrawn(), 10U);
  story.find<QToolButton>("section.button.section.x")->click();
  EXPECT_EQ(story.view().layers().section_axis, 0);
  EXPECT_TRUE(story.window().actions().find("section.x")->isChecked());
  story.settle();

  const double before_mm = number->value();
  story.key(Qt::Key_Right);
  story.settle();
  EXPECT_FALSE(story.view().layers().section_follows);
  EXPECT_NEAR(number->value(), before_mm + 1.0, 0.11);
  story.key(Qt::Key_PageUp);
  story.settle();
  EXPECT_NEAR(number->value(), before_mm + 11.0, 0.11);
  handTo(story, {0.020, 0.0, 0.0});
  EXPECT_NEAR(number->value(), before_mm + 11.0, 0.11);  // and does so no more
  story.type(number, "-20");
  story.settle();
  EXPECT_EQ(story.view().layers().section_mm.x(), -20.0);
  EXPECT_EQ(slider->value(), -200);
  EXPECT_GT(story.view().cutPartsDrawn(), 10U);
  EXPECT_FALSE(story.perform("section.place", 500.0));  // there is nothing
  ASSERT_TRUE(story.perform("section.place", -40.0));   // past the ball
  story.settle();
  EXPECT_EQ(story.view().cutPartsDrawn(), 0U);

  QTest::mouseDClick(slider, Qt::LeftButton);
  story.run(250);
  EXPECT_TRUE(story.view().layers().section_follows);
  EXPECT_NEAR(number->value(), 1e3 * story.snapshot().report.p_WT.x(), kShown_mm);
  ASSERT_TRUE(story.perform("layer.section", false));
  story.settle();
  EXPECT_FALSE(story.find("section")->isVisible());
}

TEST(MeshViewStory, NothingOfTheStripIsCutInASmallWindowNorAtTwiceTheText) {
  const QFont default_value = QApplication::font();
  for (const double share : {1.0, 2.0}) {
    QFont font = default_value;
    font.setPointSizeF(share * default_value.pointSizeF());
    QApplication::setFont(font);
    {
      Story story("", {.size = share > 1.0 ? QSize(1920, 1080) : QSize(1024, 700)});
      openMesh(story, seenBallFile());
      ASSERT_TRUE(story.perform("layer.section", true));
      story.savePicture(QString("mesh_cut_text_%1").arg(share));
      EXPECT_EQ(story.find<QDoubleSpinBox>("section.number")->value(), 50.0);  // the tip, above the workspace
      EXPECT_GE(story.find("section.slider")->width(), 80);
      for (const auto* button : story.find("section")->findChildren<QToolButton*>())
        EXPECT_GE(button->width(), button->fontMetrics().horizontalAdvance(button->text()) + 8);
      for (const QWidget* part : story.find("section")->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
        const QRect there(part->mapTo(&story.window(), QPoint()), part->size());
        EXPECT_TRUE(story.window().rect().contains(there)) << part->objectName().toStdString();
        EXPECT_GE(part->width(), part->minimumSizeHint().width()) << part->objectName().toStdString();
        EXPECT_EQ(part->visibleRegion().boundingRect(), part->rect()) << part->objectName().toStdString();
      }
    }
  }
  QApplication::setFont(default_value);
}

TEST(MeshViewStory, TheFaceOfACutLooksAsItDidInLightAndDark) {
  Story story("");
  openMesh(story, seenBallFile());
  handTo(story, {0.0, 0.0, 0.010});
  story.perform("session.start");
  handTo(story, {0.005, 0.0, 0.012});
  ASSERT_TRUE(story.perform("section.x", true));
  ASSERT_TRUE(story.perform("layer.section", true));
  EXPECT_FALSE(story.perform("section.place", 1e6));
  EXPECT_TRUE(story.view().layers().section_follows);  // what was refused changes nothing
  ASSERT_TRUE(story.perform("section.place", -5.0));
  story.perform("view.theme.dark");
  story.savePicture("mesh_cut_dark");  // the comparison takes the words out of the view
  story.perform("view.theme.light");
  story.savePicture("mesh_cut");
  EXPECT_LT(story.imageDifference("mesh_section_face"), kTolerance);
  story.perform("view.theme.dark");
  EXPECT_LT(story.imageDifference("mesh_section_face_dark"), kTolerance);
}

TEST(MeshViewStory, ABoxLooksAsItDidInLightAndDark) {
  Story story("");
  openMesh(story, boxFile());
  story.perform("view.theme.light");
  handTo(story, {0.012, 0.005, 0.030});
  story.perform("session.start");
  handTo(story, {0.012, 0.005, 0.0135});
  EXPECT_GT(story.view().patchDrawn(), 6U);
  EXPECT_LT(story.imageDifference("mesh_box"), kTolerance);
  story.perform("view.theme.dark");
  EXPECT_LT(story.imageDifference("mesh_box_dark"), kTolerance);
}

TEST(MeshViewStory, ALargeWindowShowsItToo) {
  Story story("", {.size = {1920, 1080}});
  openMesh(story, seenBallFile());
  story.perform("view.theme.dark");
  handTo(story, {0.0, 0.010, 0.045});
  story.perform("session.start");
  handTo(story, {0.0, 0.010, 0.0265});
  EXPECT_GT(story.view().patchDrawn(), 6U);
  EXPECT_FALSE(story.picture().isNull());
  EXPECT_EQ(story.view().glErrors(), 0);
}

TEST(SurfaceStory, FrictionIsSwitchedTunedAndTakenBackStepByStep) {
  Story story("04_plane");
  const auto friction = [&story] { return story.host().scene().constraints[0].friction; };
  auto* on = story.find<QCheckBox>("panel.surface.friction");
  ASSERT_TRUE(on->isVisibleTo(story.find("panel.feel")));
  EXPECT_FALSE(story.find("panel.surface.static.slider")->isVisibleTo(story.find("panel.feel")));
  on->click();
  ASSERT_TRUE(friction().has_value());
  const scene::Friction first = *friction();
  auto* slider = story.find<QSlider>("panel.surface.static.slider");
  slider->setFocus();
  story.key(Qt::Key_PageUp);
  EXPECT_GT(friction()->static_share, first.static_share);
  EXPECT_EQ(friction()->dynamic_share, first.dynamic_share);
  const scene::Friction second = *friction();
  story.settle(1100);  // keys within a second are one step
  slider->setFocus();
  story.key(Qt::Key_Home);  // the dynamic share goes down with it
  EXPECT_EQ(friction(), (scene::Friction{0.0, 0.0}));
  story.perform("edit.undo");
  EXPECT_EQ(friction(), second);
  story.perform("edit.undo");
  EXPECT_EQ(friction(), first);
  story.perform("edit.undo");
  EXPECT_FALSE(friction().has_value());
  EXPECT_TRUE(story.perform("friction.set", 0.2, 0.1));
  EXPECT_EQ(friction(), (scene::Friction{0.2, 0.1}));
  EXPECT_FALSE(story.perform("friction.set", 0.1, 0.2));  // the dynamic share is the larger one
}

TEST(SurfaceStory, APointHasNoSurfaceAndOnlyAMeshIsSought) {
  Story story("01_point");
  EXPECT_FALSE(story.find("panel.surface")->isVisibleTo(story.find("panel.feel")));
  EXPECT_FALSE(story.perform("search.set", "local"));
  drop(story, seenBallFile());
  ASSERT_TRUE(waitForMeshes(story));
  story.find<QComboBox>("dialog.mesh.side")->setCurrentIndex(2);
  story.find<QPushButton>("dialog.mesh.new")->click();
  story.settle();
  auto* search = story.find<QComboBox>("panel.surface.search");
  ASSERT_TRUE(search->isVisibleTo(story.find("panel.feel")));
  search->setCurrentIndex(2);
  EXPECT_EQ(meshOf(story).search, mesh::Search::Local);
  EXPECT_NE(meshOf(story).surface, nullptr);
  story.perform("edit.undo");
  EXPECT_EQ(meshOf(story).search, mesh::Search::Hybrid);
}

TEST(SurfaceStory, ABallOfFacesIsSmoothedAndPutBack) {
  Story story("04_plane");
  EXPECT_FALSE(story.find("panel.surface.smooth")->isVisibleTo(story.find("panel.feel")));
  EXPECT_FALSE(story.perform("smooth.set", 10.0));  // no mesh
  openMesh(story, seenBallFile());
  auto* slider = story.find<QSlider>("panel.surface.smooth.slider");
  ASSERT_TRUE(slider->isVisibleTo(story.find("panel.feel")));
  story.bringToFront(slider->window());
  slider->setFocus();
  for (int key = 0; key < 3; ++key) story.key(Qt::Key_PageUp);
  const double smooth_deg = meshOf(story).smooth_deg;
  EXPECT_GT(smooth_deg, 2.0);
  EXPECT_TRUE(story.perform("smooth.set", 20.0));
  EXPECT_EQ(meshOf(story).smooth_deg, 20.0);
  story.perform("edit.undo");
  EXPECT_EQ(meshOf(story).smooth_deg, smooth_deg);
  EXPECT_FALSE(story.perform("smooth.set", 50.0));  // refused, and the old one holds
  EXPECT_EQ(meshOf(story).smooth_deg, smooth_deg);
  EXPECT_TRUE(story.perform("gains.reset"));
  EXPECT_EQ(meshOf(story).smooth_deg, 0.0);
}

}  // namespace underact::gui::test
