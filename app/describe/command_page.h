#pragma once
#include <string>
#include <vector>

#include "app/describe/grammar.h"

namespace underact::describe {

/// The page of the guide with every command and option, as Markdown.
std::string commandPage(const std::vector<Command>& programs);

}  // namespace underact::describe
