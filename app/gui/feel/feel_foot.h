#pragma once
#include <QWidget>

class QLabel;

namespace underact::gui {

class Actions;

/// Below what scrolls in the Feel panel, so that a sentence is always seen and its coming moves no slider from under
/// the pointer: a warning, why a change was refused, and what can be done with all of it.
class FeelFoot : public QWidget {
  Q_OBJECT
 public:
  FeelFoot(Actions& actions, QWidget* parent);
  // Empty: there is none.
  void warn(const QString& sentence);
  void refuse(const QString& sentences);

 private:
  QLabel *warning_, *refusal_;
};

}  // namespace underact::gui
