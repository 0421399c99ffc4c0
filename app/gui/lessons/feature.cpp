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
                {"dialog.save_lesson_report", "lessons#the-report"},
                {"dialog.lesson_print", "classes#on-paper"},
                {"dialog.lesson_pdf", "classes#on-paper"},
                {"dialog.lesson_pdf_problems", "classes#on-paper"},
                {"dialog.new_student", "classes#one-computer-several-students"},
                {"dialog.class_results", "classes#results-of-a-class"},
                {"dialog.class_results_save", "classes#results-of-a-class"},
                {"dialog.class_results_folder", "classes#results-of-a-class"}},
      .opens = FileKind::Lesson,
      .open_action = "lesson.open"};
}

}  // namespace underact::gui
