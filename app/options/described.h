#pragma once
#include <string>
#include <vector>

#include "app/options/command.h"

namespace underact::options {

/// An option, or a positional argument.
struct DescribedOption {
  std::vector<std::string> names;    // "-h", "--help"; none: a positional argument
  std::string word;                  // its argument, or the positional argument: "FILE"; empty: a flag
  std::vector<std::string> choices;  // all that it can be; empty: anything
  std::string default_value;         // its default
  std::string range;                 // "100 to 10000"
  std::string what;
  bool required = false, many = false;
};

/// A program, or one of its commands, as its grammar defines it.
struct DescribedCommand {
  std::string name, what, footer;
  std::vector<DescribedOption> options;
  std::vector<DescribedCommand> commands;
};

/// All that man pages and completion are made from.
DescribedCommand describe(Command command);

}  // namespace underact::options
