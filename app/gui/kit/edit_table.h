#pragma once
#include <QTableWidget>

namespace underact::gui {

/// A table of numbers to edit. It never changes by itself: it emits what was typed, and the owner of the numbers fills
/// in the result, so that a refused entry is reset at once.
class EditTable : public QTableWidget {
  Q_OBJECT
 public:
  EditTable(const QString& object_name, const QString& name, QWidget* parent = nullptr);

  struct Cell {
    QString shown;
    QString exact;   // what an editor starts from
    QString spoken;  // for screen readers: what the number means
    QString tip;
    QStringList choices = {};  // to choose from; empty: a number
    bool editable = true;
  };
  void setCell(int row, int column, const Cell& cell);
  void setColumnHead(int column, const QString& head, const QString& tip, const QString& widest);
  /// As tall as its rows, so that it scrolls only sideways.
  void fitHeight();

 signals:
  void typed(int row, int column, const QString& text);

 protected:
  bool event(QEvent* event) override;
};

}  // namespace underact::gui
