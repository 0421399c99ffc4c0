#pragma once
#include <string>

namespace underact::system {

/// The machine that runs the program, for a record of what was run; empty words: the system does not say.
struct Machine {
  std::string processor;     // as the maker names it
  int cores = 0;             // that this process may use
  std::string kernel;        // "Linux 6.1.0-18-amd64"
  std::string architecture;  // "x86_64"
  std::string c_library;     // "glibc 2.36"
};

/// Reads it from the system. Any thread.
Machine thisMachine();

}  // namespace underact::system
