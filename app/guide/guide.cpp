#include "app/guide/guide.h"

#include <algorithm>

#include "core/json/object_reader.h"
#include "core/json/text.h"

namespace underact::guide {
namespace {

std::string checkedText(const json::Value* value, const std::string& path, json::Findings& findings) {
  std::string text;
  if (value != nullptr) json::readText(*value, path, text, findings);
  return text;
}

Chapter readChapter(const json::Value& value, const std::string& path, json::Findings& findings) {
  Chapter chapter;
  if (!json::isKind(value, json::JsonKind::Object, path, "a chapter in {}", findings)) return chapter;
  json::ObjectReader reader(value, path, "a chapter", findings);
  chapter.title = checkedText(reader.find("title", true), path + ".title", findings);
  const json::Value* pages = reader.find("pages", true);
  if (pages != nullptr && json::isKind(*pages, json::JsonKind::Array, path + ".pages", "a list of names", findings)) {
    for (const json::Value& page : pages->items) chapter.pages.push_back(checkedText(&page, path + ".pages", findings));
  }
  reader.finish();
  return chapter;
}

Result<std::vector<Chapter>> readContents(const std::string& file) {
  const Result<std::string> text = json::readTextFile(file, "a list of contents");
  if (!text) return text.problems();
  const Result<json::Value> root = json::parse(text.value(), file);
  if (!root) return root.problems();
  json::Findings findings(file);
  std::vector<Chapter> chapters;
  if (json::isKind(root.value(), json::JsonKind::Object, "", "contents in {}", findings)) {
    json::ObjectReader reader(root.value(), "", "contents", findings);
    const json::Value* version = reader.find("underact_guide", true);
    if (version != nullptr && version->number != 1.0)
      findings.add(*version, "underact_guide", "This must be 1, the version of contents.");
    const json::Value* list = reader.find("chapters", true);
    if (list != nullptr && json::isKind(*list, json::JsonKind::Array, "chapters", "a list of chapters", findings)) {
      for (const json::Value& chapter : list->items) chapters.push_back(readChapter(chapter, "chapters", findings));
    }
    reader.finish();
  }
  Problems problems = findings.take();
  if (!problems.empty()) return problems;
  return chapters;
}

/// A name that leaves the folder is invalid.
bool isName(const std::string& name) {
  return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

}  // namespace

const Entry* Guide::find(std::string_view name) const {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

Result<Guide> readGuide(const std::string& folder) {
  const std::string file = folder + "/contents.json";
  Result<std::vector<Chapter>> chapters = readContents(file);
  if (!chapters) return chapters.problems();
  Guide guide{folder, std::move(chapters).value(), {}};
  Problems problems;
  for (const Chapter& chapter : guide.chapters) {
    for (const std::string& name : chapter.pages) {
      if (!isName(name) || guide.find(name) != nullptr) {
        problems.push_back({"“" + name + "” is not a page, or appears twice.", {file}});
        continue;
      }
      const std::string page_file = folder + "/" + name + ".md";
      Result<std::string> text = json::readTextFile(page_file, "a page");
      if (!text) {
        problems.insert(problems.end(), text.problems().begin(), text.problems().end());
        continue;
      }
      guide.entries.push_back({name, text.value(), page::readPage(text.value(), page_file)});
    }
  }
  if (!problems.empty()) return problems;
  return guide;
}

Target targetOf(std::string_view link) {
  const std::size_t hash = std::min(link.find('#'), link.size());
  std::string_view path = link.substr(0, hash);
  const std::string anchor(link.substr(std::min(hash + 1, link.size())));
  constexpr std::string_view kScheme = "guide:", kEnding = ".md";
  if (path.substr(0, kScheme.size()) == kScheme) return {true, std::string(path.substr(kScheme.size())), anchor};
  if (path.empty()) return {true, {}, anchor};
  const bool is_page = path.size() > kEnding.size() && path.substr(path.size() - kEnding.size()) == kEnding &&
                       path.find_first_of("/:") == std::string_view::npos;
  if (!is_page) return {};
  path.remove_suffix(kEnding.size());
  return {true, std::string(path), anchor};
}

}  // namespace underact::guide
