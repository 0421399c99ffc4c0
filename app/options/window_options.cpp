#include "app/options/window_options.h"

#include <underact/version.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "app/options/scheduling_options.h"
#include "core/servo/device_port.h"

namespace underact::options {

void addWindowOptions(CLI::App& program, WindowOptions& options) {
  constexpr int kMostLate = 1'000'000;
  program.description("Feel geometry through a small haptic arm, and see what you feel.");
  program.name("underact");
  program.footer("Without an arm it runs on a simulated one. underact-cli is everything without a window.");
  program.failure_message(CLI::FailureMessage::simple);
  program.set_version_flag("--version", std::string("underact ") + kVersion, "Print the version and exit");
  program
      .add_option(
          "file", options.scene,
          "A scene (.json); a mesh (.stl, .obj, .ply, .off) or the points of a curve (.txt, .csv, .xyz), which is "
          "put into one; or a recorded session (.h5), which is replayed")
      ->type_name("FILE");
  auto* picture =
      program.add_option("--picture", options.picture, "Draw the 3D view of this scene, without a window, and quit")
          ->type_name("SCENE");
  auto* out = program.add_option("--out", options.out, "The picture's file (PNG)")->type_name("FILE");
  picture->needs(out);
  out->needs(picture);
  program
      .add_option("--small-pictures", options.small_pictures,
                  "Draw the small pictures of all scenes that come with the program, and quit")
      ->type_name("FOLDER");
  program
      .add_option_function<std::vector<std::string>>(
          "--visitor",
          [&options](const std::vector<std::string>& scenes) {
            options.visitors = true;
            options.visitor_scenes = scenes;
          },
          "Visitor mode with these scenes in turn; without any, those chosen last. Ctrl+Alt+Shift+U has the way out")
      ->expected(0, -1)
      ->type_name("SCENE");
  program
      .add_option("--device", options.device, "The arm, as underact-cli devices lists it; without it the one used last")
      ->type_name("KIND[:ADDRESS]");
  program.add_option("--rate", options.rate_hz, "Ticks a second; without it the Servo panel's")
      ->type_name("HZ")
      ->check(CLI::Range(servo::kSlowest_hz, servo::kFastest_hz));
  addSchedulingOptions(program, options.scheduling);
  program
      .add_option("--max-late", options.max_late,
                  "Ticks in a row a whole period late that are borne before the force is let go")
      ->capture_default_str()
      ->check(CLI::Range(1, kMostLate));
}

WindowOptions parseWindowOptions(std::vector<std::string> arguments) {
  WindowOptions options;
  CLI::App program;
  addWindowOptions(program, options);
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
  try {
    program.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    constexpr int kUsage = 2;
    std::ostringstream said;
    options.exit =
        program.exit(error, said, said) == 0 ? 0 : kUsage;  // help and the version come this way, too, with 0
    options.said = said.str();
  }
  return options;
}

}  // namespace underact::options
