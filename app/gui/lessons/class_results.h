#pragma once
#include <QDialog>

#include "core/lesson/results.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace underact::gui {

/// The table of the reports in a folder, which `underact-cli lesson results` prints, too. Not modal.
class ClassResults : public QDialog {
  Q_OBJECT
 public:
  explicit ClassResults(QWidget* parent);
  void read(const QString& folder);
  /// Writes the table, or the grades for Moodle; says what came of it.
  bool save(const QString& path, bool for_moodle);

 private:
  QWidget* buildButtons();
  void chooseFolder();
  void chooseFile(bool for_moodle);
  void fillTable();
  void sort(int column);
  void say(const QString& sentence, bool is_wrong = false);

  QString folder_;
  lesson::ClassResults results_;
  QLabel *message_, *unread_;
  QComboBox* order_;
  QTableWidget* table_;
  QPushButton *csv_ = nullptr, *moodle_ = nullptr;
};

/// Shows the dialog, which is made once. folder: read at once; empty: the user chooses one.
void showClassResults(QWidget* window, const QString& folder);

}  // namespace underact::gui
