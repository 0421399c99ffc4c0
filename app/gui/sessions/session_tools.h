#pragma once
#include <QWidget>

class QMenu;
class QPushButton;

namespace underact::gui {

class Actions;
class JobStrip;
class SessionList;

/// The commands for the selected session: actions, a row of buttons for the most frequent ones, and a menu of all.
class SessionTools : public QWidget {
  Q_OBJECT
 public:
  SessionTools(Actions& actions, SessionList& list, JobStrip& job, QWidget* parent);
  QMenu* menu() { return menu_; }

 private:
  using Begin = bool (JobStrip::*)(const QString& session, const QString& out);
  void addActions();
  void buildMenu();
  void buildButtons();
  void presentChosen();
  bool write(const QString& path, Begin begin);
  void chooseFile(const QString& title, const QString& suffix, const QString& action);
  bool edit();
  bool recover();
  bool moveToBin(bool asked);
  bool remove(bool asked);
  bool tellGone(bool is_gone, const QString& gone, const QString& refusal);

  Actions& actions_;
  SessionList& list_;
  JobStrip& job_;
  QMenu* menu_ = nullptr;
  QPushButton *replay_ = nullptr, *export_ = nullptr, *recover_ = nullptr;
};

}  // namespace underact::gui
