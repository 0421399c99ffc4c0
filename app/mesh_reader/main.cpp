// underact-mesh-reader: started by the program to read one mesh file, isolated from everything else; of no use on its
// own.
#include <cstdio>

#include "app/mesh_reader/serve.h"
#include "core/system/descriptor.h"
#include "core/system/this_process.h"

int main(int argc, char** argv) {
  using namespace underact::system;
  if (argc != 2 || isTerminal(kInput) || isTerminal(kOutput)) {
    std::fprintf(stderr, "underact-mesh-reader is started by underact; by hand it does nothing.\n");
    return 2;
  }
  end(underact::mesh_reader::serve(argv[1]));  // at once: an orderly exit may make system calls that are not allowed
}
