#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace underact::describe {

/// An option, or what stands without a name.
struct Option {
  std::vector<std::string> names;    // "-h", "--help"; none: it goes by its place
  std::string word;                  // what is put after it, or in its place: "FILE"; empty: a flag
  std::vector<std::string> choices;  // all that it can be; empty: anything
  std::string usual;                 // what it is by itself
  std::string range;                 // "100 to 10000"
  std::string what;
  bool required = false, many = false;
};

/// A program, or one of its commands, as its grammar says.
struct Command {
  std::string name, what, footer;
  std::vector<Option> options;
  std::vector<Command> commands;
};

/// All that man pages and completion are made from.
Command describe(const CLI::App& program);

}  // namespace underact::describe
