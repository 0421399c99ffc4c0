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

/// The lessons to choose from: those that come with the program, in their groups, and files opened lately; each with
/// what of it was solved.
class LessonList : public QWidget {
  Q_OBJECT
 public:
  LessonList(RecentFiles& recent, Actions& actions, QWidget* parent);
  void rebuild();
  /// Why a lesson was not begun; empty: nothing.
  void setNote(const QString& text);

 private:
  void addHeading(const QString& text);
  void addLesson(const lesson::Lesson& lesson);
  void describe();
  void open(QListWidgetItem* item);

  RecentFiles& recent_;
  Actions& actions_;
  std::vector<lesson::Lesson> shipped_;
  QListWidget* list_;
  QLabel* about_;
  QLabel* note_;
};

}  // namespace underact::gui
