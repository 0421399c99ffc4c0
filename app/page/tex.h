#pragma once
#include <string>

#include "app/page/tex_tree.h"

namespace underact::page {

/// A formula of parseTex() as HTML that a browser and Qt's rich text both show: Qt does not support MathML, so stacked
/// parts are a table. The classes it names are those of pageStyle(). display: a formula on a line of its own, a block;
/// else one inside a sentence, where a fraction is a/b and a matrix [a, b; c, d].
std::string texToHtml(const TexNode& formula, bool display);

/// The formula as plain text on one line, for a search: "τ = JpT f".
std::string texToText(const TexNode& formula);

}  // namespace underact::page
