#pragma once
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace underact {

/// English text for a user, a std::string that also has the pattern it was made from, so that a window can translate
/// it. Text that is taken apart or concatenated as a string becomes plain, and stays English.
class Sentence : public std::string {
 public:
  Sentence() = default;
  /// Text that is the same in every language: a name, a key, a number of a file, a message of the system.
  Sentence(std::string text) : std::string(std::move(text)) {}
  Sentence(const char* text) : std::string(text) {}

  /// The pattern, marked for translators in the context "problem", with places %1 to %9; empty: plain text.
  const std::string& pattern() const { return pattern_; }
  /// The words for %1, %2 and so on in pattern(); empty for plain text.
  const std::vector<Sentence>& places() const { return places_; }
  /// Whether it is a number computed by the program, which a window writes in the format of its language.
  bool isNumber() const { return is_number_; }

  friend Sentence phrase(std::string pattern, std::vector<Sentence> places);
  friend Sentence shownNumber(std::string digits);

 private:
  std::string pattern_ = {};
  std::vector<Sentence> places_ = {};
  bool is_number_ = false;
};

/// The pattern with its places filled: phrase(TRANSLATE_NOOP("problem", "%1 is not known."), {name}).
Sentence phrase(std::string pattern, std::vector<Sentence> places = {});

/// A number that was measured or computed, from its digits with a point.
Sentence shownNumber(std::string digits);
/// A number with so many decimals, never -0.0; "–" where it is not finite.
Sentence shownNumber(double value, int decimals);

/// The sentences, separated by spaces; empty ones are left out.
Sentence oneAfterAnother(const std::vector<Sentence>& sentences);

/// The pattern with %1, %2 and so on replaced by the words; a placeholder without a word stays. Placeholders within
/// words are not replaced. An English "a" before a word that begins with a vowel becomes "an".
std::string filled(std::string_view pattern, const std::vector<std::string>& words);

}  // namespace underact
