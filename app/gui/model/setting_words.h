#pragma once
#include <QString>
#include <string_view>

namespace underact::gui {

// What the table of settings says of one, in the window's language. path: of the table, with stars or numbers.

/// In the midst of a sentence, and for what is undone: "blend width".
QString settingLabel(std::string_view path);
QString settingTip(std::string_view path);
double settingMost(std::string_view path);

}  // namespace underact::gui
