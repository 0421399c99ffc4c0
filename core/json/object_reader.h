#pragma once
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/json/json.h"
#include "core/json/text.h"
#include "core/json/words.h"

namespace underact::json {

/// Collects the problems of a file, and remembers where each of its values stands.
class Findings {
 public:
  /// file: its name, for the places of the problems.
  explicit Findings(std::string file) : file_(std::move(file)) {}
  /// A problem at a value, or at a line and column; key: the path of the value. Only counted where full().
  void add(const Value& value, const std::string& key, Sentence sentence);
  void add(std::pair<int, int> line_column, const std::string& key, Sentence sentence);
  /// Where the value of a key stands, for problems that are found later.
  void remember(const std::string& key, const Value& value) { places_[key] = {value.line, value.column}; }
  /// Adds the problems that check() found in the scene, each at the place of its key.
  void add(const Problems& problems);
  /// So many are kept already that further ones are only counted.
  bool full() const;
  /// The known word nearest to `word`, as nearestWord(); looked for only ten times in a file, and empty from then on.
  std::string nearest(std::string_view word, const std::vector<std::string>& known);
  /// All, in the order of the file; of very many, the first found.
  Problems take();
  const std::string& file() const { return file_; }

 private:
  std::string file_;
  Problems problems_;
  std::size_t more_ = 0;
  std::size_t looked_ = 0;  // for a nearest word
  std::map<std::string, std::pair<int, int>> places_;
};

/// An object of the file, read key by key; finish() reports the keys that nothing asked for.
class ObjectReader {
 public:
  /// what: for sentences, as "a sphere".
  ObjectReader(const Value& object, std::string path, Sentence what, Findings& findings);
  /// The value of a key, or null; of a required one, null is a problem.
  const Value* find(const char* key, bool required = false);
  /// Marks a key that is not allowed here, with the reason why.
  void refuse(const std::string& key, Sentence sentence) { refused_[key] = std::move(sentence); }
  /// Marks keys of the scene reference that this version does not support.
  void refuseLater(const std::vector<std::string>& keys);
  /// Reports duplicate, refused and unknown keys. all_known false: not the unknown ones (of a type that is itself
  /// unknown).
  void finish(bool all_known = true);
  /// Replaces the words for the object in sentences, once its type is known.
  void setWhat(Sentence what) { what_ = std::move(what); }
  /// The path of one of its keys: "influence.t".
  std::string pathOf(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  Findings& findings() { return findings_; }

 private:
  void judge(std::size_t index, bool all_known);
  const Value& object_;
  std::string path_;
  Sentence what_;
  Findings& findings_;
  std::map<std::string_view, std::size_t> first_of_;  // the index of a key; where it stands twice, of the first
  std::vector<bool> asked_;                           // of each key, whether it was asked for
  std::vector<std::string> known_;
  std::map<std::string, Sentence> refused_;
};

/// "a number", "a list", ...
Sentence kindName(JsonKind kind);

/// The sentence for what the scene reference defines and this version does not support.
Sentence notYet(const std::string& what);

/// False, and a problem, where the value is of another kind. expected: "a number, as in 0.5".
bool isKind(const Value& value, JsonKind kind, const std::string& path, const Sentence& expected, Findings& findings);

/// The problem of a value that is none of the words.
void refuseWord(const Value& value, const std::string& path, const std::vector<std::string>& words, Findings& findings);

/// Reads a number, or a list of them. What cannot be read is a problem, and leaves `into` as it is or, in a list, at 1.
void readNumber(const Value& value, const std::string& path, double& into, Findings& findings);
void readNumber(const Value& value, const std::string& path, Vec3& into, Findings& findings);
void readNumber(const Value& value, const std::string& path, Mat3& into, Findings& findings);
/// A string; a problem, and `into` as it was, where the value is none.
void readText(const Value& value, const std::string& path, std::string& into, Findings& findings);

/// One of the words; false, and a problem, where it is none of them.
template <class Enum, std::size_t kCount>
bool readWord(const Value& value, const std::string& path, const Word<Enum> (&words)[kCount], Enum& into,
              Findings& findings) {
  std::vector<std::string> known;
  for (const Word<Enum>& word : words) {
    known.emplace_back(word.word);
    if (value.kind != JsonKind::String || value.text != word.word) continue;
    into = word.value;
    return true;
  }
  refuseWord(value, path, known, findings);
  return false;
}

}  // namespace underact::json
