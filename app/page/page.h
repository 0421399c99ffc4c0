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
  Problems problems;  // formulas that cannot be read; they are shown as written
};

/// The target of a link in the output; empty: unchanged.
using LinkTo = std::function<std::string(const std::string& to)>;

/// GitHub's Markdown, with $formulas$ and $$formulas$$ of texToHtml() and without HTML of its own.
/// file: for problems. Never fails: what is no page (above 1 MiB, nested more than 60 deep) has a problem and what came
/// before it.
Page readPage(std::string_view markdown, const std::string& file, const LinkTo& link_to = {});

}  // namespace underact::page
