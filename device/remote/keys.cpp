#include "device/remote/keys.h"

#include <zmq.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <sstream>

#include "core/base/translate.h"
#include "core/system/file.h"
#include "core/system/named_file.h"
#include "core/system/private_file.h"

namespace underact::device::remote {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kKeyCharacters = 40, kKeyBytes = 32;
constexpr std::size_t kMaxBytes = std::size_t{1} << 20;  // of a key file

Problems problemAt(Sentence sentence, const fs::path& file) {
  return {{std::move(sentence), {file.string()}}};
}

fs::path usersFolder() {
  if (const char* const folder = std::getenv("UNDERACT_KEYS"); folder != nullptr && *folder != '\0') return folder;
  if (const char* const config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && *config != '\0')
    return fs::path(config) / "Underact";
  const char* const home = std::getenv("HOME");
  return fs::path(home != nullptr ? home : "/") / ".config" / "Underact";
}

/// Why a key file is not to be trusted: others may read or write it, or it belongs to another user. what_to_do: besides
/// chmod.
Problems notOursAlone(const system::Status& status, const Sentence& may, const Sentence& what_to_do,
                      const fs::path& file) {
  if (!status.is_trusted)
    return problemAt(phrase(TRANSLATE_NOOP("problem",
                                           "This key file belongs to another user of this computer, so it is not used. "
                                           "Delete it, and find out who put it there.")),
                     file);
  if ((status.rights & 077U) == 0) return {};
  return problemAt(phrase(TRANSLATE_NOOP("problem", "%1 Run chmod 600 '%2' and, if somebody may have done so, %3."),
                          {may, file.string(), what_to_do}),
                   file);
}

/// A key file: its name, what others could do with it, and what to do about it.
struct KeyFile {
  const char *name, *may, *what_to_do;
};
constexpr KeyFile kOwn{"arm_key", TRANSLATE_NOOP("problem", "Others may read your secret key."),
                       TRANSLATE_NOOP("problem", "underact-cli share-arm --new-key")};
constexpr KeyFile kClients{"arm_clients", TRANSLATE_NOOP("problem", "Others may read or change who may use your arm."),
                           TRANSLATE_NOOP("problem", "delete each line in it that you do not know")};
constexpr KeyFile kHosts{"arm_hosts", TRANSLATE_NOOP("problem", "Others may read or change which arms you trust."),
                         TRANSLATE_NOOP("problem", "delete each line in it that you do not know")};

/// Its lines; none: there is no such file. Problems: it cannot be read, or others may read it.
Result<std::optional<std::vector<std::string>>> linesOf(const fs::path& folder, const KeyFile& which) {
  const fs::path path = folder / which.name;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return std::optional<std::vector<std::string>>{};
  const Result<system::NamedFile> file =
      system::NamedFile::open(path.string(), phrase(TRANSLATE_NOOP("problem", "a key")));
  if (!file) return file.problems();
  const std::optional<system::Status> status = system::statusOf(file.value().descriptor());
  if (!status) return problemAt(phrase(TRANSLATE_NOOP("problem", "The key file cannot be read.")), path);
  Problems problems = notOursAlone(*status, phrase(which.may), phrase(which.what_to_do), path);
  if (!problems.empty()) return problems;
  const Result<std::string> text = file.value().readAll(kMaxBytes);
  if (!text) return text.problems();
  std::vector<std::string> lines;
  std::istringstream stream(text.value());
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(line);
  }
  return std::optional(std::move(lines));
}

/// Writes the whole file or, if that fails, leaves the old one; nobody else may read it.
Problems writeFile(const fs::path& file, const std::string& text) {
  system::makePrivateFolder(file.parent_path().string());
  const fs::path part = file.string() + ".part";
  const int reason = system::putInPlace(system::makeNew(part.string(), system::Existing::Replace), part.string(),
                                        file.string(), text, system::Lasting::Written);
  if (reason == 0) return {};
  return problemAt(phrase(TRANSLATE_NOOP("problem", "The key file cannot be written: %1."), {std::strerror(reason)}),
                   file);
}

/// The first two words of a line; the rest is for people.
std::pair<std::string, std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  std::pair<std::string, std::string> words;
  stream >> words.first >> words.second;
  return words;
}

Problems noKey(const std::string& text) {
  return {{phrase(TRANSLATE_NOOP(
                      "problem",
                      "\"%1\" is not a key. A key has 40 characters; \"underact-cli share-arm --show-key\" prints "
                      "it. Put it in single quotes, since some of its characters have a meaning in a shell."),
                  {text.substr(0, kKeyCharacters + 1)}),
           {}}};
}

}  // namespace

bool isKey(std::string_view text) {
  std::array<std::uint8_t, kKeyBytes> bytes{};
  static constexpr std::string_view kDigits =
      "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.-:+=^!/*?&<>()[]{}@%$#";  // ZeroMQ RFC 32
  if (text.size() != kKeyCharacters || text.find_first_not_of(kDigits) != std::string_view::npos) return false;
  return zmq_z85_decode(bytes.data(), std::string(text).c_str()) != nullptr;
}

KeyFolder::KeyFolder() : folder_(usersFolder()) {}

Result<KeyPair> KeyFolder::makeNew() const {
  std::array<char, kKeyCharacters + 1> public_key{}, secret_key{};
  if (zmq_curve_keypair(public_key.data(), secret_key.data()) != 0)
    return Problems{
        {phrase(TRANSLATE_NOOP(
             "problem", "The ZeroMQ library of this computer was built without CURVE, so no arm can be shared.")),
         {}}};
  const KeyPair pair{public_key.data(), secret_key.data()};
  const Problems problems = writeFile(folder_ / kOwn.name, pair.public_key + "\n" + pair.secret_key + "\n");
  if (!problems.empty()) return problems;
  return pair;
}

bool KeyFolder::hasOwn() const {
  std::error_code ignored;
  return fs::exists(folder_ / kOwn.name, ignored);
}

Result<KeyPair> KeyFolder::own() const {
  const fs::path file = folder_ / kOwn.name;
  Result<std::optional<std::vector<std::string>>> lines = linesOf(folder_, kOwn);
  if (!lines) return lines.problems();
  if (!lines.value()) return makeNew();
  const std::vector<std::string>& text = *lines.value();
  if (text.size() < 2 || !isKey(text[0]) || !isKey(text[1]))
    return problemAt(
        phrase(TRANSLATE_NOOP(
            "problem", "This is not a key pair. \"underact-cli share-arm --new-key\" makes a new one in its place.")),
        file);
  return KeyPair{text[0], text[1]};
}

Result<std::vector<std::string>> KeyFolder::clients() const {
  const fs::path file = folder_ / kClients.name;
  Result<std::optional<std::vector<std::string>>> lines = linesOf(folder_, kClients);
  if (!lines) return lines.problems();
  std::vector<std::string> keys;
  Problems problems;
  int number = 0;
  for (const std::string& line : lines.value().value_or(std::vector<std::string>{})) {
    ++number;
    const std::string key = wordsOf(line).first;
    if (key.empty()) continue;
    if (isKey(key)) {
      keys.push_back(key);
    } else {
      problems.push_back({phrase(TRANSLATE_NOOP("problem", "A line must begin with a key of 40 characters.")),
                          {file.string(), number}});
    }
  }
  if (!problems.empty()) return problems;
  return keys;
}

Problems KeyFolder::allow(const std::string& key, const std::string& words) const {
  if (!isKey(key)) return noKey(key);
  const fs::path file = folder_ / kClients.name;
  Result<std::optional<std::vector<std::string>>> lines = linesOf(folder_, kClients);
  if (!lines) return lines.problems();
  std::string text;
  for (const std::string& line : lines.value().value_or(std::vector<std::string>{})) {
    if (wordsOf(line).first == key) return {};
    text += line + "\n";
  }
  return writeFile(file, text + key + (words.empty() ? "" : " " + words) + "\n");
}

Result<std::string> KeyFolder::keyOf(const Address& address) const {
  const fs::path file = folder_ / kHosts.name;
  Result<std::optional<std::vector<std::string>>> lines = linesOf(folder_, kHosts);
  if (!lines) return lines.problems();
  for (const std::string& line : lines.value().value_or(std::vector<std::string>{})) {
    const auto [host, key] = wordsOf(line);
    if (host != address.text()) continue;
    if (!isKey(key))
      return problemAt(phrase(TRANSLATE_NOOP("problem", "The key of %1 in this file is not valid."), {host}), file);
    return key;
  }
  if (!address.isThisMachine()) return std::string();
  Result<KeyPair> pair = own();
  if (!pair) return pair.problems();
  return pair.value().public_key;
}

Problems KeyFolder::trust(const Address& address, const std::string& key) const {
  if (!isKey(key)) return noKey(key);
  const fs::path file = folder_ / kHosts.name;
  Result<std::optional<std::vector<std::string>>> lines = linesOf(folder_, kHosts);
  if (!lines) return lines.problems();
  std::string text;
  for (const std::string& line : lines.value().value_or(std::vector<std::string>{})) {
    if (wordsOf(line).first != address.text()) text += line + "\n";
  }
  return writeFile(file, text + address.text() + " " + key + "\n");
}

}  // namespace underact::device::remote
