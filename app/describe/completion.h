#pragma once
#include <string>

#include "app/describe/grammar.h"

namespace underact::describe {

/// What makes a shell complete the program's commands, options, and the values that are words to choose from. Where
/// anything can stand, files are offered.
std::string bashCompletion(const Command& program);
std::string zshCompletion(const Command& program);
std::string fishCompletion(const Command& program);

}  // namespace underact::describe
