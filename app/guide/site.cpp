#include "app/guide/site.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

#include "app/page/html.h"
#include "app/page/style.h"
#include "core/json/json.h"
#include "core/json/text.h"

namespace underact::guide {
namespace {

namespace fs = std::filesystem;
using page::escaped;

bool startsWith(const std::string& text, std::string_view start) {
  return text.compare(0, start.size(), start) == 0;
}

std::string contents(const Guide& guide, const std::string& here) {
  std::string made =
      "<nav aria-label=\"Contents\">\n<p class=\"name\"><a href=\"index.html\">Underact</a></p>\n"
      // Useless without the script, which shows it.
      "<input id=\"search\" type=\"search\" placeholder=\"Search\" aria-label=\"Search the guide\" hidden>\n"
      "<ol id=\"hits\" hidden></ol>\n<div id=\"contents\">\n";
  for (const Chapter& chapter : guide.chapters) {
    made += "<h2>" + escaped(chapter.title) + "</h2>\n<ul>\n";
    for (const std::string& name : chapter.pages) {
      const Entry* entry = guide.find(name);
      if (entry == nullptr) continue;
      made += name == here ? "<li class=\"here\">" : "<li>";
      made += "<a href=\"" + name + ".html\"" + (name == here ? " aria-current=\"page\"" : "") + ">" +
              escaped(entry->page.title) + "</a></li>\n";
    }
    made += "</ul>\n";
  }
  return made + "</div>\n</nav>\n";
}

/// The words of all sections, for the search of the pages.
std::string searchIndex(const Guide& guide) {
  std::string made = "var guideIndex = [\n";
  for (const Entry& entry : guide.entries) {
    for (const page::Page::Section& section : entry.page.sections) {
      if (section.title.empty() && section.text.empty()) continue;
      std::string text = section.text;
      for (char& letter : text) letter = letter == '\n' ? ' ' : letter;
      made += "[" + json::quotedText(entry.name) + "," + json::quotedText(entry.page.title) + "," +
              json::quotedText(section.anchor) + "," + json::quotedText(section.title) + "," + json::quotedText(text) +
              "],\n";
    }
  }
  return made + "];\n";
}

std::string sheetOf(const page::Colours& colours) {
  return "body { color: " + colours.ink + "; background-color: " + colours.ground + "; }\n" + page::pageStyle(colours);
}

std::string styleSheet() {
  return ":root { color-scheme: light dark; }\n" + sheetOf(page::lightColours()) +
         "@media (prefers-color-scheme: dark) {\n" + sheetOf(page::darkColours()) + "}\n";
}

class Writer {
 public:
  explicit Writer(std::string out) : out_(std::move(out)) {
    std::error_code error;
    fs::create_directories(out_, error);
    if (error) refuse("This folder could not be created: " + error.message() + ".", out_);
  }
  void write(const std::string& name, const std::string& text) {
    const fs::path path = fs::path(out_) / name;
    std::ofstream file(path, std::ios::binary);
    file << text << std::flush;
    if (!file) refuse("This file could not be written.", path.string());
  }
  void copy(const fs::path& from, const std::string& to) {
    std::error_code error;
    const fs::path path = fs::path(out_) / to;
    fs::create_directories(path.parent_path(), error);
    fs::copy_file(from, path, fs::copy_options::overwrite_existing, error);
    if (error) refuse("This picture could not be copied: " + error.message() + ".", from.string());
  }
  void refuse(std::string sentence, std::string file) { problems_.push_back({std::move(sentence), {std::move(file)}}); }
  Problems take() { return std::move(problems_); }

 private:
  std::string out_;
  Problems problems_;
};

}  // namespace

std::string siteLink(const std::string& link) {
  constexpr std::string_view kPictures = "../pictures/";
  if (startsWith(link, kPictures)) return "pictures/" + link.substr(kPictures.size());
  if (startsWith(link, "scene:")) return "scene_list.html#" + link.substr(6);
  if (startsWith(link, "lesson:")) return "lessons.html";
  if (startsWith(link, "action:")) return "window.html";
  const Target target = targetOf(link);
  if (!target.is_page) return link;
  return (target.page.empty() ? "" : target.page + ".html") + (target.anchor.empty() ? "" : "#" + target.anchor);
}

std::string sitePage(const Guide& guide, const Entry& entry) {
  const page::Page made = page::readPage(entry.markdown, entry.name, siteLink);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(made.title) +
         " – Underact</title>\n<link rel=\"stylesheet\" href=\"style.css\">\n"
         "<link rel=\"stylesheet\" href=\"site.css\">\n</head>\n<body class=\"" +
         entry.name + "\">\n" + contents(guide, entry.name) + "<main>\n" + made.html +
         "</main>\n<script src=\"search_index.js\"></script>\n<script src=\"search.js\"></script>\n</body>\n</html>\n";
}

Problems writeSite(const Guide& guide, const std::string& out) {
  Writer writer(out);
  std::set<std::string> pictures;
  for (const Entry& entry : guide.entries) {
    writer.write(entry.name + ".html", sitePage(guide, entry));
    for (const Problem& problem : entry.page.problems) writer.refuse(problem.sentence, problem.place.file);
    for (const page::Page::Link& link : entry.page.links) {
      if (link.is_picture) pictures.insert(link.to);
    }
  }
  if (!guide.entries.empty()) writer.write("index.html", sitePage(guide, guide.entries.front()));
  for (const std::string& picture : pictures) writer.copy(fs::path(guide.folder) / picture, siteLink(picture));
  writer.write("style.css", styleSheet());
  writer.write("search_index.js", searchIndex(guide));
  for (const char* name : {"site.css", "search.js"}) {
    const Result<std::string> text = json::readTextFile(guide.folder + "/site/" + name, "a part of the static pages");
    text ? writer.write(name, text.value()) : writer.refuse(text.problems().front().sentence, name);
  }
  return writer.take();
}

}  // namespace underact::guide
