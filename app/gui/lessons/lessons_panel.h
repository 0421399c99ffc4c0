#pragma once
#include <QPointer>

#include "app/gui/feature/panel.h"
#include "app/gui/lessons/lesson_place.h"

class QStackedWidget;
class QUrl;

namespace underact::gui {

class LessonList;
class LessonPage;
class LessonRun;
class ProblemsDialog;

/// Lessons to choose from and, once one is begun, its steps.
class LessonsPanel : public Panel {
  Q_OBJECT
 public:
  LessonsPanel(const LessonParts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;
  void leave() override;
  void add(const servo::TickRecord& tick) override;

 private:
  void addActions();
  void addStepActions();
  bool start(const QString& path);
  bool step(int by);
  bool saveReport(const QString& path);
  void showProblems(const QString& path, const Problems& problems);
  void chooseLesson();
  void chooseReport();
  void showState();
  void enableActions();
  void follow(const QUrl& link);
  void saySolved();

  LessonParts parts_;
  RecentFiles* recent_;  // lesson files; those of scenes are another list
  LessonRun* run_;
  QPointer<ProblemsDialog> problems_;  // of a lesson that was not opened
  QStackedWidget* pages_;
  LessonList* list_ = nullptr;
  LessonPage* page_ = nullptr;
};

}  // namespace underact::gui
