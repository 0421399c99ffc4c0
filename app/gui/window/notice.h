#pragma once
#include <QFrame>
#include <QTimer>

class QLabel;
class QPushButton;

namespace underact::gui {

class Actions;
class SceneView;

/// A short notice at the foot of the view: what was saved, with a button that shows it. It leaves by itself, but not
/// while the pointer or the keyboard focus is on it. Features tell it by the command notice.tell: the sentence, and the
/// file or folder to show.
class Notice : public QFrame {
  Q_OBJECT
 public:
  Notice(SceneView& view, Actions& actions);
  void tell(const QString& sentence, const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  void reveal();
  void chooseSession(int tries);
  void leave();

  SceneView& view_;
  Actions& actions_;
  QLabel* sentence_;
  QPushButton* show_;
  QString path_;
  QTimer leaves_;
};

}  // namespace underact::gui
