#pragma once
#include <QString>
#include <QStringList>

namespace underact::gui {

/// What the languages are known by in the settings: "system" first, then those that the window speaks.
QStringList languages();

/// The one that was chosen; "system" where none was, or one that is not among them.
QString chosenLanguage();
/// Kept in the user's settings; a window takes it up when it is made.
void chooseLanguage(const QString& language);

/// From now on texts are in that language, and numbers as it writes them; "system": as the system says, in English
/// where the window does not speak its language. Files, sessions and what commands print are always as they are in
/// English.
void speak(const QString& language);

}  // namespace underact::gui
