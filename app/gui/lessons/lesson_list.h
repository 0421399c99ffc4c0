#pragma once
#include <QWidget>
#include <vector>

#include "core/lesson/lesson.h"

class QLabel;
class QListWidget;
class QListWidgetItem;

namespace underact::gui {

class Actions;
class RecentFiles;

/// The lessons to choose from: those that come with the program, in their groups, and recently opened files; each with
/// its progress.
class LessonList : public QWidget {
  Q_OBJECT
 public:
  /// `shipped`: those that come with the program.
  LessonList(const std::vector<lesson::Lesson>& shipped, RecentFiles& recent, Actions& actions, QWidget* parent);
  void rebuild();
  /// Shows why a lesson did not start; empty: nothing.
  void setNote(const QString& text);

 private:
  void addHeading(const QString& text);
  void addLesson(const lesson::Lesson& lesson, int number);  // 0: it has none
  void describe();
  void open(QListWidgetItem* item);

  RecentFiles& recent_;
  Actions& actions_;
  const std::vector<lesson::Lesson>& shipped_;
  QListWidget* list_;
  QLabel* about_;
  QLabel* note_;
};

}  // namespace underact::gui
