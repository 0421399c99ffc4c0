#pragma once
#include <string>
#include <vector>

namespace underact::guide {

// Pieces of a page of Markdown.

/// The text with the characters that Markdown interprets escaped.
std::string plainText(const std::string& text);

/// The text for a cell of a table.
std::string cellText(const std::string& text);

/// As code; in a cell, too.
std::string inCode(const std::string& text);

/// "`a`, `b`".
std::string listedInCode(const std::vector<std::string>& words);

/// Lines as a block of code.
std::string asBlock(const std::string& lines);

/// With a full stop, unless it ends with a mark of its own.
std::string sentence(std::string text);

}  // namespace underact::guide
