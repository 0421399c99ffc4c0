#pragma once
#include <QLabel>
#include <QString>
#include <QWidget>
#include <vector>

class QGridLayout;

namespace underact::gui {

/// Rows and columns of numbers that change without moving: every cell is as wide as the widest number of its column, so
/// a new number does not change the layout.
class NumberTable : public QWidget {
  Q_OBJECT
 public:
  struct Column {
    QString head;
    QString widest;      // "−360.0"
    bool words = false;  // left-aligned text
  };
  NumberTable(const QString& object_name, std::vector<Column> columns, QWidget* parent = nullptr);
  /// Adds a row; its cells are named OBJECT_NAME.ROW.COLUMN, from 1.
  void addRow(const QString& head, const QString& tip = {});
  /// row, column: from 0.
  void set(int row, int column, const QString& text);
  QString text(int row, int column) const;
  /// The first rows and columns only; the others are hidden.
  void showOnly(int rows, int columns);

 private:
  QGridLayout* grid_;
  std::vector<Column> columns_;
  std::vector<QLabel*> heads_, lefts_;
  std::vector<std::vector<QLabel*>> cells_;
};

/// A label in the quiet style that wraps.
QLabel* quietLabel(const QString& object_name, const QString& text, QWidget* parent);

}  // namespace underact::gui
