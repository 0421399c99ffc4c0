#include <algorithm>
#include <filesystem>
#include <string_view>

#include "core/base/translate.h"
#include "core/record/recorder.h"

namespace underact::record {

std::string nameOfPart(const std::string& path, int part) {
  constexpr std::string_view kOwnEnding = ".underact.h5";
  const std::string ending =
      path.ends_with(kOwnEnding) ? std::string(kOwnEnding) : std::filesystem::path(path).extension().string();
  return path.substr(0, path.size() - ending.size()) + "_" + std::to_string(part) + ending;
}

std::vector<Sentence> newsOf(const RecorderStatus& before, const RecorderStatus& now) {
  std::vector<Sentence> news;
  for (std::size_t index = std::max<std::size_t>(before.files.size(), 1); index < now.files.size(); ++index)
    news.push_back(
        phrase(TRANSLATE_NOOP("problem", "The session is as long as one may be: the recording goes on in %1."),
               {now.files[index]}));
  if (before.dropped == 0 && now.dropped > 0)
    news.push_back(phrase(TRANSLATE_NOOP(
        "problem", "Ticks are missing in the recording: the computer is too busy to write them. The servo goes on.")));
  if (before.recording && !now.recording)
    for (const Problem& problem : now.problems) news.push_back(problem.sentence);
  return news;
}

}  // namespace underact::record
