#pragma once
#include <functional>
#include <string>

#include "app/describe/grammar.h"

namespace underact::describe {

/// "underact-cli" as the name of a shell's function: "_underact_cli".
std::string functionName(const std::string& program);

/// The text in apostrophes, as bash, zsh and fish all read it.
std::string inApostrophes(const std::string& text);

/// Calls visit for the program, with "", and for each command below it, with the words that lead to it: " lab trade".
void visitAll(const Command& program, const std::function<void(const Command&, const std::string& path)>& visit);

}  // namespace underact::describe
