#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "app/guide/guide.h"

namespace underact::guide {

/// A section that has all the words.
struct Hit {
  std::string page, page_title;
  std::string anchor, title;  // of the section
  std::string excerpt;        // around the first word that stands in its text; empty: in titles alone
  int score = 0;
};

/// The words of what somebody types, in small letters.
std::vector<std::string> searchWords(std::string_view typed);

/// Looks through all sections of all pages.
class Search {
 public:
  explicit Search(const Guide& guide);

  /// Sections that have each of the words, or one that begins with it: the best first, then in the order of the guide.
  /// A word in a title counts most, a whole one more than a beginning. Nothing typed: nothing found.
  std::vector<Hit> find(std::string_view typed, std::size_t max = 60) const;

 private:
  struct Section {
    Hit hit;
    std::string text;                             // as it is
    std::vector<std::string> title_words, words;  // small, sorted words of title and text
    std::vector<std::string> page_words;
  };
  std::vector<Section> sections_;
};

}  // namespace underact::guide
