#pragma once
#include <QDialog>
#include <QString>

#include "core/base/result.h"

class QLabel;
class QTableWidget;
class QWidget;

namespace underact::gui {

/// Lists every problem of a scene file that could not be opened, with its place. Not modal; the window is unchanged.
class ProblemsDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ProblemsDialog(QWidget* parent);
  void show(const QString& path, const Problems& problems);
  QString text() const;  // one line each, as printed by the command line

 signals:
  void openAnother();

 private:
  Problems problems_;
  QLabel* heading_;
  QTableWidget* table_;
};

/// A non-modal box that says what was not done and why. name: of the object. Problems of a text file are listed with
/// their lines.
void showProblemsBox(const QString& name, const QString& title, const QString& what, const Problems& problems,
                     QWidget* window);

/// Closes all that says what is wrong with a file: the next one is being opened.
void closeProblems();

}  // namespace underact::gui
