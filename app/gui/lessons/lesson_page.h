#pragma once
#include <QWidget>
#include <vector>

class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace underact::gui {

class Actions;
class CheckRow;
class LessonRun;
class PageView;

/// The current step of a lesson: what to read, what to do, the progress, and the buttons.
class LessonPage : public QWidget {
  Q_OBJECT
 public:
  LessonPage(LessonRun& run, Actions& actions, QWidget* parent);

  /// Shows another step.
  void showStep();
  /// Updates the checks.
  void present();
  /// Shows the step's hint below its text. false: it has none, or it is shown already.
  bool showHint();
  bool hasHint() const;
  /// The name typed for the report.
  QString typedName() const;
  void setNote(const QString& text);
  PageView& text() { return *text_; }

 private:
  QWidget* makeChecks();
  void addButtons(QVBoxLayout* column, Actions& actions);
  void showText();
  void showHead();
  QString asksForStart() const;

  LessonRun& run_;
  QLabel* lesson_;
  QLabel* title_;
  PageView* text_;
  QWidget* checks_;
  QLabel* servo_;
  QLineEdit* name_;
  QLabel* note_;
  std::vector<CheckRow*> rows_;
  bool hinted_ = false;
};

}  // namespace underact::gui
