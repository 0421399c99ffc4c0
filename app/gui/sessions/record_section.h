#pragma once
#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;

namespace underact::gui {

class Actions;
class Readout;
class Recording;
class WordsForm;

/// The recording as it goes: one button, how long and how large it is, how much the disk still takes, marks; and the
/// words that go into it.
class RecordSection : public QWidget {
  Q_OBJECT
 public:
  RecordSection(Recording& recording, Actions& actions, QWidget* parent = nullptr);
  /// What is typed for the next mark; taken away by this.
  QString takeLabel();
  /// Shows how the recording is. Until it is called the first time everything stands there at its widest, for a panel
  /// that makes itself wide enough.
  void present();

 private:
  QWidget* buildMark();

  Recording& recording_;
  Actions& actions_;
  QPushButton *record_, *mark_;
  QLineEdit* label_;
  QLabel *place_, *notice_;
  Readout* readout_;
  WordsForm* words_;
  bool was_running_ = false;
};

}  // namespace underact::gui
