#pragma once
#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;

namespace underact::record {
struct RecorderStatus;
}

namespace underact::gui {

class Actions;
class Readout;
class Recording;
class MetadataForm;

/// What a person has to know during a recording: ticks that were lost, and a disk that is nearly full. A line each.
QString warningOf(const record::RecorderStatus& status, bool runs);

/// The state of the recording: a button, duration, size, free disk space and markers; and the metadata saved with it.
class RecordSection : public QWidget {
  Q_OBJECT
 public:
  RecordSection(Recording& recording, Actions& actions, QWidget* parent = nullptr);
  /// The label typed for the next marker; clears the field.
  QString takeLabel();
  /// Shows the state of the recording. Until the first call every row has its widest text, so that the panel can make
  /// itself wide enough.
  void present();

 private:
  QWidget* buildMark();

  Recording& recording_;
  Actions& actions_;
  QPushButton *record_, *mark_;
  QLineEdit* label_;
  QLabel *place_, *notice_;
  Readout* readout_;
  MetadataForm* words_;
  bool was_running_ = false;
};

}  // namespace underact::gui
