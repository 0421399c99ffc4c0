#include "app/gui/kit/number_box.h"

#include <QLocale>

namespace underact::gui {
namespace {

/// Replaces character by character, so the cursor stays in place.
QString with(QString text, const QString& decimal_point) {
  text.replace(QChar(0x2212), QLatin1Char('-'));
  text.replace(QLatin1Char('.'), decimal_point).replace(QLatin1Char(','), decimal_point);
  return text;
}

}  // namespace

std::optional<double> typed(const QString& text) {
  bool is_number = false;
  const double number = with(text.trimmed(), QStringLiteral(".")).toDouble(&is_number);
  return is_number ? std::optional(number) : std::nullopt;
}

QString localNumber(double value, char format, int precision) {
  return QLocale().toString(value, format, precision);
}

double NumberBox::valueFromText(const QString& text) const {
  return QDoubleSpinBox::valueFromText(with(text, locale().decimalPoint()));
}

QValidator::State NumberBox::validate(QString& text, int& position) const {
  QString plain = with(text, locale().decimalPoint());
  return QDoubleSpinBox::validate(plain, position);
}

}  // namespace underact::gui
