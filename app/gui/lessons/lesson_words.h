#pragma once
#include <QString>

#include "app/gui/lessons/lesson_run.h"

namespace underact::gui {

/// "Solved: ...", "Not yet: ...": a check as shown in the panel and the report, and read by a screen reader.
QString checkText(const lesson::Check& check, const lesson::CheckState& state);

/// The results of a lesson as a self-contained HTML page. name: of the person, as typed; empty: none.
QString lessonReport(const LessonRun& run, const QString& name, const QDateTime& when);

/// The proposed name of the report's file.
QString reportFileName(const LessonRun& run, const QString& name);

/// All steps with their questions as a page for paper, without what solves them.
QString lessonMarkdown(const lesson::Lesson& lesson);

}  // namespace underact::gui
