#include "app/options/window_options.h"

#include <underact/version.h>

#include <sstream>
#include <utility>

#include "app/options/scheduling_options.h"
#include "core/servo/device_port.h"

namespace underact::options {

namespace {

void addFilm(Program& program, WindowOptions& options, const Option& picture, const Option& out) {
  const Option film =
      program
          .option("--film", options.film,
                  "Film this scene in a scripted hand, or this recorded session, without a window, and quit; the "
                  "program ffmpeg encodes it")
          .word("FILE");
  film.needs(out).excludes(picture);
  program.option("--size", options.film_size, "Width and height of the film, px, both even")
      .word("WxH")
      .showDefault()
      .needs(film);
  program.option("--fps", options.film_fps, "Pictures a second").showDefault().range(1, 60).needs(film);
  program.option("--hand", options.film_hand, "Hand in a filmed scene, as of underact-cli run")
      .word("HAND")
      .showDefault()
      .needs(film);
  program.option("--seconds", options.film_seconds, "Length of a filmed scene")
      .showDefault()
      .range(0.1, 600.0)
      .needs(film);
  program.option("--speed", options.film_speed, "Below 1: slower than it was")
      .showDefault()
      .range(0.1, 1.0)
      .needs(film);
  program.flag("--progress-lines", options.progress_lines, "Write the percentage made, a line each, to stderr")
      .needs(film);
  program.flag("--overwrite", options.overwrite, "Replace the film if it exists").needs(film);
}

}  // namespace

Program windowGrammar(WindowOptions& options) {
  constexpr int kMaxLate = 1'000'000;
  Program program("underact", "Feel geometry through a small haptic arm, and see what you feel.");
  program.footer("Without an arm it simulates one. underact-cli is the program without a window.");
  program.version(std::string("underact ") + kVersion);
  program
      .option(
          "file", options.file,
          "A scene, lesson or arm file (.json, .urdf); a mesh (.stl, .obj, .ply, .off) or the points of a curve "
          "(.txt, .csv, .xyz), which is put into a scene; a recorded session (.h5), which is replayed; or a notebook "
          "(.ipynb). Its content decides, not its name")
      .word("FILE");
  const Option picture =
      program.option("--picture", options.picture, "Draw the 3D view of this scene, without a window, and quit")
          .word("SCENE");
  const Option out =
      program.option("--out", options.out, "File of the picture (PNG) or film (.webm, .mp4, .gif)").word("FILE");
  picture.needs(out);
  addFilm(program, options, picture, out);
  program
      .option("--small-pictures", options.small_pictures,
              "Draw the small pictures of all scenes that come with the program, and quit")
      .word("FOLDER");
  program
      .option(
          "--visitor",
          [&options](const std::vector<std::string>& scenes) {
            options.visitors = true;
            options.visitor_scenes = scenes;
          },
          "Visitor mode with these scenes in turn; without any, with those chosen last. Ctrl+Alt+Shift+U opens the way "
          "out")
      .expected(0, -1)
      .word("SCENE");
  program.option("--device", options.device, "The arm, as underact-cli devices lists it; by default the one used last")
      .word("KIND[:ADDRESS]");
  program.option("--rate", options.rate_hz, "Ticks per second; by default the rate of the Servo panel")
      .word("HZ")
      .range(servo::kSlowest_hz, servo::kFastest_hz);
  addSchedulingOptions(program, options.scheduling);
  program
      .option("--max-late", options.max_late,
              "Permitted number of consecutive ticks that are a whole period late; more release the force")
      .showDefault()
      .range(1, kMaxLate);
  return program;
}

WindowOptions parseWindowOptions(std::vector<std::string> arguments) {
  constexpr int kUsage = 2;
  WindowOptions options;
  std::ostringstream given;
  const Parsed parsed = windowGrammar(options).parse(std::move(arguments), given, given);
  options.exit = parsed == Parsed::Wrong ? kUsage : 0;
  options.given = given.str();
  if (parsed == Parsed::Done && !options.out.empty() && options.picture.empty() && options.film.empty()) {
    options.exit = kUsage;
    options.given = "--out needs --picture or --film.\n";
  }
  return options;
}

}  // namespace underact::options
