#include <iostream>

#include "app/cli/command.h"
#include "core/system/current_folder.h"
#include "core/system/descriptor.h"
#include "core/system/signals.h"
#include "core/system/this_process.h"

int main(int argc, char** argv) {
  underact::system::keepOutCurrentFolder();
  underact::system::reportFullFiles();
  const underact::cli::Streams streams{std::cin, std::cout, std::cerr,
                                       underact::system::isTerminal(underact::system::kErrors),
                                       underact::system::kOutput};
  return static_cast<int>(underact::cli::execute({argv + (argc > 0 ? 1 : 0), argv + argc}, streams));
}
