#pragma once
#include <QLabel>
#include <QString>
#include <QWidget>
#include <vector>

class QGridLayout;

namespace underact::gui {

/// Rows and columns of numbers that change without moving anything: every cell is as wide as the widest number that its
/// column can show, so a new number lays nothing out anew.
class NumberTable : public QWidget {
  Q_OBJECT
 public:
  struct Column {
    QString head;
    QString widest;      // "−360.0"
    bool words = false;  // to the left
  };
  NumberTable(const QString& object_name, std::vector<Column> columns, QWidget* parent = nullptr);
  /// A new row; its cells are called OBJECT_NAME.ROW.COLUMN, from 1.
  void addRow(const QString& head, const QString& tip = {});
  /// row, column: from 0.
  void set(int row, int column, const QString& text);
  QString text(int row, int column) const;

 private:
  QGridLayout* grid_;
  std::vector<Column> columns_;
  std::vector<std::vector<QLabel*>> cells_;
};

/// A label in the panel's quiet voice that wraps.
QLabel* quietLabel(const QString& object_name, const QString& text, QWidget* parent);

}  // namespace underact::gui
