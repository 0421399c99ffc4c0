#pragma once
#include <QByteArray>
#include <QFrame>
#include <QMainWindow>

#include "app/gui/feature/feature.h"
#include "app/gui/kit/theme.h"

class QLabel;
class QPushButton;

namespace underact::gui {

class Spotlight;

/// A walk through the window: at each stop a frame around what is meant, and a card that says what it is for. Enter
/// goes on, Esc (which stops the servo, as always) and Close leave it, at any stop; the panels are then as they were.
class Tour : public QFrame, public Follower {
  Q_OBJECT
 public:
  explicit Tour(const FeatureParts& parts);
  void present(const servo::Snapshot&) override { follow(); }  // what is framed may move
  void end();
  void setTheme(const Theme& theme) override;
  int stop() const { return stop_; }  // from 0; -1: nobody is on a tour
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
  QByteArray layout_;  // before it began
  int stop_ = -1;
  bool is_placed_ = false;  // for this stop
};

}  // namespace underact::gui
