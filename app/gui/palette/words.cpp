#include "app/gui/palette/words.h"

#include <QDir>
#include <QFile>
#include <QXmlStreamReader>
#include <algorithm>

namespace underact::gui {
namespace {

constexpr int kInFirst = 4, kAtBegin = 4, kElsewhere = 1;
constexpr int kLongest = 60;  // letters of a name; what is longer is a sentence

/// The share of one word.
int fitOfWord(const QString& word, const QStringList& texts) {
  int best = 0;
  for (int index = 0; index < texts.size(); ++index) {
    const int own = index == 0 ? kInFirst : kElsewhere;
    if (texts[index].startsWith(word)) {
      best = std::max(best, own + kAtBegin);
    } else if (texts[index].contains(" " + word)) {
      best = std::max(best, own);
    }
  }
  return best;
}

}  // namespace

QString searchText(const QString& text) {
  QString plain;
  for (const QChar letter : text.normalized(QString::NormalizationForm_KD).toLower()) {
    if (letter.isLetterOrNumber()) {
      plain += letter;
    } else if (letter != '&' && !letter.isMark()) {
      plain += ' ';
    }
  }
  return plain.simplified();
}

int fitOf(const QString& typed, const QStringList& texts) {
  int all = 0;
  const QStringList words = searchText(typed).split(' ', Qt::SkipEmptyParts);
  for (const QString& word : words) {
    const int fit = fitOfWord(word, texts);
    if (fit == 0) return 0;
    all += fit;
  }
  return words.isEmpty() ? 1 : all;
}

QMultiHash<QString, QString> otherLanguages() {
  QMultiHash<QString, QString> pairs;
  for (const QFileInfo& one : QDir(":/words").entryInfoList()) {
    QFile file(one.filePath());
    if (!file.open(QIODevice::ReadOnly)) continue;
    QXmlStreamReader reader(&file);
    QString english;
    while (!reader.atEnd()) {
      if (reader.readNext() != QXmlStreamReader::StartElement) continue;
      const bool is_source = reader.name() == QLatin1String("source");
      if (!is_source && reader.name() != QLatin1String("translation")) continue;
      const QString text = reader.readElementText(QXmlStreamReader::IncludeChildElements);
      if (is_source) {
        english = text.size() <= kLongest ? searchText(text) : QString();
      } else if (const QString other = searchText(text); !english.isEmpty() && other != english) {
        pairs.insert(english, other);
        pairs.insert(other, english);
      }
    }
  }
  return pairs;
}

}  // namespace underact::gui
