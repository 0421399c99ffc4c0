#include "core/sweep/checksum.h"

#include <cstddef>
#include <span>

#include "core/mesh_file/digest.h"

namespace underact::sweep {

std::string checksumOf(std::string_view bytes) {
  mesh_file::Digest digest;
  digest.add(std::as_bytes(std::span(bytes.data(), bytes.size())));
  return digest.text();
}

}  // namespace underact::sweep
