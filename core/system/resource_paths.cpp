#include "core/system/resource_paths.h"

#include <underact/folders.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/base/translate.h"
#include "core/system/file.h"
#include "core/system/this_process.h"

namespace underact::system {
namespace {

namespace fs = std::filesystem;

struct Row {
  Resource resource;
  const char* installed;   // relative to the data folder
  const char* in_sources;  // relative to that of the sources
  const char* mark;        // a file in it; null: any JSON file that is not a schema
  const char* lost;        // the sentence if there is none
};

constexpr Row kRows[] = {
    {Resource::Scenes, "scenes", "scenes", nullptr,
     TRANSLATE_NOOP("problem",
                    "The scenes that come with Underact were not found in %1. Reinstall Underact, or set "
                    "UNDERACT_DATA_DIR to its data folder (share/underact) or its source folder.")},
    {Resource::Lessons, "lessons", "resources/lessons", nullptr,
     TRANSLATE_NOOP("problem",
                    "The lessons that come with Underact were not found in %1. Reinstall Underact, or set "
                    "UNDERACT_DATA_DIR to its data folder (share/underact) or its source folder.")},
    {Resource::Guide, "guide", "resources/guide", "contents.json",
     TRANSLATE_NOOP("problem",
                    "The guide's pages were not found in %1. Reinstall Underact, or set UNDERACT_DATA_DIR to its data "
                    "folder (share/underact) or its source folder.")},
    {Resource::Python, "python", "app/python", "underact/__main__.py",
     TRANSLATE_NOOP("problem",
                    "The Python package that comes with Underact was not found in %1. Reinstall Underact, or set "
                    "UNDERACT_DATA_DIR to its data folder (share/underact) or its source folder.")},
};

const Row& rowOf(Resource resource) {
  return *std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& row) { return row.resource == resource; });
}

bool isProgram(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && mayExecute(path);
}

bool holds(const fs::path& folder, const char* mark) {
  std::error_code error;
  if (mark != nullptr) return fs::is_regular_file(folder / mark, error);
  const fs::directory_iterator entries(folder, error);
  return !error && std::any_of(begin(entries), end(entries), [](const fs::directory_entry& entry) {
    return entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema";
  });
}

std::string absoluteOr(const std::string& path, const std::string& other) {
  return fs::path(path).is_absolute() ? path : other;
}

std::string listed(const std::vector<std::string>& places) {
  std::string text;
  for (const std::string& place : places) text += (text.empty() ? "" : ", ") + place;
  return text;
}

}  // namespace

SearchRoots searchRoots() {
  SearchRoots from;
  if (const char* stated = std::getenv("UNDERACT_DATA_DIR")) from.stated = absoluteOr(stated, "");
  from.here = fs::path(ownProgram()).parent_path().string();
  // Only beside the program itself: who can write there can change the program, too.
  std::ifstream file(fs::path(from.here) / "underact-places");
  std::string line;
  if (std::getline(file, line)) from.sources = absoluteOr(line, "");
  if (std::getline(file, line)) from.programs = absoluteOr(line, "");
  return from;
}

std::vector<std::string> searchFolders(Resource resource, const SearchRoots& from) {
  const Row& row = rowOf(resource);
  std::vector<std::string> places;
  const auto add = [&places](const std::string& folder, const fs::path& below) {
    if (!folder.empty()) places.push_back((fs::path(folder) / below).lexically_normal().string());
  };
  add(from.stated, row.installed);
  add(from.stated, row.in_sources);
  if (resource == Resource::Python) {
    add(from.here, kPythonFromPrograms);
    add(from.here, "../lib/python3/dist-packages");  // where Debian has it
  } else {
    add(from.here, fs::path(kDataFromPrograms) / row.installed);
  }
  add(from.sources, row.in_sources);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

std::vector<std::string> searchFolders(const std::string& program, const SearchRoots& from) {
  std::vector<std::string> places;
  const auto add = [&](const fs::path& folder) { places.push_back((folder / program).lexically_normal().string()); };
  if (!from.here.empty()) add(from.here);
  if (!from.here.empty()) add(fs::path(from.here) / kHelpersFromPrograms);
  if (!from.programs.empty() && from.programs != from.here) add(from.programs);
  return places;
}

Result<std::string> findResource(Resource resource, const SearchRoots& from) {
  const Row& row = rowOf(resource);
  const std::vector<std::string> places = searchFolders(resource, from);
  std::error_code error;
  for (const std::string& place : places) {
    if (holds(place, row.mark)) return fs::weakly_canonical(place, error).string();
  }
  return Problems{{phrase(row.lost, {listed(places)})}};
}

Result<std::string> findProgram(const std::string& program, const char* variable, const SearchRoots& from) {
  const char* const stated = variable == nullptr ? nullptr : std::getenv(variable);
  const std::vector<std::string> places =
      stated != nullptr && *stated != '\0' ? std::vector<std::string>{stated} : searchFolders(program, from);
  const auto found = std::find_if(places.begin(), places.end(), isProgram);
  if (found != places.end()) return *found;
  return Problems{{phrase(TRANSLATE_NOOP("problem", "%1 was not found. Searched: %2."), {program, listed(places)})}};
}

}  // namespace underact::system
