#include "core/base/foreign_file.h"

#include <algorithm>
#include <string>

#include "core/base/translate.h"

namespace underact {
namespace {

// Each format, and what its files begin with.
constexpr std::string_view kFormats =
    "gzip \x1F\x8B\nZIP PK\3\4\nxz \xFD\x37zXZ\nZstandard \x28\xB5\x2F\xFD\n7z 7z\xBC\xAF\x27\x1C\nbzip2 BZh\nRAR "
    "Rar!\n"
    "UTF-16 \xFF\xFE\nUTF-16 \xFE\xFF\nSTEP ISO-10303-21;\nglTF glTF\nFBX Kaydara FBX\nPDF %PDF-\nPNG \x89PNG\n"
    "JPEG \xFF\xD8\xFF\nGIF GIF8\nTIFF II*\n";

}  // namespace

Sentence foreignKind(std::string_view head) {
  if (head.starts_with("version https://git-lfs"))
    return said(
        TRANSLATE_NOOP("problem", "This is a pointer of Git LFS, not the file itself. Get it with \"git lfs pull\"."));
  std::string start(head.substr(std::min(head.find_first_not_of(" \t\r\n\xEF\xBB\xBF"), head.size()), 14));
  for (char& c : start) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (start.starts_with("<html") || start == "<!doctype html")
    return said(TRANSLATE_NOOP("problem", "This is a web page, not the file itself. Download the file again."));
  std::string format = head.size() > 80 && head.substr(72, 8) == "S      1" ? "IGES" : "";
  for (std::size_t at = 0, end = 0; (end = kFormats.find('\n', at)) != std::string_view::npos; at = end + 1) {
    const std::size_t bytes = kFormats.find(' ', at) + 1;
    if (head.starts_with(kFormats.substr(bytes, end - bytes))) format = kFormats.substr(at, bytes - 1 - at);
  }
  if (format.empty()) return {};
  return said(TRANSLATE_NOOP("problem",
                             "This file has the format %1, which is not read here. Unpack it or convert it: a mesh to "
                             "STL or OBJ, a text to UTF-8."),
              {format});
}

}  // namespace underact
