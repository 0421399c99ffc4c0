#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "device/remote/address.h"

namespace underact::device::remote {

/// Keys of CURVE (Curve25519), as Z85: 40 characters each.
struct KeyPair {
  std::string public_key, secret_key;
};

/// Whether that is a key, as far as its characters say.
bool isKey(std::string_view text);

/// A user's keys, a folder of three files: arm_key (the pair of this user, for both ends), arm_clients (who may use an
/// arm that is shared here: "KEY NAME" a line) and arm_hosts (at whose arms this user may push: "HOST:PORT KEY" a
/// line). A file that others may read or write, or that is another user's, is a problem wherever it is needed, and is
/// left as it is.
class KeyFolder {
 public:
  /// The user's own: $UNDERACT_KEYS, or Underact in $XDG_CONFIG_HOME or ~/.config.
  KeyFolder();
  explicit KeyFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
  const std::filesystem::path& path() const { return folder_; }

  /// Whether there is a pair already.
  bool hasOwn() const;
  /// The pair, made at the first use. Problems: the file cannot be read or written, is none, or others may read it.
  Result<KeyPair> own() const;
  /// Another pair in place of it.
  Result<KeyPair> makeNew() const;
  /// Those who may use an arm shared here. Problems: the file cannot be read; a line is none.
  Result<std::vector<std::string>> clients() const;
  /// Adds one, with whatever words tell people whose it is.
  Problems allow(const std::string& key, const std::string& words) const;
  /// The key of whoever shares an arm there; empty: none is known. This machine's, where none is noted: one's own.
  Result<std::string> keyOf(const Address& address) const;
  /// Notes it, in place of the one that was.
  Problems trust(const Address& address, const std::string& key) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace underact::device::remote
