#include <filesystem>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/python.h"
#include "core/system/resource_paths.h"

namespace underact::cli {

void addFigures(Command program, const Streams& streams, Exit& exit) {
  const Command command =
      program.add("figures", "Remake the figures of the thesis, with the numbers that they should show");
  const auto out = std::make_shared<std::string>();
  const auto only = std::make_shared<std::string>();
  command.option("--out", *out, "Folder for the results; index.html shows them").required();
  command.option("--only", *only, "Numbers of the figures to make, separated by commas, as in 4.5,B.1");
  const auto progress_lines = std::make_shared<bool>(false);
  command.flag("--progress-lines", *progress_lines,
               "Report on standard error which figure is being made, one JSON object per line: {\"number\": 3, \"of\": "
               "27, \"figure\": \"4.2\"}");
  command.whenChosen([out, only, progress_lines, &streams, &exit] {
    const std::filesystem::path folder = system::searchRoots().here;
    std::vector<std::string> arguments{
        "figures", "--cli", (folder / "underact-cli").string(), "--window", (folder / "underact").string(),
        "--out",   *out};
    if (!only->empty()) arguments.insert(arguments.end(), {"--only", *only});
    if (*progress_lines) arguments.push_back("--progress-lines");
    exit = runPython(arguments, streams);
  });
}

}  // namespace underact::cli
