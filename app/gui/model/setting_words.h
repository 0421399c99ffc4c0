#pragma once
#include <QStringList>
#include <string_view>

namespace underact::gui {

// What the table of settings says of one, in the window's language. path: of the table, with stars or numbers.

/// In the midst of a sentence, and for what is undone: "blend width".
QString settingLabel(std::string_view path);
QString settingTip(std::string_view path);
/// Empty: a plain number.
QString settingUnit(std::string_view path);
double settingMost(std::string_view path);
/// Of a choice, what is said for each of its words, in their order: "P, proportional".
QStringList settingChoices(std::string_view path);
/// Of one of its words.
QString settingChoice(std::string_view path, std::string_view word);

}  // namespace underact::gui
