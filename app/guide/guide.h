#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "app/page/page.h"
#include "core/base/result.h"

namespace underact::guide {

/// One page: resources/guide/NAME.md.
struct Entry {
  std::string name;
  std::string markdown;
  page::Page page;
};

struct Chapter {
  std::string title;
  std::vector<std::string> pages;  // names, in the order of reading
};

/// The user's guide, as the window shows it and as static pages are generated from it.
struct Guide {
  std::string folder;
  std::vector<Chapter> chapters;
  std::vector<Entry> entries;  // in the order of the chapters

  /// Null: there is no such page.
  const Entry* find(std::string_view name) const;
};

/// Reads contents.json of the folder and every page it names. Problems: what is wrong with contents.json (each page
/// once), and pages that cannot be read. What is wrong inside a page stays with it.
Result<Guide> readGuide(const std::string& folder);

/// Where a link of a page leads to: page and heading, both may be empty ("#stop": the page itself). To other things
/// than pages of the guide ("scene:02_sphere", "https://..."): is_page is false.
struct Target {
  bool is_page = false;
  std::string page, anchor;
};
Target targetOf(std::string_view link);

}  // namespace underact::guide
