#pragma once
#include <string>

#include "app/describe/grammar.h"

namespace underact::describe {

/// The program's page of section 1 of the manual, as troff with the man macros. Source: man(7).
std::string manPage(const Command& program);

}  // namespace underact::describe
