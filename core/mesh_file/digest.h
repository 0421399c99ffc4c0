#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace underact::mesh_file {

/// XXH3 of 128 bits: detects different or damaged contents; no protection against forgery.
class Digest {
 public:
  /// The digest of no bytes.
  Digest();
  ~Digest();
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;
  /// Appends to what is digested; in one call or in many, the digest is the same.
  void add(std::span<const std::byte> bytes);
  std::string text() const;  // 32 hexadecimal digits

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace underact::mesh_file
