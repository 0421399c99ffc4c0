#pragma once
#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"

namespace underact::test {

/// What may lie at a name in place of a file, and is none that can be read.
struct OddFile {
  std::string what;  // "a pipe"
  std::string path;
};

/// Pipe, socket, links to both, devices, a folder, no file, 1 TiB of nothing; all below folder but the devices. ending:
/// of the names, ".json".
std::vector<OddFile> oddFiles(const ScratchFolder& folder, const std::string& ending);

}  // namespace underact::test
