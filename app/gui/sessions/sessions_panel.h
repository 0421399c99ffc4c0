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

/// Recording, and what was recorded: begin and end, marks, words; find a session, export it, make it whole.
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
  QString whyBusy() const override;
  /// What is being recorded ends, and work on sessions is given up.
  void finish() override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addRecordActions();
  QAction* addFolderAction();
  void press(ButtonUse use);
  void presentRecording();
  void chooseFolder();
  bool setFolder(const QString& folder);

  Parts parts_;
  Recording* recording_;
  RecordSection* record_ = nullptr;
  ButtonsSection* buttons_ = nullptr;
  SessionList* list_ = nullptr;
  JobStrip* job_ = nullptr;
  bool seen_ = false;  // the folder is read when somebody looks
  bool was_running_ = false;
};

}  // namespace underact::gui
