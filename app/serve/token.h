#pragma once
#include <string>
#include <string_view>
#include <utility>

#include "core/base/result.h"

namespace underact::serve {

/// The token of a service, in its file.
struct Token {
  std::string text;
  std::string file;
  bool is_made = false;  // by this program, which removes the file at its end
};

/// Removes the token's file at the end, if this program made it.
class MadeToken {
 public:
  explicit MadeToken(Token token) : token_(std::move(token)) {}
  ~MadeToken();
  MadeToken(const MadeToken&) = delete;
  MadeToken& operator=(const MadeToken&) = delete;
  const Token& token() const { return token_; }

 private:
  Token token_;
};

/// 64 hexadecimal digits that nobody can guess.
std::string newToken();

/// What only who knows the token can say of a nonce: its HMAC-SHA-256 under the token, as hexadecimal digits.
std::string proofOf(std::string_view token, std::string_view nonce);

/// With a file: the token in it, or, where it does not exist, a new one. Without: a new one in the user's runtime
/// folder, in a file named by the port; one that an earlier service has left is replaced. Problems: others than its
/// owner may read the file; it holds no token of 16 to 200 letters, digits and signs; it cannot be read or made.
Result<Token> tokenFor(const std::string& file, int port);

/// The folder of a user's short-lived files: Underact in $XDG_RUNTIME_DIR, else below ~/.cache. Empty: there is no home
/// folder either.
std::string runtimeFolder();

/// Where the window keeps recordings, too: Underact/sessions in the user's documents folder (XDG user directories).
/// Empty: there is no home folder.
std::string sessionsFolder();

}  // namespace underact::serve
