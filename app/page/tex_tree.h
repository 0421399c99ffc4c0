#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace underact::page {

/// What a formula is made of.
enum class TexKind {
  Row,       // parts, side by side
  Letter,    // text, slanted: a variable
  Upright,   // text, as it is: a number, a function's name, a bracket, words
  Operator,  // text, with room around it: + = ·
  Space,     // text
  Script,    // parts: base, below, above; what is not there is an empty Row
  Fraction,  // parts: above, below the line
  Root,      // parts: what it is of
  Accent,    // parts: the letter; text: the mark that combines with it
  Bold,      // parts: what is bold
  Fence,     // parts: what is inside; text, right: brackets that grow with it, or none
  Grid       // parts: cells, row by row, `columns` each; text: its environment, "bmatrix"
};

struct TexNode {
  TexKind kind = TexKind::Row;
  std::string text = {};  // UTF-8
  std::string right = {};
  std::vector<TexNode> parts = {};
  std::size_t columns = 0;
};

/// The formula as a tree. tex: the text between the dollar signs, in the small subset of TeX that is supported.
/// Problems: commands that are not known, each by its name; or one, where braces or environments do not match, or where
/// it is longer than 4000 bytes or deeper than 24.
Result<TexNode> parseTex(std::string_view tex, const SourceLocation& place);

}  // namespace underact::page
