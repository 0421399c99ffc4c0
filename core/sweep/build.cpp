#include "core/sweep/build.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/json/text.h"
#include "core/mesh_file/digest.h"
#include "core/system/library.h"

namespace underact::sweep {
namespace {

constexpr std::size_t kLargestProgram = std::size_t{4} << 30U;

/// Whether a loaded object affects the results: the program, first and without a name, and the libraries of
/// trigonometry and powers. Others (parts of MPI, of the kernel) may differ between ranks.
bool computes(std::string_view path, bool is_program) {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  return is_program || name.starts_with("libsleef.") || name.starts_with("libm.");
}

std::string identityOf(const system::Loaded& object) {
  if (!object.build_id.empty()) return object.build_id;
  const Result<std::string> bytes = json::readTextFile(object.path, "a program", kLargestProgram);
  return bytes ? checksumOf(bytes.value()) : "unknown";
}

}  // namespace

const std::string& buildOf() {
  static const std::string kBuild = [] {
    std::vector<std::string> found;
    for (const system::Loaded& object : system::loadedHere()) {
      if (computes(object.path, found.empty())) found.push_back(identityOf(object));
    }
    std::sort(found.begin(), found.end());  // libraries are in the order of loading
    std::string all;
    for (const std::string& one : found) all += one + "\n";
    return checksumOf(all);
  }();
  return kBuild;
}

std::string checksumOf(std::string_view bytes) {
  mesh_file::Digest digest;
  digest.add(std::as_bytes(std::span(bytes.data(), bytes.size())));
  return digest.text();
}

}  // namespace underact::sweep
