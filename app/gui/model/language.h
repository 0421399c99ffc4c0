#pragma once
#include <QString>
#include <QStringList>

namespace underact::gui {

/// The keys of the languages in the settings: "system" first, then those of the window.
QStringList languages();

/// The chosen one; "system" if none was chosen or it is unknown.
QString chosenLanguage();
/// Saved in the user's settings; takes effect when a window is made.
void chooseLanguage(const QString& language);

/// From now on texts and numbers are in that language; "system": the system's, or English if the window does not speak
/// it. Files, sessions and the output of commands are always in English.
void speak(const QString& language);

}  // namespace underact::gui
