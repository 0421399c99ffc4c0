#pragma once
#include <QWidget>

class QLabel;

namespace underact::gui {

class Actions;

/// The fixed foot of the Feel panel, below the part that scrolls: a warning, why a change was refused, and the buttons.
/// Here a message is always visible, and its appearance does not move a slider away from under the pointer.
class FeelFoot : public QWidget {
  Q_OBJECT
 public:
  FeelFoot(Actions& actions, QWidget* parent);
  // Empty: hides the message.
  void warn(const QString& sentence);
  void refuse(const QString& sentences);

 private:
  QLabel *warning_, *refusal_;
};

}  // namespace underact::gui
