#pragma once
#include <string>

namespace underact {

/// Where a helper program of ours is: where the environment variable says, if one is named and set; else beside the
/// running program, one folder up (the tests' place), or where an installed one has its helpers. Empty: nowhere.
std::string helperProgram(const std::string& name, const char* variable = nullptr);

}  // namespace underact
