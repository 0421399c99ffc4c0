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

/// Whether it has the form of a key.
bool isKey(std::string_view text);

/// A user's keys, a folder of three files: arm_key (this user's key pair, for both ends), arm_clients (who may use an
/// arm that is shared here: a line "KEY NAME" each) and arm_hosts (the arms that this user may use: a line "HOST:PORT
/// KEY" each). A file that others may read or write, or that belongs to another user, is a problem whenever it is
/// needed, and is left as it is.
class KeyFolder {
 public:
  /// The user's own folder: $UNDERACT_KEYS, or Underact in $XDG_CONFIG_HOME or ~/.config.
  KeyFolder();
  explicit KeyFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
  const std::filesystem::path& path() const { return folder_; }

  /// Whether the pair exists.
  bool hasOwn() const;
  /// The pair, created on first use. Problems: the file cannot be read or written, is not a key pair, or others may
  /// read it.
  Result<KeyPair> own() const;
  /// Replaces the pair by a new one.
  Result<KeyPair> makeNew() const;
  /// Those who may use an arm shared here. Problems: the file cannot be read; a line is not valid.
  Result<std::vector<std::string>> clients() const;
  /// Adds one, with any words that tell people whose it is.
  Problems allow(const std::string& key, const std::string& words) const;
  /// The key of the arm shared there; empty: not known. For this computer, if none is stored: the user's own.
  Result<std::string> keyOf(const Address& address) const;
  /// Stores it, replacing an earlier one.
  Problems trust(const Address& address, const std::string& key) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace underact::device::remote
