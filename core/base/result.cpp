#include "core/base/result.h"

#include "core/base/printed.h"

namespace underact {

std::string describe(const Problem& problem) {
  std::string text;
  if (!problem.place.file.empty()) text += problem.place.file + ":";
  if (problem.place.line > 0) {
    text += std::to_string(problem.place.line) + ":" + std::to_string(problem.place.column) + ":";
  }
  if (!text.empty()) text += " ";
  text += "error: ";
  if (!problem.place.key.empty()) text += problem.place.key + ": ";
  return printed(text + problem.sentence);
}

}  // namespace underact
