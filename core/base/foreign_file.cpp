#include "core/base/foreign_file.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/base/translate.h"

namespace underact {
namespace {

struct Format {
  std::string_view name, start;
};
constexpr auto kFormats = std::to_array<Format>({{"gzip", "\x1F\x8B"},
                                                 {"ZIP", "PK\3\4"},
                                                 {"xz", "\xFD\x37zXZ"},
                                                 {"Zstandard", "\x28\xB5\x2F\xFD"},
                                                 {"7z", "7z\xBC\xAF\x27\x1C"},
                                                 {"bzip2", "BZh"},
                                                 {"RAR", "Rar!"},
                                                 {"UTF-16", "\xFF\xFE"},
                                                 {"UTF-16", "\xFE\xFF"},
                                                 {"STEP", "ISO-10303-21;"},
                                                 {"glTF", "glTF"},
                                                 {"FBX", "Kaydara FBX"},
                                                 {"PDF", "%PDF-"},
                                                 {"PNG", "\x89PNG"},
                                                 {"JPEG", "\xFF\xD8\xFF"},
                                                 {"GIF", "GIF8"},
                                                 {"TIFF", "II*"}});

}  // namespace

Sentence foreignKind(std::string_view head) {
  if (head.starts_with("version https://git-lfs"))
    return phrase(
        TRANSLATE_NOOP("problem", "This is a pointer of Git LFS, not the file itself. Get it with \"git lfs pull\"."));
  std::string start(head.substr(std::min(head.find_first_not_of(" \t\r\n\xEF\xBB\xBF"), head.size()), 14));
  for (char& c : start) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (start.starts_with("<html") || start == "<!doctype html")
    return phrase(TRANSLATE_NOOP("problem", "This is a web page, not the file itself. Download the file again."));
  std::string format = head.size() > 80 && head.substr(72, 8) == "S      1" ? "IGES" : "";
  for (const Format& one : kFormats)
    if (head.starts_with(one.start)) format = one.name;
  if (format.empty()) return {};
  return phrase(
      TRANSLATE_NOOP("problem",
                     "This file has the format %1, which is not read here. Unpack it or convert it: a mesh to "
                     "STL or OBJ, a text to UTF-8."),
      {format});
}

}  // namespace underact
