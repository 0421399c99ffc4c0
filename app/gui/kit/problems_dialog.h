#pragma once
#include <QDialog>

#include "core/base/result.h"

class QLabel;
class QTableWidget;

namespace underact::gui {

/// Every problem of a scene file that was not opened, with its place. The window behind stays as it was and can be
/// used.
class ProblemsDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ProblemsDialog(QWidget* parent);
  void show(const QString& path, const Problems& problems);
  QString text() const;  // a line for each, as the command line prints them

 signals:
  void openAnother();

 private:
  Problems problems_;
  QLabel* heading_;
  QTableWidget* table_;
};

}  // namespace underact::gui
