#pragma once
#include <QString>

#include "app/gui/lessons/lesson_run.h"

namespace underact::gui {

/// "Solved: ...", "Not yet: ...": a check as shown in the panel and the report, and read by a screen reader.
QString checkText(const lesson::Check& check, const lesson::CheckState& state);

/// The results of a lesson as a self-contained HTML page. name: of the person, as typed; empty: none.
QString lessonReport(const LessonRun& run, const QString& name, const QDateTime& when);

}  // namespace underact::gui
