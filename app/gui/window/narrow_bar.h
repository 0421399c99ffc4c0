#pragma once
#include <QObject>
#include <QStringList>

class QToolBar;

namespace underact::gui {

/// Where a tool bar is too narrow for all of its buttons with their words, these lose theirs, one after another, until
/// all fit: none is pushed out of the window.
class NarrowBar : public QObject {
 public:
  /// buttons: object names, the first loses its words first.
  NarrowBar(QToolBar* bar, QStringList buttons);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();

  QToolBar* bar_;
  QStringList buttons_;
};

}  // namespace underact::gui
