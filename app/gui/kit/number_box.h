#pragma once
#include <QDoubleSpinBox>
#include <QString>
#include <optional>

namespace underact::gui {

/// A number as someone types it: with a point or a comma, with the keyboard's minus or a real one. None: no number.
std::optional<double> typed(const QString& text);

/// As the user's system writes numbers: 1,5 or 1.5. format and precision as QString::number() has them.
QString localNumber(double value, char format, int precision);

/// A field for a number, which takes a point and a comma alike: Qt's own reads 1.5 as 15 where a comma parts decimals.
class NumberBox : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;
};

}  // namespace underact::gui
