#pragma once
#include <QDoubleSpinBox>
#include <QString>
#include <optional>

namespace underact::gui {

/// A number as typed: with a point or a comma, a hyphen or a minus sign. None: not a number.
std::optional<double> typed(const QString& text);

/// A number in the user's locale: 1,5 or 1.5. format and precision as in QString::number().
QString localNumber(double value, char format, int precision);

/// A number field that accepts a point or a comma. Qt's own reads 1.5 as 15 in locales with a decimal comma.
class NumberBox : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;
};

}  // namespace underact::gui
