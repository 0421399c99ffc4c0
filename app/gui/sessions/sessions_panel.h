#pragma once
#include "app/gui/feature/panel.h"

class QAction;

namespace underact::gui {

class ButtonsSection;
class JobStrip;
class Recording;
class RecordSection;
class SessionList;
enum class ButtonUse;

/// Recording and recorded sessions: start and stop, markers, metadata; find, export and recover sessions.
class SessionsPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    Actions& actions;
    StatusLine& status;
    Recording& recording;
  };
  SessionsPanel(const Parts& parts, QWidget* parent);
  void add(const servo::TickRecord& record) override;
  QString busyReason() const override;
  /// Ends the recording and cancels jobs on sessions.
  void finish() override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addRecordActions();
  QAction* addFolderAction();
  void press(ButtonUse use);
  void tellUnfinished();
  void presentRecording();
  void chooseFolder();
  bool setFolder(const QString& folder);

  Parts parts_;
  Recording* recording_;
  RecordSection* record_ = nullptr;
  ButtonsSection* buttons_ = nullptr;
  SessionList* list_ = nullptr;
  JobStrip* job_ = nullptr;
  bool seen_ = false;  // the folder is read when the panel is first shown
  bool was_running_ = false;
};

}  // namespace underact::gui
