#include "core/json/text_file.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/translate.h"

namespace underact::json {

Result<std::string> readTextFile(const std::string& path, const Sentence& what, std::size_t largest) {
  const auto problem = [&](Sentence sentence) { return Problems{{std::move(sentence), {path, 0, 0, ""}}}; };
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    return problem(said(QT_TRANSLATE_NOOP("problem", "This is a folder, not %1 file."), {what}));
  std::ifstream file(path, std::ios::binary);
  if (!file)
    return problem(
        said(QT_TRANSLATE_NOOP("problem", "The file cannot be opened: %1."), {std::generic_category().message(errno)}));
  std::string text;
  std::vector<char> block(std::size_t{1} << 16);
  while (file && text.size() <= largest) {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (text.size() > largest) {
    return problem(said(QT_TRANSLATE_NOOP("problem", "The file is larger than %1 MiB; %2 is far smaller."),
                        {std::to_string(largest >> 20), what}));
  }
  if (!file.eof())
    return problem(
        said(QT_TRANSLATE_NOOP("problem", "The file cannot be read: %1."), {std::generic_category().message(errno)}));
  return text;
}

}  // namespace underact::json
