#pragma once
#include <QDialog>
#include <QString>

#include "core/base/result.h"

class QLabel;
class QTableWidget;
class QWidget;

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

/// A box that says what was not done, and why; nothing keeps anybody from the arm meanwhile. name: of the object.
/// Problems of a file that is read line by line stand with their lines.
void showProblemsBox(const QString& name, const QString& title, const QString& what, const Problems& problems,
                     QWidget* window);

}  // namespace underact::gui
