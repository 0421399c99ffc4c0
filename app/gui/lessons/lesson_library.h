#pragma once
#include <QSet>
#include <QString>
#include <vector>

#include "core/lesson/lesson.h"

namespace underact::gui {

/// The folder of the lessons that come with the program, as shippedFolder().
QString lessonFolder();

/// The lessons of that folder that can be read, sorted by `order`.
std::vector<lesson::Lesson> shippedLessons();

/// The one after that of that path; null: it is the last, or not among them.
const lesson::Lesson* lessonAfter(const std::vector<lesson::Lesson>& lessons, const QString& path);

/// The path of a lesson: the file itself, or the shipped lesson of that name.
QString lessonPath(const QString& name);

/// Which steps of a lesson (from 0) were solved, now or earlier; kept in the user's settings.
QSet<std::size_t> solvedSteps(const QString& path);
void rememberSolved(const QString& path, std::size_t step);
/// For the next student: no step of any lesson was solved.
void forgetSolved();

}  // namespace underact::gui
