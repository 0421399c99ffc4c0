#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

#include "app/guide/site.h"
#include "app/page/html.h"

namespace underact::guide {
namespace {

using page::escaped;

constexpr std::string_view kPictures = "../pictures/";

std::string linkTo(const Entry& entry, const std::string& attributes, const std::string& before = {}) {
  return "<a href=\"" + entry.name + ".html\"" + attributes + ">" + before + escaped(entry.page.title) + "</a>";
}

/// The name, the search and the contents. Without the script the search would do nothing: the script shows it. The
/// script folds the contents up where the window is narrow.
std::string navigation(const Guide& guide, const std::string& here) {
  std::string made =
      "<nav class=\"guide\" aria-label=\"Guide\">\n<p class=\"name\"><a href=\"index.html\">Underact</a></p>\n"
      "<div id=\"find\" role=\"search\" hidden>\n"
      "<input id=\"search\" type=\"search\" placeholder=\"Search\" aria-label=\"Search the guide\" "
      "aria-keyshortcuts=\"/\" title=\"Press / to search\" autocomplete=\"off\">\n"
      "<p id=\"found\" role=\"status\"></p>\n<ol id=\"hits\" aria-label=\"Search results\" hidden></ol>\n</div>\n"
      "<details id=\"contents\" open>\n<summary>Contents</summary>\n";
  for (const Chapter& chapter : guide.chapters) {
    made += "<h2>" + escaped(chapter.title) + "</h2>\n<ul>\n";
    for (const std::string& name : chapter.pages) {
      const Entry* entry = guide.find(name);
      if (entry == nullptr) continue;
      const bool is_here = name == here;
      made += (is_here ? "<li class=\"here\">" : "<li>") + linkTo(*entry, is_here ? " aria-current=\"page\"" : "") +
              "</li>\n";
    }
    made += "</ul>\n";
  }
  return made + "</details>\n</nav>\n";
}

/// Where one who has read the page goes on, in the order of the contents.
std::string turning(const Guide& guide, const std::string& here) {
  const auto at =
      std::find_if(guide.entries.begin(), guide.entries.end(), [&](const Entry& entry) { return entry.name == here; });
  std::string made = "<nav class=\"turn\" aria-label=\"Neighbouring pages\">\n";
  if (at != guide.entries.begin()) made += linkTo(*(at - 1), " rel=\"prev\"", "Previous: ") + "\n";
  if (at + 1 < guide.entries.end()) made += linkTo(*(at + 1), " rel=\"next\"", "Next: ") + "\n";
  return made + "</nav>\n";
}

/// Tables lie in a part that scrolls by itself where the window is narrower.
void wrapTables(std::string& html) {
  const auto replaceAll = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = html.find(from); at != std::string::npos; at = html.find(from, at + to.size()))
      html.replace(at, from.size(), to);
  };
  const std::string begin = "<table class=\"facts\"", end = "</tbody>\n</table>\n";  // a formula's has no tbody
  replaceAll(begin, "<div class=\"wide\">" + begin);
  replaceAll(end, end + "</div>\n");
}

/// Long names in code may go on in the next line behind their signs: on paper nothing scrolls.
void breakNames(std::string& html) {
  constexpr std::size_t kLong = 13;
  const std::string begin = "<code>", chance = "<wbr>";
  for (std::size_t at = html.find(begin); at != std::string::npos; at = html.find(begin, at)) {
    at += begin.size();
    const std::string name = html.substr(at, html.find("</code>", at) - at);
    std::string made;
    for (std::size_t i = 0, word = 0; i < name.size(); ++i) {
      made += name[i];
      if (name[i] == ' ') word = i + 1;
      const bool is_long = std::min(name.find(' ', word), name.size()) - word >= kLong;
      const bool goes_on = i + 1 < name.size() && std::isalnum(static_cast<unsigned char>(name[i + 1])) != 0;
      if (is_long && goes_on && std::string_view("_/.:,=").find(name[i]) != std::string_view::npos) made += chance;
    }
    html.replace(at, name.size(), made);
    at += made.size();
  }
}

/// Pictures that have a dark one beside them are followed by it; the style sheet shows one of the two. <picture> would
/// print the dark one where the screen is dark: a browser fetches nothing more when it prints.
void addDarkPictures(const Guide& guide, std::string& html) {
  const std::string begin = "<img src=\"";
  for (std::size_t at = html.find(begin); at != std::string::npos; at = html.find(begin, at + 1)) {
    const std::size_t name = at + begin.size();
    const std::size_t name_end = html.find('"', name), end = html.find('>', name_end) + 1;
    const std::string dark = darkPicture(guide, "../" + html.substr(name, name_end - name));
    if (dark.empty()) continue;
    const std::string rest = html.substr(name_end, end - name_end);
    const std::string both = "<img class=\"light\" src=\"" + html.substr(name, end - name) +
                             "<img class=\"dark\" src=\"" + escaped(siteLink(dark)) + rest;
    html.replace(at, end - at, both);
    at += both.size() - 1;
  }
}

}  // namespace

std::string darkPicture(const Guide& guide, const std::string& picture) {
  const std::size_t dot = picture.rfind('.');
  if (!picture.starts_with(kPictures) || dot == std::string::npos) return {};
  constexpr std::string_view kLight = "_light";
  std::string stem = picture.substr(0, dot);
  if (stem.ends_with(kLight)) stem.resize(stem.size() - kLight.size());
  const std::string dark = stem + "_dark" + picture.substr(dot);
  std::error_code error;
  return std::filesystem::is_regular_file(std::filesystem::path(guide.folder) / dark, error) ? dark : "";
}

std::string siteLink(const std::string& link) {
  if (link.starts_with(kPictures)) return "pictures/" + link.substr(kPictures.size());
  if (link.starts_with("scene:")) return "scene_list.html#" + link.substr(6);
  if (link.starts_with("lesson:")) return "lessons.html";
  if (link.starts_with("action:")) return "window.html";
  const Target target = targetOf(link);
  if (!target.is_page) return link;
  return (target.page.empty() ? "" : target.page + ".html") + (target.anchor.empty() ? "" : "#" + target.anchor);
}

std::string sitePage(const Guide& guide, const Entry& entry) {
  page::Page made = page::readPage(entry.markdown, entry.name, siteLink);
  wrapTables(made.html);
  breakNames(made.html);
  addDarkPictures(guide, made.html);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
         escaped(made.title) +
         " – Underact</title>\n<link rel=\"stylesheet\" href=\"style.css\">\n"
         "<link rel=\"stylesheet\" href=\"site.css\">\n</head>\n<body class=\"" +
         entry.name + "\">\n<a class=\"skip\" href=\"#page\">Skip to the page</a>\n" + navigation(guide, entry.name) +
         "<main id=\"page\" tabindex=\"-1\">\n" + made.html + turning(guide, entry.name) +
         "</main>\n<script src=\"search_index.js\"></script>\n<script src=\"search.js\"></script>\n</body>\n</html>\n";
}

}  // namespace underact::guide
