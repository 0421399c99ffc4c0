// underact-mesh-reader: started by the program to read one mesh file, shut off from all else; of no use on its own.
#include <unistd.h>

#include <cstdio>

#include "app/mesh_reader/serve.h"

int main(int argc, char** argv) {
  if (argc != 2 || isatty(STDIN_FILENO) != 0 || isatty(STDOUT_FILENO) != 0) {
    std::fprintf(stderr, "underact-mesh-reader is started by underact; by hand it does nothing.\n");
    return 2;
  }
  _exit(underact::mesh_reader::serve(argv[1]));  // at once: what ends in order may call what is shut off
}
