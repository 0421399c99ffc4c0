#include "core/json/text_file.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

namespace underact::json {

Result<std::string> readTextFile(const std::string& path, const std::string& what, std::size_t largest) {
  const auto problem = [&](const std::string& sentence) { return Problems{{sentence, {path, 0, 0, ""}}}; };
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return problem("This is a folder, not " + what + " file.");
  std::ifstream file(path, std::ios::binary);
  if (!file) return problem("The file cannot be opened: " + std::generic_category().message(errno) + ".");
  std::string text;
  std::vector<char> block(std::size_t{1} << 16);
  while (file && text.size() <= largest) {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (text.size() > largest) {
    return problem("The file is larger than " + std::to_string(largest >> 20) + " MiB; " + what + " is far smaller.");
  }
  if (!file.eof()) return problem("The file cannot be read: " + std::generic_category().message(errno) + ".");
  return text;
}

}  // namespace underact::json
