#pragma once
#include <QHash>
#include <QStringList>

namespace underact::gui {

/// A text as it is searched: in lower case, letters without accents, one space between words.
QString searchText(const QString& text);

/// How well what is typed fits an entry: each of its words must begin a word of one of the entry's texts. 0: it does
/// not fit. The greater, the better: the first text counts most, and a word at its beginning more.
/// texts: as of searchText().
int fitOf(const QString& typed, const QStringList& texts);

/// The texts of the window in each of its other languages, by that of this one; both as of searchText(). Read from the
/// translations in the program: empty where there are none.
QMultiHash<QString, QString> otherLanguages();

}  // namespace underact::gui
