#pragma once
#include <QString>
#include <QWidget>
#include <vector>

class QGridLayout;
class QLabel;

namespace underact::gui {

/// Rows of a label and a value, right-aligned in one column, whose changes do not move the layout.
class Readout : public QWidget {
  Q_OBJECT
 public:
  explicit Readout(const QString& object_name, QWidget* parent = nullptr);
  /// Adds a row and returns its number. tip: one sentence.
  int addRow(const QString& label, const QString& tip = {});
  void addHeading(const QString& text);
  void set(int row, const QString& value);
  QString value(int row) const;
  void clear();

 private:
  QGridLayout* grid_;
  std::vector<QLabel*> labels_;
  std::vector<QLabel*> values_;
  int lines_ = 0;
};

}  // namespace underact::gui
