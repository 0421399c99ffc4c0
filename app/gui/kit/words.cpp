#include "app/gui/kit/words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/gui/kit/number_box.h"

namespace underact::gui {

QString tr(const char* text) {
  return QCoreApplication::translate("underact::gui", text);
}

QString sentenceText(const Sentence& sentence) {
  if (sentence.isNumber())
    return QString::fromStdString(sentence).replace('.', QLocale().decimalPoint()).replace('-', QChar(0x2212));
  // Edited as a string after it was built: its pattern no longer matches.
  const bool is_whole = filled(sentence.pattern(), {sentence.places().begin(), sentence.places().end()}) == sentence;
  if (!is_whole) return QString::fromStdString(sentence);
  std::vector<std::string> words;
  for (const Sentence& place : sentence.places()) words.push_back(sentenceText(place).toStdString());
  // Without letters it is the same in every language.
  const auto isLetter = [](char one) { return std::isalpha(static_cast<unsigned char>(one)) != 0; };
  const bool has_words = std::any_of(sentence.pattern().begin(), sentence.pattern().end(), isLetter);
  const std::string pattern =
      has_words ? QCoreApplication::translate("problem", sentence.pattern().c_str()).toStdString() : sentence.pattern();
  return QString::fromStdString(filled(pattern, words));
}

QString menuText(QString name) {
  return name.replace('&', "&&");
}

QString fileNameOf(const QString& words) {
  constexpr int kLongest = 60;  // characters, of up to four bytes: a name has 255
  QString name;
  int letters = 0;
  for (const char32_t letter : words.normalized(QString::NormalizationForm_C).toStdU32String()) {
    const bool kept = QChar::isLetterOrNumber(letter) || QChar::isMark(letter);
    if (kept && ++letters <= kLongest) name += QString::fromUcs4(&letter, 1);
    if (!kept && !name.isEmpty() && !name.endsWith('-')) name += '-';
  }
  return name.endsWith('-') ? name.chopped(1) : name;
}

QString sentencesOf(const Problems& problems) {
  QStringList lines;
  for (const Problem& problem : problems) lines << sentenceText(problem.sentence);
  return lines.join('\n');
}

QString numberText(double value, int decimals) {
  if (!std::isfinite(value)) return QString(QChar(0x2013));
  const QString plain = QString::number(std::abs(value), 'f', decimals);
  const bool zero = plain.count('0') + plain.count('.') == plain.size();
  QString text = localNumber(std::abs(value), 'f', decimals);
  if (value < 0.0 && !zero) text.prepend(QChar(0x2212));
  return text;
}

QString millimetres(double length_mm) {
  return QObject::tr("%1 mm").arg(numberText(length_mm, 1));
}

QString placeText(const Vec3& p_mm) {
  return QObject::tr("%1, %2, %3 mm").arg(numberText(p_mm.x(), 1), numberText(p_mm.y(), 1), numberText(p_mm.z(), 1));
}

QString directionText(const Vec3& direction) {
  const Vec3 unit = direction.normalized();
  return QString("%1, %2, %3").arg(numberText(unit.x(), 3), numberText(unit.y(), 3), numberText(unit.z(), 3));
}

QString phrasesOf(const std::vector<Sentence>& phrases) {
  QStringList list;
  for (const Sentence& phrase : phrases) list << sentenceText(phrase);
  return list.join(", ");
}

}  // namespace underact::gui
