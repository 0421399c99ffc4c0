#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QMenu>

#include "app/gui/lessons/lesson_library.h"
#include "app/gui/window/features.h"
#include "core/lesson/window_names.h"
#include "tests/stories/lesson_steps.h"

namespace underact::gui::test {

TEST(LessonStageStory, FromWhereAnotherLessonEndsAStepBeginsTheSame) {
  Story story("02_sphere");
  const auto begun = [&story](const char* lesson, int steps) {
    EXPECT_TRUE(story.perform("lesson.start", lesson));
    for (int step = 0; step < steps; ++step) EXPECT_TRUE(story.perform("lesson.next"));
    story.run(200);
    story.settle(300);  // the camera arrives
    const Vec3 p_mm = 1e3 * story.snapshot().report.p_WT;
    const OrbitCamera camera = story.view().viewpoint().camera;
    return QString("%1 at %2 %3 %4 from %5 %6")
        .arg(QString::fromStdString(shapeOf(story)))
        .arg(p_mm.x(), 0, 'f', 0)
        .arg(p_mm.y(), 0, 'f', 0)
        .arg(p_mm.z(), 0, 'f', 0)
        .arg(camera.azimuth_rad, 0, 'f', 2)
        .arg(camera.elevation_rad, 0, 'f', 2);
  };
  const std::vector<std::pair<const char*, int>> seen{
      {"01_frames", 0}, {"02_dh", 1}, {"04_inverse", 2}, {"07_stiffness", 3}};
  std::vector<QString> fresh;
  for (const auto& [lesson, steps] : seen) {
    story.perform("lesson.leave");
    fresh.push_back(begun(lesson, steps));
  }
  for (const lesson::Lesson& before : shippedLessons()) {
    for (std::size_t index = 0; index < seen.size(); ++index) {
      const auto& [lesson, steps] = seen[index];
      ASSERT_TRUE(story.perform("lesson.start", QString::fromStdString(before.file)));
      for (std::size_t step = 1; step < before.steps.size(); ++step) ASSERT_TRUE(story.perform("lesson.next"));
      leadHand(story, {20, 30, 20});
      story.perform("joint.set", 4, 60);
      story.run(500);
      story.perform("layer.wires", true);
      story.perform("view.back");
      EXPECT_EQ(begun(lesson, steps), fresh[index]) << before.title << " before " << lesson;
      EXPECT_FALSE(stepTitle(story).contains("✓")) << before.title << " before " << lesson;
    }
  }
}

TEST(LessonStageStory, TargetsAreInTheViewAndTheNumberThatIsAskedForIsNotBesideTheQuestion) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("lesson.start", "01_frames"));
  story.run(100);
  EXPECT_EQ(story.view().targetsInDrawings(), 3U);
  ASSERT_TRUE(story.perform("lesson.start", "04_inverse"));
  story.run(100);
  EXPECT_EQ(story.view().targetsInDrawings(), 0U);
  const QWidget* const counts = story.find("panel.kinematics.solutions.status");
  EXPECT_TRUE(counts->isHidden());
  ASSERT_TRUE(story.perform("lesson.answer", 1, 8));
  story.run(100);
  EXPECT_FALSE(counts->isHidden());
  ASSERT_TRUE(story.perform("lesson.next"));
  story.run(100);
  EXPECT_TRUE(counts->isHidden()) << "it asks how many are within the limits";
  story.perform("lesson.leave");
  story.run(100);
  EXPECT_FALSE(counts->isHidden());
  EXPECT_EQ(story.view().targetsInDrawings(), 0U);
}

TEST(LessonStageStory, ACompleteLessonSaysSoAndBeginsTheNext) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("lesson.start", "13_null_space"));
  EXPECT_FALSE(story.perform("lesson.after")) << "it is the last";
  ASSERT_TRUE(story.perform("lesson.start", "12_solutions"));
  story.run(100);
  ASSERT_TRUE(story.perform("lesson.answer", 1, 8));
  story.run(20);
  EXPECT_FALSE(story.find("panel.lessons.complete")->isVisible());
  EXPECT_TRUE(story.find("panel.lessons.complete.step")->isVisible());
  ASSERT_TRUE(story.perform("lesson.next"));
  story.run(100);
  ASSERT_TRUE(story.perform("lesson.answer", 1, 2));
  ASSERT_TRUE(story.perform("lesson.next"));
  story.run(100);
  ASSERT_TRUE(story.perform("lesson.answer", 1, 2));
  story.run(100);
  story.settle(100);
  EXPECT_EQ(story.find<QLabel>("panel.lessons.complete")->text(), QString::fromUtf8("✓ Lesson complete"));
  auto* const next = story.find<QAbstractButton>("panel.lessons.complete.next");
  ASSERT_TRUE(next->isVisible());
  next->click();
  story.settle(100);
  EXPECT_EQ(stepTitle(story), "Count");
}

TEST(LessonStageStory, TheRailAndTheMenuLeadToTheLessons) {
  Story story("02_sphere");
  story.perform("purpose.teach");
  story.settle();
  story.perform("dock.lessons", false);
  story.click(story.find("rail.lessons"));
  story.settle();
  EXPECT_TRUE(story.find("panel.lessons.list")->isVisible());
  auto* const menu = story.window().findChild<QMenu*>("menu.lessons.all");
  ASSERT_NE(menu, nullptr);
  emit menu->aboutToShow();  // as when it is opened: the lessons are read then
  ASSERT_EQ(menu->actions().size(), 13);
  menu->actions().at(1)->trigger();
  story.settle();
  EXPECT_EQ(stepTitle(story), "Four numbers per joint");
}

TEST(LessonStageStory, TheNamesThatALessonMayUseAreTheWindowsOwn) {
  Story story("02_sphere");
  QStringList own, known;
  for (const PanelRow& row : panelsOf(features())) own << row.key;
  for (const char* name : lesson::panelNames()) known << name;
  own.sort(), known.sort();
  EXPECT_EQ(own, known);
  for (const char* name : lesson::cameraNames()) {
    EXPECT_NE(story.window().actions().find(QString("view.%1").arg(name)), nullptr) << name;
  }
  own.clear(), known.clear();
  for (const QString& action : story.window().actions().names()) {
    if (action.startsWith("layer.")) own << action.mid(6);
  }
  for (const char* name : lesson::layerNames()) known << name;
  own.sort(), known.sort();
  EXPECT_EQ(own, known);
}

}  // namespace underact::gui::test
