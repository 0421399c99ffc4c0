#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/page/tex_tree.h"

namespace underact::page {

/// A command without arguments: what stands for it.
struct TexWord {
  std::string_view name;
  TexKind kind;
  std::string_view text;
};

/// Null: no such command.
const TexWord* findTexWord(std::string_view name);

/// The mark of \vec, \hat, ...; empty: no such command.
std::string_view texAccent(std::string_view name);

/// Every command there is, for a guess at what a wrong one was meant to be, and for the page on formulas.
std::vector<std::string> texCommands();

}  // namespace underact::page
