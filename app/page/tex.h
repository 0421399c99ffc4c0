#pragma once
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace underact::page {

/// A formula as HTML that a browser and Qt's rich text both show: Qt does not support MathML, so stacked parts are a
/// table. The classes it names are those of pageStyle(). tex: the text between the dollar signs. display: a formula on
/// a line of its own, a block; else one inside a sentence, where a fraction is a/b and a matrix [a, b; c, d]. Problems:
/// as parseTex().
Result<std::string> texToHtml(std::string_view tex, bool display, const SourceLocation& place);

/// The formula as plain text on one line, for a search: "τ = JpT f". Problems: as parseTex().
Result<std::string> texToText(std::string_view tex, const SourceLocation& place);

}  // namespace underact::page
