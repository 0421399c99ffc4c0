#pragma once
#include "app/gui/feature/panel.h"

class QMenu;
class QPushButton;

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
  ~SessionsPanel() override;
  void add(const servo::TickRecord& record) override;
  QString whyBusy() const override;
  /// What is being recorded ends, and work on sessions is given up.
  void finish() override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addRecordActions();
  void addListActions();
  QWidget* buildButtons();
  void press(ButtonUse use);
  void presentRecording();
  void presentChosen();
  bool exportCsvTo(const QString& path);
  bool plotTo(const QString& path);
  bool recoverChosen();
  bool editChosen();
  bool deleteChosen(bool asked);
  bool removeChosen(bool asked);
  void chooseFile(const QString& title, const QString& suffix, const QString& action);
  void chooseFolder();
  bool setFolder(const QString& folder);

  Parts parts_;
  Recording* recording_;
  RecordSection* record_ = nullptr;
  ButtonsSection* buttons_ = nullptr;
  SessionList* list_ = nullptr;
  JobStrip* job_ = nullptr;
  QPushButton *replay_ = nullptr, *export_ = nullptr, *recover_ = nullptr, *more_ = nullptr;
  QMenu* menu_ = nullptr;
  bool seen_ = false;  // the folder is read when somebody looks
  bool was_running_ = false;
};

}  // namespace underact::gui
