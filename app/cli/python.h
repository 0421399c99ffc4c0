#pragma once
#include <string>
#include <vector>

#include "app/cli/command.h"

namespace underact::cli {

/// Runs the Python package that ships with the program (app/python) with these arguments and waits for its end; what it
/// prints goes where this program's own does. Python is UNDERACT_PYTHON, else the system's; no module is taken from the
/// folder that one stands in, nor by PYTHONPATH. Returns its exit status; if it cannot be started, prints a sentence on
/// err and returns Exit::File.
Exit runPython(const std::vector<std::string>& arguments, const Streams& streams);

}  // namespace underact::cli
