#include "app/guide/site.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

#include "app/page/style.h"
#include "core/json/json.h"
#include "core/json/text.h"

namespace underact::guide {
namespace {

namespace fs = std::filesystem;

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

bool isNotebook(const std::string& link) {
  return link.ends_with(".ipynb") && link.find_first_of("/:") == std::string::npos;
}

std::string sheetOf(const page::Colours& colours) {
  return "body { color: " + colours.ink + "; background-color: " + colours.ground + "; }\n" + page::pageStyle(colours);
}

std::string styleSheet() {
  // Paper is light, whatever the screen is.
  return ":root { color-scheme: light dark; }\n@media print { :root { color-scheme: light; } }\n" +
         sheetOf(page::lightColours()) + "@media screen and (prefers-color-scheme: dark) {\n" +
         sheetOf(page::darkColours()) + "}\n";
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
    if (error) refuse("This file could not be copied: " + error.message() + ".", from.string());
  }
  void refuse(std::string sentence, std::string file) { problems_.push_back({std::move(sentence), {std::move(file)}}); }
  Problems take() { return std::move(problems_); }

 private:
  std::string out_;
  Problems problems_;
};

}  // namespace

Problems writeSite(const Guide& guide, const std::string& out) {
  Writer writer(out);
  std::set<std::string> pictures, notebooks;
  for (const Entry& entry : guide.entries) {
    writer.write(entry.name + ".html", sitePage(guide, entry));
    for (const Problem& problem : entry.page.problems) writer.refuse(problem.sentence, problem.place.file);
    for (const page::Page::Link& link : entry.page.links) {
      if (isNotebook(link.to)) notebooks.insert(link.to);
      if (!link.is_picture) continue;
      pictures.insert(link.to);
      if (const std::string dark = darkPicture(guide, link.to); !dark.empty()) pictures.insert(dark);
    }
  }
  if (!guide.entries.empty()) writer.write("index.html", sitePage(guide, guide.entries.front()));
  for (const std::string& picture : pictures) writer.copy(fs::path(guide.folder) / picture, siteLink(picture));
  for (const std::string& notebook : notebooks) writer.copy(fs::path(guide.folder) / notebook, notebook);
  writer.write("style.css", styleSheet());
  writer.write("search_index.js", searchIndex(guide));
  for (const char* name : {"site.css", "search.js"}) {
    const Result<std::string> text = json::readTextFile(guide.folder + "/site/" + name, "a part of the static pages");
    text ? writer.write(name, text.value()) : writer.refuse(text.problems().front().sentence, name);
  }
  return writer.take();
}

}  // namespace underact::guide
