#pragma once
#include <QByteArray>
#include <QFrame>
#include <QMainWindow>

#include "app/gui/feature/feature.h"
#include "app/gui/kit/stop_key.h"
#include "app/gui/kit/theme.h"

class QLabel;
class QPushButton;

namespace underact::gui {

class Spotlight;

/// A tour of the window: at each stop a frame marks a part of the window, and a card explains it. Enter continues; Esc
/// and Close leave the tour at any stop and restore the panels.
class Tour : public QFrame, public ServoListener, public LeftByEsc {
  Q_OBJECT
 public:
  Tour(SceneView& view, Actions& actions, QMainWindow* window);
  void present(const servo::Snapshot&) override { follow(); }  // the target may move
  void end();
  void setTheme(const Theme& theme) override;
  bool isOpen() const override { return stop_ >= 0; }
  void leaveByEsc() override { end(); }
  int stop() const { return stop_; }  // from 0; -1: no tour
  static int stops();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void follow();
  void build();
  void begin();
  void go(int stop);
  QRect where() const;
  void place(const QRect& target);

  QMainWindow* window_;
  SceneView& view_;
  Actions& actions_;
  Spotlight* spotlight_;
  QLabel *title_, *text_, *count_;
  QPushButton *back_, *next_;
  QByteArray layout_;  // from before the tour
  int stop_ = -1;
  bool is_placed_ = false;  // for this stop
};

}  // namespace underact::gui
