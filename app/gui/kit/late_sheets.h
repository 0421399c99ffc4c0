#pragma once
#include <QObject>
#include <QString>

class QWidget;

namespace underact::gui {

/// The style sheet of a window, given to its children one by one: to a dock when it is shown for the first time, to
/// the others at once. Qt keeps 8 KB or more of each widget below a sheet, seen or not, and most docks are hidden.
/// The window itself has none.
class LateSheets : public QObject {
  Q_OBJECT
 public:
  explicit LateSheets(QWidget* window);
  void set(const QString& sheet);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void give(QWidget& child);
  QWidget* window_;
  QString sheet_;
};

}  // namespace underact::gui
