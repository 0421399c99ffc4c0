#pragma once
#include <QStringList>
#include <string_view>

namespace underact::gui {

// What the table of settings says about a setting, in the window's language. path: of the table, with stars or numbers.

/// Within a sentence, and for undo: "blend width".
QString settingLabel(std::string_view path);
QString settingTip(std::string_view path);
/// Empty: a plain number.
QString settingUnit(std::string_view path);
double settingMax(std::string_view path);
/// For a choice: the text for each of its words, in order: "P, proportional".
QStringList settingChoices(std::string_view path);
/// The text for one of its words.
QString settingChoice(std::string_view path, std::string_view word);

}  // namespace underact::gui
