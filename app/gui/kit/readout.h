#pragma once
#include <QString>
#include <QWidget>
#include <vector>

class QGridLayout;
class QLabel;

namespace underact::gui {

/// Rows of a label and a value, values right-aligned in one column, which change without moving anything.
class Readout : public QWidget {
  Q_OBJECT
 public:
  explicit Readout(const QString& object_name, QWidget* parent = nullptr);
  /// A new row; tip: one sentence. Gives its number.
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
