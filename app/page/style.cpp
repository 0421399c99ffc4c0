#include "app/page/style.h"

#include <array>
#include <utility>

namespace underact::page {

Colours lightColours() {
  return {"#1b1c1e", "#63646a", "#d0d0d0", "#ffffff", "#f0f0ee", "#0072b2", "#a94b08"};
}

Colours darkColours() {
  return {"#f2f2ee", "#aeafae", "#484a4c", "#1e1f22", "#2c2d30", "#56b4e9", "#e58a50"};
}

std::string pageStyle(const Colours& colours) {
  std::string sheet = R"(
a { color: %link; }
h1, h2, h3 { color: %ink; }
pre.code { background-color: %soft; white-space: pre-wrap; }
code { background-color: %soft; }
code.wrong { color: %wrong; }
blockquote { color: %quiet; }
table.facts { border-collapse: collapse; }
table.facts th { border-bottom: 1px solid %quiet; }
table.facts td { border-bottom: 1px solid %line; }
table.formula { margin-top: 6px; margin-bottom: 6px; }
td.math { vertical-align: middle; white-space: nowrap; }
td.over { border-bottom: 1px solid %ink; padding-left: 3px; padding-right: 3px; }
td.under { padding-left: 3px; padding-right: 3px; }
td.roof { border-top: 1px solid %ink; vertical-align: middle; }
td.entry { padding-left: 6px; padding-right: 6px; }
td.open { border-left: 1px solid %ink; border-top: 1px solid %ink; border-bottom: 1px solid %ink; }
td.close { border-right: 1px solid %ink; border-top: 1px solid %ink; border-bottom: 1px solid %ink; }
td.bar { border-left: 1px solid %ink; }
span.tall { font-size: xx-large; }
)";
  for (const auto& [name, value] :
       std::array<std::pair<const char*, const std::string&>, 7>{{{"%ink", colours.ink},
                                                                  {"%quiet", colours.quiet},
                                                                  {"%line", colours.line},
                                                                  {"%ground", colours.ground},
                                                                  {"%soft", colours.soft},
                                                                  {"%link", colours.link},
                                                                  {"%wrong", colours.wrong}}}) {
    const std::string word = name;
    for (std::size_t at = sheet.find(word); at != std::string::npos; at = sheet.find(word, at + value.size()))
      sheet.replace(at, word.size(), value);
  }
  return sheet;
}

}  // namespace underact::page
