#pragma once
#include <QFrame>

class QLabel;
class QPushButton;

namespace underact::gui {

/// Below the view, in large type: what a visitor feels, what to try, and two buttons.
class TitleCard : public QFrame {
  Q_OBJECT
 public:
  explicit TitleCard(QWidget* parent);
  void setScene(const QString& title, const QString& feel, const QString& try_this);
  /// can_start: the force is off; trouble: why, in a sentence, or empty.
  void setState(bool can_start, const QString& trouble);
  /// Whether it says how to leave visitor mode: only at first, while the demonstrator is there.
  void showWayOut(bool on);
  /// The font scales with the height of the screen.
  void fitInto(int height_px);

 signals:
  void nextAsked();
  void startAsked();

 private:
  QLabel *title_, *feel_, *try_, *trouble_, *leaving_;
  QPushButton *next_, *start_;
};

}  // namespace underact::gui
