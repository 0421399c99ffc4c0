#include <algorithm>
#include <filesystem>
#include <sstream>

#include "app/guide/markdown.h"
#include "app/guide/scene_page.h"
#include "core/json/json.h"
#include "core/json/text.h"

namespace underact::guide {
namespace {

namespace fs = std::filesystem;

bool isScene(const fs::path& path) {
  const std::string name = path.filename().string();
  return path.extension() == ".json" && name.find("schema") == std::string::npos;
}

std::string textAt(const json::Value& scene, const char* key) {
  const json::Value* value = scene.find(key);
  return value == nullptr ? std::string() : value->text;
}

/// The teaching notes of the scene; Markdown with formulas, as in the file.
void writeTeaching(const json::Value& scene, std::ostream& out) {
  const json::Value* teach = scene.find("teach");
  if (teach == nullptr) return;
  struct Row {
    const char *key, *word;
  };
  for (const Row& row : {Row{"try", "Try"}, Row{"equation", "Equation"}}) {
    const std::string text = textAt(*teach, row.key);
    if (!text.empty()) out << "\n**" << row.word << ":** " << text << '\n';
  }
}

}  // namespace

Result<std::string> sceneList(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (isScene(entry.path())) files.push_back(entry.path());
  }
  if (error || files.empty()) return Problems{{"There are no scenes in this folder.", {folder}}};
  std::sort(files.begin(), files.end());
  std::ostringstream out;
  out << "# The scenes\n\nThe scenes that come with the program, in teaching order. In the window, each title below "
         "opens its scene. This page is generated from the scene files.\n";
  Problems problems;
  for (const fs::path& file : files) {
    const Result<std::string> text = json::readTextFile(file.string(), "a scene");
    const Result<json::Value> scene = text ? json::parse(text.value(), file.string()) : text.problems();
    if (!scene) {
      problems.insert(problems.end(), scene.problems().begin(), scene.problems().end());
      continue;
    }
    const std::string name = file.stem().string();
    out << "\n## " << plainText(name) << "\n\n**[" << plainText(textAt(scene.value(), "title")) << "](scene:" << name
        << ")**\n\n"
        << plainText(textAt(scene.value(), "about")) << '\n';
    writeTeaching(scene.value(), out);
  }
  if (!problems.empty()) return problems;
  return out.str();
}

}  // namespace underact::guide
