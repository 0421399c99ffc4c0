#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/options/command.h"
#include "core/system/scheduling.h"

namespace underact::options {

/// What the command line asks of the window.
struct WindowOptions {
  std::string file;     // to open; empty: the last scene, or the sphere
  std::string picture;  // a scene to draw into out, without a window
  std::string film;     // a scene or session to film into out, without a window
  std::string out;
  std::string film_size = "1280x720", film_hand = "sweep";
  int film_fps = 30;
  double film_seconds = 10.0, film_speed = 1.0;
  bool overwrite = false, progress_lines = false;
  std::string small_pictures;  // a folder for those in the list of scenes
  bool visitors = false;       // visitor mode, with those scenes; none: those chosen last
  std::vector<std::string> visitor_scenes;
  std::string device;          // KIND or KIND:ADDRESS; empty: the one used last
  std::optional<int> rate_hz;  // none: the window's choice
  system::SchedulingRequest scheduling;
  int max_late = 20;  // ticks in a row
  // Help, the version, or what is wrong with the command line, and the exit status that goes with it; empty: go on.
  std::string given;
  int exit = 0;
};

/// The grammar of underact. options: outlives the grammar, which writes into it.
Program windowGrammar(WindowOptions& options);

/// arguments: without the program's name.
WindowOptions parseWindowOptions(std::vector<std::string> arguments);

}  // namespace underact::options
