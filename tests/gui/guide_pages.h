#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "app/gui/window/features.h"
#include "app/guide/guide.h"
#include "core/system/resource_paths.h"

namespace underact::gui::test {

/// The guide's pages for all parts of the window.
inline const std::vector<HelpPage>& allPages() {
  static const std::vector<HelpPage> kAll = helpPages(features());
  return kAll;
}

inline const guide::Guide& theGuide() {
  static const Result<guide::Guide> kGuide = guide::readGuide(system::findResource(system::Resource::Guide).value());
  return kGuide.value();
}

/// The guide has a page, and a heading on it, of that name: "PAGE#heading".
inline bool isPlace(const QString& place) {
  const guide::Entry* entry = theGuide().find(place.section('#', 0, 0).toStdString());
  if (entry == nullptr) return false;
  const std::string anchor = place.section('#', 1).toStdString();
  return anchor.empty() || std::any_of(entry->page.headings.begin(), entry->page.headings.end(),
                                       [&](const page::Page::Heading& heading) { return heading.anchor == anchor; });
}

}  // namespace underact::gui::test
