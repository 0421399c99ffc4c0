#include "app/guide/markdown.h"

#include <sstream>

namespace underact::guide {

std::string plainText(const std::string& text) {
  std::string made;
  for (const char letter : text) {
    if (std::string("\\`*_[]<>|$#").find(letter) != std::string::npos) made += '\\';
    made += letter;
  }
  return made;
}

std::string cellText(const std::string& text) {
  std::string made = plainText(text);
  for (char& letter : made) letter = letter == '\n' ? ' ' : letter;
  return made;
}

std::string inCode(const std::string& text) {
  std::string made = "`";
  for (const char letter : text) {
    if (letter == '|') made += '\\';
    made += letter;
  }
  return made + "`";
}

std::string listedInCode(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + inCode(word);
  return all;
}

std::string asBlock(const std::string& lines) {
  std::string made;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) made += (line.empty() ? "" : "    ") + line + "\n";
  return made;
}

std::string sentence(std::string text) {
  if (!text.empty() && std::string(".!?").find(text.back()) == std::string::npos) text += '.';
  return text;
}

}  // namespace underact::guide
