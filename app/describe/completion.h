#pragma once
#include <string>

#include "app/describe/grammar.h"

namespace underact::describe {

/// The script with which a shell completes the program's commands, options, and values that are a choice of words. For
/// other values, files are offered.
std::string bashCompletion(const Command& program);
std::string zshCompletion(const Command& program);
std::string fishCompletion(const Command& program);

}  // namespace underact::describe
