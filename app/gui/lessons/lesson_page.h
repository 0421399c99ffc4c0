#pragma once
#include <QWidget>
#include <vector>

class QLabel;
class QLineEdit;
class QScrollArea;
class QVBoxLayout;

namespace underact::gui {

class Actions;
class CheckRow;
class LessonComplete;
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
  void clearName();
  void setNote(const QString& text);
  PageView& text() { return *text_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void shareRoom();
  QWidget* makeContent();
  QWidget* makeChecks();
  void addButtons(QVBoxLayout* column, Actions& actions);
  void showText();
  void showHead();
  QString asksForStart() const;

  LessonRun& run_;
  Actions& actions_;
  QLabel* lesson_;
  QLabel* title_;
  PageView* text_;
  QWidget* checks_;
  QScrollArea* scroll_ = nullptr;  // text, checks and what comes next
  LessonComplete* complete_ = nullptr;
  QLabel* servo_;
  QLineEdit* name_;
  QLabel* note_;
  std::vector<CheckRow*> rows_;
  bool hinted_ = false;
  int frame_ = 0;
};

}  // namespace underact::gui
