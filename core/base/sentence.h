#pragma once
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace underact {

/// English text for a user, a std::string like any, that also knows the pattern it was made from, so that a window can
/// say it in its language. Text that is taken apart or put together as a string is plain again, and stays English.
class Sentence : public std::string {
 public:
  Sentence() = default;
  /// What is the same in every language: a name, a key, a number as it stands in a file, words of the system.
  Sentence(std::string text) : std::string(std::move(text)) {}
  Sentence(const char* text) : std::string(text) {}

  /// The pattern, marked for translators in the context "problem", with places %1 to %9; empty: plain text.
  const std::string& pattern() const { return pattern_; }
  /// The words for %1, %2 and so on in pattern(); empty for plain text.
  const std::vector<Sentence>& places() const { return places_; }
  /// A number of the program's, not of a file: a window writes it as its language does.
  bool isNumber() const { return is_number_; }

  friend Sentence said(std::string pattern, std::vector<Sentence> places);
  friend Sentence shownNumber(std::string digits);

 private:
  std::string pattern_ = {};
  std::vector<Sentence> places_ = {};
  bool is_number_ = false;
};

/// The pattern with its places filled: said(TRANSLATE_NOOP("problem", "%1 is not known."), {name}).
Sentence said(std::string pattern, std::vector<Sentence> places = {});

/// A number that was measured or computed, from its digits with a point.
Sentence shownNumber(std::string digits);
/// With so many decimals, never -0.0; "–" where it is not finite.
Sentence shownNumber(double value, int decimals);

/// Several, a gap between two; empty ones are left out.
Sentence oneAfterAnother(const std::vector<Sentence>& sentences);

/// %1, %2 and so on in the pattern replaced by the words; a place without a word stays. No place in a word is filled.
std::string filled(std::string_view pattern, const std::vector<std::string>& words);

}  // namespace underact
