#pragma once
#include <QWidget>
#include <functional>
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
  /// Gives those that come with the program: reads them, the first time.
  using Shipped = std::function<const std::vector<lesson::Lesson>&()>;
  LessonList(Shipped shipped, RecentFiles& recent, Actions& actions, QWidget* parent);
  /// At once if it is seen, else when it is shown.
  void rebuild();
  /// Shows why a lesson did not start; empty: nothing.
  void setNote(const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addHeading(const QString& text);
  void addLesson(const lesson::Lesson& lesson, int number);  // 0: it has none
  void describe();
  void open(QListWidgetItem* item);

  RecentFiles& recent_;
  Actions& actions_;
  Shipped shipped_;
  bool is_stale_ = true;
  QListWidget* list_;
  QLabel* about_;
  QLabel* note_;
};

}  // namespace underact::gui
