#include "app/gui/feature/feature.h"

#include <QCoreApplication>

#include "app/gui/lessons/lessons_panel.h"

namespace underact::gui {

FeatureRow lessonsFeature() {
  return {
      .panels =
          {{"lessons", QT_TRANSLATE_NOOP("panel", "Lessons"), Qt::LeftDockWidgetArea,
            QT_TRANSLATE_NOOP("panel", "Exercises in robot kinematics and forces that check what your hand does."),
            [](const FeatureParts& all, QWidget* parent) -> Panel* {
              return new LessonsPanel({all.document, all.actions, all.view, all.player, all.servo, all.hand}, parent);
            },
            "scenes", "Ctrl+L"}},
      .pages = {{"panel.lessons", "lessons"},
                {"dialog.open_lesson", "lessons"},
                {"dialog.save_lesson_report", "lessons#the-report"}},
      .opens = FileKind::Lesson,
      .open_action = "lesson.open"};
}

}  // namespace underact::gui
