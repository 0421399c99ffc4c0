#include "app/gui/options.h"

#include <charconv>

namespace underact::gui {
namespace {

bool readRate(const std::string& text, int& rate_hz) {
  const char* end = text.data() + text.size();
  const std::from_chars_result read = std::from_chars(text.data(), end, rate_hz);
  return read.ec == std::errc() && read.ptr == end && rate_hz >= 100 && rate_hz <= 4000;
}

}  // namespace

Options parseOptions(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t index = 0; index < arguments.size(); ++index) {
    const std::string& argument = arguments[index];
    const auto value = [&](std::string& into) {
      if (index + 1 < arguments.size())
        into = arguments[++index];
      else
        options.wrong = argument + " needs a value.";
    };
    std::string rate;
    if (argument == "--help" || argument == "-h")
      options.help = true;
    else if (argument == "--version")
      options.version = true;
    else if (argument == "--picture")
      value(options.picture);
    else if (argument == "--out")
      value(options.out);
    else if (argument == "--rate") {
      value(rate);
      if (!readRate(rate, options.rate_hz)) options.wrong = "--rate is a number of Hz from 100 to 4000.";
    } else if (argument.size() > 1 && argument.front() == '-')
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
  underact --picture SCENE --out FILE.png   draws the 3D view of a scene and quits
  --rate HZ      ticks a second, 100 to 4000 (1000)
  --help         this text
  --version      the version

Without an arm it runs on a simulated one. underact-cli is everything without a window.
)";
}

}  // namespace underact::gui
