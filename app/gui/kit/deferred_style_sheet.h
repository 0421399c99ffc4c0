#pragma once
#include <QObject>
#include <QString>

class QWidget;

namespace underact::gui {

/// The style sheet of a window, set on its children one by one: on a dock when it is first shown, on the others at
/// once. Qt needs 8 KB or more for each widget below a sheet, visible or not, and most docks are hidden. The window
/// itself has none.
class DeferredStyleSheet : public QObject {
  Q_OBJECT
 public:
  explicit DeferredStyleSheet(QWidget* window);
  void set(const QString& sheet);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void give(QWidget& child);
  QWidget* window_;
  QString sheet_;
};

}  // namespace underact::gui
