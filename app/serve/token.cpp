#include "app/serve/token.h"

#include <sodium/crypto_auth_hmacsha256.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <sstream>

#include "core/json/text.h"
#include "core/system/file.h"
#include "core/system/private_file.h"

namespace underact::serve {
namespace {

constexpr std::size_t kShortestToken = 16, kLongestToken = 200;
constexpr unsigned kOthersRights = 077;
constexpr char kHexDigits[] = "0123456789abcdef";

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

Problems tokenProblem(const std::string& file, const std::string& sentence) {
  return {{sentence, {file}}};
}

Result<Token> readToken(const std::string& file) {
  const std::optional<system::Status> there = system::statusOf(file);
  if (!there || !there->is_trusted || (there->rights & kOthersRights) != 0U)
    return tokenProblem(file,
                        "Others may read this file, so its token is no secret. Set its rights with \"chmod 600\".");
  Result<std::string> text = json::readTextFile(file, "a token", 4096);
  if (!text) return text.problems();
  std::string token = std::move(text).value();
  while (!token.empty() && (token.back() == '\n' || token.back() == '\r')) token.pop_back();
  const bool is_plain = std::all_of(token.begin(), token.end(), [](char one) { return one > ' ' && one < 127; });
  if (!is_plain || token.size() < kShortestToken || token.size() > kLongestToken)
    return tokenProblem(file,
                        "A token has 16 to 200 letters, digits and signs on one line. Remove the file: a new token "
                        "is made then.");
  return Token{token, file, false};
}

Result<Token> makeToken(const std::string& file, system::Existing existing) {
  Token token{newToken(), file, true};
  const system::Descriptor made = system::makeNew(file, existing);
  const std::string line = token.text + "\n";
  if (made.number() < 0 || system::writeAll(made.number(), std::as_bytes(std::span(line))) != 0)
    return tokenProblem(file, "The token's file cannot be written. Name another one with --token-file.");
  return token;
}

}  // namespace

MadeToken::~MadeToken() {
  if (token_.is_made) std::remove(token_.file.c_str());
}

std::string newToken() {
  std::random_device random;  // of the system, as for keys
  std::string token;
  for (int word = 0; word < 8; ++word) {
    const std::uint32_t bits = random();
    for (unsigned shift = 0; shift < 32; shift += 4) token += kHexDigits[(bits >> shift) & 15U];
  }
  return token;
}

std::string proofOf(std::string_view token, std::string_view nonce) {
  const auto bytesOf = [](std::string_view text) { return reinterpret_cast<const unsigned char*>(text.data()); };
  crypto_auth_hmacsha256_state state;
  crypto_auth_hmacsha256_init(&state, bytesOf(token), token.size());
  crypto_auth_hmacsha256_update(&state, bytesOf(nonce), nonce.size());
  std::array<unsigned char, crypto_auth_hmacsha256_BYTES> proof{};
  crypto_auth_hmacsha256_final(&state, proof.data());
  std::string text;
  for (const unsigned char byte : proof) text += {kHexDigits[byte >> 4U], kHexDigits[byte & 15U]};
  return text;
}

Result<Token> tokenFor(const std::string& file, int port) {
  if (!file.empty()) {
    if (system::statusOf(file, system::Links::Refuse)) return readToken(file);
    return makeToken(file, system::Existing::Refuse);
  }
  const std::string folder = runtimeFolder();
  if (folder.empty() || system::makePrivateFolder(folder) != 0)
    return tokenProblem(folder, "There is no runtime folder for the token. Name a file with --token-file.");
  return makeToken(folder + "/serve-" + std::to_string(port) + ".token", system::Existing::Replace);
}

std::string runtimeFolder() {
  const std::string runtime = variable("XDG_RUNTIME_DIR"), home = variable("HOME");
  if (runtime.starts_with('/')) return runtime + "/underact";
  return home.starts_with('/') ? home + "/.cache/underact/runtime" : "";
}

std::string sessionsFolder() {
  const std::string home = variable("HOME");
  if (!home.starts_with('/')) return {};
  std::string documents = home + "/Documents";
  const std::string config = variable("XDG_CONFIG_HOME");
  const Result<std::string> dirs = json::readTextFile(
      (config.starts_with('/') ? config : home + "/.config") + "/user-dirs.dirs", "the user's folders", 1U << 16U);
  std::istringstream lines(dirs ? dirs.value() : "");
  const std::string key = "XDG_DOCUMENTS_DIR=\"";
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(key) || line.back() != '"') continue;
    std::string path = line.substr(key.size(), line.size() - key.size() - 1);
    if (path.starts_with("$HOME/")) path = home + path.substr(5);
    if (path.starts_with('/')) documents = path;
  }
  return documents + "/Underact/sessions";
}

}  // namespace underact::serve
