// underact-session-reader: started by the programs to read one recorded session, shut off from all else; of no use on
// its own.
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
  end(underact::session_reader::serve());  // at once: what ends in order may call what is shut off
}
