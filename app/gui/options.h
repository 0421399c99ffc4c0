#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/servo/scheduling.h"

namespace underact::gui {

/// What the command line asks of the window.
struct Options {
  std::string scene;    // to open, or a recorded session; empty: the last one, or the sphere
  std::string picture;  // a scene to draw into out, without a window
  std::string out;
  std::string device;          // KIND or KIND:ADDRESS; empty: the one used last
  std::optional<int> rate_hz;  // none: the window's choice
  servo::SchedulingWanted scheduling;
  int max_late = 20;  // ticks in a row
  bool help = false;
  bool version = false;
  std::string wrong;  // a sentence, where the command line cannot be understood
};

/// arguments: without the program's name.
Options parseOptions(const std::vector<std::string>& arguments);

/// What --help prints.
std::string usage();

}  // namespace underact::gui
