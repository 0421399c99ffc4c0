// underact-guard: started by the program for an arm behind a file descriptor; of no use on its own.
#include <cstdio>

#include "app/guard/watch.h"
#include "core/system/signals.h"

int main(int argc, char** argv) {
  const auto duty = underact::guard::readDuty(argc, argv);
  if (!duty) {
    std::fprintf(stderr, "underact-guard is started by underact; by hand it does nothing.\n");
    return 2;
  }
  underact::system::endWithParentOnly();
  return underact::guard::watch(*duty);
}
