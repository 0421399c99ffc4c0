// underact-session-reader: started by the programs to read one recorded session, isolated from everything else; of no
// use on its own.
#include <cstdio>

#include "app/session_reader/serve.h"
#include "core/system/descriptor.h"
#include "core/system/this_process.h"

int main() {
  using namespace underact::system;
  if (isTerminal(kInput) || isTerminal(kOutput)) {
    std::fprintf(stderr, "underact-session-reader is started by underact; by hand it does nothing.\n");
    return 2;
  }
  end(underact::session_reader::serve());  // at once: an orderly exit may make system calls that are not allowed
}
