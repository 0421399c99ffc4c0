// underact-session-reader: started by the programs to read one recorded session, shut off from all else; of no use on
// its own.
#include <unistd.h>

#include <cstdio>

#include "app/session_reader/serve.h"

int main() {
  if (isatty(STDIN_FILENO) != 0 || isatty(STDOUT_FILENO) != 0) {
    std::fprintf(stderr, "underact-session-reader is started by underact; by hand it does nothing.\n");
    return 2;
  }
  _exit(underact::session_reader::serve());  // at once: what ends in order may call what is shut off
}
