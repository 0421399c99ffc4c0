#include <filesystem>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/python.h"

namespace underact::cli {

void addFigures(CLI::App& program, const Streams& streams, Exit& exit) {
  CLI::App* command =
      program.add_subcommand("figures", "Remake the figures of the thesis, with what they should show in numbers");
  const auto out = std::make_shared<std::string>();
  const auto only = std::make_shared<std::string>();
  command->add_option("--out", *out, "Folder to write into; its page is index.html")->required();
  command->add_option("--only", *only, "Numbers of figures with commas between, as in 4.5,B.1");
  command->callback([out, only, &streams, &exit] {
    const std::filesystem::path folder = programFolder();
    std::vector<std::string> arguments{
        "figures", "--cli", (folder / "underact-cli").string(), "--window", (folder / "underact").string(),
        "--out",   *out};
    if (!only->empty()) arguments.insert(arguments.end(), {"--only", *only});
    exit = runPython(arguments, streams);
  });
}

}  // namespace underact::cli
