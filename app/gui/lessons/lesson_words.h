#pragma once
#include <QString>

#include "app/gui/lessons/lesson_run.h"
#include "core/lesson/tell.h"

namespace underact::gui {

/// Sentences in the program's language, numbers as the user's system writes them.
lesson::Speech lessonSpeech();

/// "Solved: ...", "To do: ...": a check as the panel, the report and a screen reader have it.
QString checkText(const lesson::Check& check, const lesson::CheckState& state, const lesson::Speech& speech);

/// What was done in a lesson, as a page of HTML that stands by itself. name: of whoever did it, as typed; empty: none.
QString lessonReport(const LessonRun& run, const QString& name, const QDateTime& when);

}  // namespace underact::gui
