#pragma once
#include <string>

namespace underact::page {

/// Colours of a page, "#1B1C1E".
struct Colours {
  std::string ink, quiet, line, ground, soft, link, wrong;
};

/// The window's own, for pages that are read elsewhere.
Colours lightColours();
Colours darkColours();

/// The style sheet of what readPage() makes, in the part of CSS that browsers and Qt's rich text share.
std::string pageStyle(const Colours& colours);

}  // namespace underact::page
