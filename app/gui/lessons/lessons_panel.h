#pragma once
#include <QPointer>
#include <optional>
#include <vector>

#include "app/gui/feature/panel.h"
#include "app/gui/lessons/lesson_window_state.h"
#include "core/lesson/report.h"

class QMenu;
class QStackedWidget;
class QUrl;

namespace underact::gui {

class LessonList;
class LessonPage;
class LessonRun;
class ProblemsDialog;

/// The list of lessons and, once one has started, its steps.
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
  void addClassActions();
  void askForNewStudent();
  bool beginStudent(const QString& report);
  lesson::Report doneSoFar() const;
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
  void presentStage();
  QMenu* makeMenu();
  void fillMenu(QMenu& menu);
  /// Those that come with the program, in the order of their numbers; read when they are first asked for.
  const std::vector<lesson::Lesson>& shipped();

  LessonParts parts_;
  std::optional<std::vector<lesson::Lesson>> shipped_;
  RecentFiles* recent_;  // lesson files; scene files have their own list
  LessonRun* run_;
  QPointer<ProblemsDialog> problems_;  // for a lesson that could not be opened
  QStackedWidget* pages_;
  LessonList* list_ = nullptr;
  LessonPage* page_ = nullptr;
  std::string saved_;          // what the report that was saved last says of doneSoFar()
  std::vector<bool> reached_;  // of the targets in the view
  bool hides_counts_ = false, is_new_step_ = false;
};

}  // namespace underact::gui
