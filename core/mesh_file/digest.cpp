#include "core/mesh_file/digest.h"

#include <xxhash.h>

#include <array>

namespace underact::mesh_file {

struct Digest::State {
  XXH3_state_t* xxh3 = XXH3_createState();  // which asks for 64 bytes of alignment
  ~State() { XXH3_freeState(xxh3); }
};

Digest::Digest() : state_(std::make_unique<State>()) {
  XXH3_128bits_reset(state_->xxh3);
}

Digest::~Digest() = default;

void Digest::add(std::span<const std::byte> bytes) {
  XXH3_128bits_update(state_->xxh3, bytes.data(), bytes.size());
}

std::string Digest::text() const {
  XXH128_canonical_t canonical{};
  XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state_->xxh3));
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : canonical.digest) text += {kDigits[byte >> 4U], kDigits[byte & 15U]};
  return text;
}

}  // namespace underact::mesh_file
