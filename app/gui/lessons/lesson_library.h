#pragma once
#include <QSet>
#include <QString>
#include <vector>

#include "core/lesson/lesson.h"

namespace underact::gui {

/// The folder of the lessons that come with the program, as shippedFolder().
QString lessonFolder();

/// The lessons of that folder that can be read, by their order.
std::vector<lesson::Lesson> shippedLessons();

/// Whether a file is meant as a lesson, right or wrong.
bool isLessonFile(const QString& path);

/// The path of a lesson: a file as it stands, or the one of that name that ships.
QString lessonPath(const QString& name);

/// Which steps of a lesson (from 0) were solved, now or on another day; kept in the user's settings.
QSet<std::size_t> solvedSteps(const QString& path);
void rememberSolved(const QString& path, std::size_t step);

}  // namespace underact::gui
