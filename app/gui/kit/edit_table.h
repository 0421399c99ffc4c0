#pragma once
#include <QTableWidget>

namespace underact::gui {

/// A table of numbers that are typed. It never changes by itself: what was typed is emitted, and whoever owns the
/// numbers fills in what they became, so that a refused one is back at once.
class EditTable : public QTableWidget {
  Q_OBJECT
 public:
  EditTable(const QString& object_name, const QString& name, QWidget* parent = nullptr);

  struct Cell {
    QString shown;
    QString exact;   // what an editor starts from
    QString spoken;  // for screen readers: what the number is
    QString tip;
    QStringList choices = {};  // typed by choosing; empty: a number
    bool editable = true;
  };
  void setCell(int row, int column, const Cell& cell);
  void setColumnHead(int column, const QString& head, const QString& tip, const QString& widest);
  /// As high as its rows are, so that nothing scrolls but what is too wide.
  void fitHeight();

 signals:
  void typed(int row, int column, const QString& text);

 protected:
  bool event(QEvent* event) override;
};

}  // namespace underact::gui
