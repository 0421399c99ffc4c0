#pragma once
#include <QByteArray>
#include <QFrame>
#include <QMainWindow>

#include "app/gui/theme.h"

class QLabel;
class QPushButton;

namespace underact::gui {

class Actions;
class SceneView;
class Spotlight;

/// A walk through the window: at each stop a frame around what is meant, and a card that says what it is for. Enter
/// goes on, Esc (which stops the servo, as always) and Close leave it, at any stop; the panels are then as they were.
class Tour : public QFrame {
  Q_OBJECT
 public:
  Tour(QMainWindow* window, SceneView& view, Actions& actions);
  /// Each frame: what is framed may move.
  void follow();
  void leave();
  void setTheme(const Theme& theme);
  int stop() const { return stop_; }  // from 0; -1: nobody is on a tour
  static int stops();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
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
  QByteArray layout_;  // before it began
  int stop_ = -1;
  bool is_placed_ = false;  // for this stop
};

}  // namespace underact::gui
