#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace underact::page {

/// A page of Markdown, for a window and for a browser.
struct Page {
  struct Heading {
    int level = 1;
    std::string text, anchor;
  };
  struct Link {
    std::string to;  // as it stands in the page, pictures too
    int line = 0;    // 0: not known
    bool is_picture = false;
  };
  /// The text from one heading to the next, without marks, for a search.
  struct Section {
    std::string title, anchor, text;
  };

  std::string title;  // the first heading
  std::string html;   // of the body, without head
  std::vector<Heading> headings;
  std::vector<Link> links;
  std::vector<Section> sections;
  Problems problems;  // formulas that cannot be read; they are shown as written; and `cut`
  Sentence cut;       // why the page ends before its text does; empty: it is whole
};

/// Where a page is cut. parts: elements of HTML; a table in a table counts double, one in that four times, as Qt lays
/// them out: its time grows with the square of `parts`.
struct PageLimits {
  std::size_t bytes = std::size_t{1} << 20, parts = 200'000;
};
/// For a text that comes with a scene or a lesson: the window shows it within 0.1 s, whatever it is.
inline constexpr PageLimits kStrangersPage{std::size_t{16} << 10, 2000};

/// The target of a link in the output; empty: unchanged.
using LinkTo = std::function<std::string(const std::string& to)>;

/// GitHub's Markdown, with $formulas$ and $$formulas$$ of texToHtml() and without HTML of its own.
/// file: for problems. Never fails: beyond the limits, and where it is nested more than 60 deep, the page is cut.
Page readPage(std::string_view markdown, const std::string& file, const LinkTo& link_to = {},
              const PageLimits& limits = {});

}  // namespace underact::page
