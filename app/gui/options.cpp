#include "app/gui/options.h"

#include <charconv>
#include <functional>

#include "core/servo/device_port.h"

namespace underact::gui {
namespace {

bool readNumber(const std::string& text, int least, int most, int& number) {
  const char* end = text.data() + text.size();
  int value = 0;
  const std::from_chars_result read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end || value < least || value > most) return false;
  number = value;
  return true;
}

bool readWay(const std::string& text, servo::Way& way) {
  struct Row {
    const char* word;
    servo::Way way;
  };
  for (const Row& row : {Row{"auto", servo::Way::Auto}, Row{"fifo", servo::Way::Fifo}, Row{"rtkit", servo::Way::Rtkit},
                         Row{"normal", servo::Way::Normal}}) {
    if (text != row.word) continue;
    way = row.way;
    return true;
  }
  return false;
}

/// The options that a number or a word follows. False: it is none of them.
bool readServoOption(const std::string& argument, const std::function<std::string()>& value, Options& options) {
  constexpr int kMostCores = 4095, kMostLate = 1'000'000;
  if (argument == "--rate") {
    int rate_hz = 0;
    if (readNumber(value(), servo::kSlowest_hz, servo::kFastest_hz, rate_hz))
      options.rate_hz = rate_hz;
    else if (options.wrong.empty())
      options.wrong = "--rate is a number of Hz from 100 to 10000.";
  } else if (argument == "--scheduling") {
    if (!readWay(value(), options.scheduling.way) && options.wrong.empty())
      options.wrong = "--scheduling is auto, fifo, rtkit or normal.";
  } else if (argument == "--max-late") {
    if (!readNumber(value(), 1, kMostLate, options.max_late) && options.wrong.empty())
      options.wrong = "--max-late is a number of ticks in a row, from 1.";
  } else if (argument == "--core") {
    if (!readNumber(value(), 0, kMostCores, options.scheduling.core) && options.wrong.empty())
      options.wrong = "--core is the number of a core, from 0.";
  } else {
    return false;
  }
  return true;
}

}  // namespace

Options parseOptions(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t index = 0; index < arguments.size(); ++index) {
    const std::string& argument = arguments[index];
    const auto value = [&] {
      if (index + 1 < arguments.size()) return arguments[++index];
      options.wrong = argument + " needs a value.";
      return std::string();
    };
    if (readServoOption(argument, value, options)) continue;
    if (argument == "--help" || argument == "-h")
      options.help = true;
    else if (argument == "--version")
      options.version = true;
    else if (argument == "--device")
      options.device = value();
    else if (argument == "--picture")
      options.picture = value();
    else if (argument == "--out")
      options.out = value();
    else if (argument.size() > 1 && argument.front() == '-')
      options.wrong = "There is no option " + argument + ".";
    else if (options.scene.empty())
      options.scene = argument;
    else
      options.wrong = "One scene at a time: " + argument + " is one too many.";
  }
  if (options.wrong.empty() && options.picture.empty() != options.out.empty()) {
    options.wrong = "--picture SCENE and --out FILE.png go together.";
  }
  return options;
}

std::string usage() {
  return R"(underact: feel geometry through a small haptic arm, and see what you feel.

  underact [SCENE]                          opens the window, with a scene file or the last one
  underact MESH.stl                         opens the window and loads a mesh (also .obj, .ply, .off)
  underact POINTS.txt                       opens the window and loads a curve (also .csv, .xyz, ...)
  underact SESSION.h5                       opens the window and replays a recorded session
  underact --picture SCENE --out FILE.png   draws the 3D view of a scene and quits
  --device ARM       the arm, KIND or KIND:ADDRESS as underact-cli devices lists it (the one used last)
  --rate HZ          ticks a second, 100 to 10000 (as chosen in the Servo panel; 1000)
  --scheduling WAY   how the servo thread is scheduled: auto, fifo, rtkit or normal (auto)
  --core N           the one core the servo thread runs on
  --max-late N       ticks in a row a whole period late that are borne before the force is let go (20)
  --help             this text
  --version          the version

Without an arm it runs on a simulated one. underact-cli is everything without a window.
)";
}

}  // namespace underact::gui
