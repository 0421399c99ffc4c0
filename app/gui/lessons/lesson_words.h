#pragma once
#include <QString>

#include "app/gui/lessons/lesson_run.h"

namespace underact::gui {

/// "Solved: ...", "To do: ...": a check as the panel, the report and a screen reader have it.
QString checkText(const lesson::Check& check, const lesson::CheckState& state);

/// What was done in a lesson, as a page of HTML that stands by itself. name: of whoever did it, as typed; empty: none.
QString lessonReport(const LessonRun& run, const QString& name, const QDateTime& when);

}  // namespace underact::gui
