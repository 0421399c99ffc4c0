#pragma once
#include <QFrame>

class QLabel;
class QPushButton;

namespace underact::gui {

class Actions;
class LessonRun;

/// Under the last question: the lesson is complete, and what comes next; or which steps are still open.
class LessonComplete : public QFrame {
  Q_OBJECT
 public:
  LessonComplete(Actions& actions, QWidget* parent);
  void present(const LessonRun& run);

 private:
  Actions& actions_;
  QLabel *title_, *text_;
  QPushButton *next_, *step_;
};

}  // namespace underact::gui
