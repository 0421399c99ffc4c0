#include <unistd.h>

#include <iostream>

#include "app/cli/command.h"
#include "core/system/current_folder.h"

int main(int argc, char** argv) {
  underact::system::keepOutCurrentFolder();
  const underact::cli::Streams streams{std::cin, std::cout, std::cerr, isatty(STDERR_FILENO) != 0, STDOUT_FILENO};
  return static_cast<int>(underact::cli::execute({argv + (argc > 0 ? 1 : 0), argv + argc}, streams));
}
