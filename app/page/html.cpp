#include "app/page/html.h"

#include <cctype>

namespace underact::page {

std::string escaped(std::string_view text) {
  std::string made;
  made.reserve(text.size());
  for (const char letter : text) {
    switch (letter) {
      case '&':
        made += "&amp;";
        break;
      case '<':
        made += "&lt;";
        break;
      case '>':
        made += "&gt;";
        break;
      case '"':
        made += "&quot;";
        break;
      default:
        made += letter;
    }
  }
  return made;
}

std::string anchorOf(std::string_view heading) {
  std::string made;
  for (const char letter : heading) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte >= 0x80 || std::isalnum(byte) != 0 || letter == '-' || letter == '_')
      made += byte < 0x80 ? static_cast<char>(std::tolower(byte)) : letter;
    else if (letter == ' ')
      made += '-';
  }
  return made;
}

}  // namespace underact::page
