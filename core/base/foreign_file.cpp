#include "core/base/foreign_file.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/base/translate.h"

namespace underact {
namespace {

constexpr const char* kArchive =
    TRANSLATE_NOOP("problem", "This is a %1 archive. Unpack it, and open a file that is in it.");
constexpr const char* kModel = TRANSLATE_NOOP(
    "problem", "This is a %1 model. Save it as STL or OBJ with the program that it comes from, and open that file.");
constexpr const char* kDocument = TRANSLATE_NOOP("problem", "a %1 document");
constexpr const char* kPicture = TRANSLATE_NOOP("problem", "a picture (%1)");
constexpr const char* kFilm = TRANSLATE_NOOP("problem", "a film (%1)");
constexpr const char* kProgram = TRANSLATE_NOOP("problem", "a program");
constexpr const char* kUtf16 = TRANSLATE_NOOP("problem", "This text is in UTF-16. Save it as UTF-8.");
constexpr const char* kPage =
    TRANSLATE_NOOP("problem", "This is a web page, not the file itself. Download the file again.");

struct Format {
  std::size_t at;
  std::string_view start, name;
  const char* pattern;
};
constexpr auto kFormats = std::to_array<Format>({{0, "\x1F\x8B", "gzip", kArchive},
                                                 {0, "PK\3\4", "ZIP", kArchive},
                                                 {0, "\xFD\x37zXZ", "xz", kArchive},
                                                 {0, "\x28\xB5\x2F\xFD", "Zstandard", kArchive},
                                                 {0, "7z\xBC\xAF\x27\x1C", "7z", kArchive},
                                                 {0, "BZh", "bzip2", kArchive},
                                                 {0, "Rar!", "RAR", kArchive},
                                                 {257, "ustar", "tar", kArchive},
                                                 {30, "[Content_Types].xml", "Microsoft Office", kDocument},
                                                 {30, "mimetypeapplication/vnd.oasis", "LibreOffice", kDocument},
                                                 {0, "\xFF\xFE", "", kUtf16},
                                                 {0, "\xFE\xFF", "", kUtf16},
                                                 {0, "ISO-10303-21;", "STEP", kModel},
                                                 {72, "S      1", "IGES", kModel},
                                                 {0, "glTF", "glTF", kModel},
                                                 {0, "Kaydara FBX", "FBX", kModel},
                                                 {0, "BLENDER", "Blender", kModel},
                                                 {0, "#VRML", "VRML", kModel},
                                                 {0, "%PDF-", "PDF", kDocument},
                                                 {0, "%!PS", "PostScript", kDocument},
                                                 {0, "\xD0\xCF\x11\xE0", "Microsoft Office", kDocument},
                                                 {0, "\x89PNG", "PNG", kPicture},
                                                 {0, "\xFF\xD8\xFF", "JPEG", kPicture},
                                                 {0, "GIF8", "GIF", kPicture},
                                                 {0, "II*", "TIFF", kPicture},
                                                 {8, "WEBPVP8", "WebP", kPicture},
                                                 {4, "ftyp", "MP4", kFilm},
                                                 {0, "\x1A\x45\xDF\xA3", "WebM", kFilm},
                                                 {0, "\x7F\x45LF", "", kProgram}});

Sentence sentenceOf(const char* pattern, std::string_view name) {
  Sentence what = phrase(pattern, {std::string(name)});
  return pattern == kArchive || pattern == kModel || pattern == kUtf16 ? what : notOpened(std::move(what));
}

std::string_view behind(std::string_view text, std::string_view mark, std::size_t from) {
  const std::size_t at = text.find(mark, from);
  return at == std::string_view::npos ? std::string_view() : text.substr(at + mark.size());
}

}  // namespace

Sentence foreignKind(std::string_view head) {
  if (head.starts_with("version https://git-lfs"))
    return phrase(
        TRANSLATE_NOOP("problem", "This is a pointer of Git LFS, not the file itself. Get it with \"git lfs pull\"."));
  std::string start(head.substr(std::min(head.find_first_not_of(" \t\r\n\xEF\xBB\xBF"), head.size()), 14));
  for (char& c : start) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const std::string_view root = xmlRoot(head);
  if (start.starts_with("<html") || start == "<!doctype html" || root == "html") return phrase(kPage);
  if (root == "svg") return sentenceOf(kPicture, "SVG");
  if (root == "COLLADA" || root == "X3D") return sentenceOf(kModel, root);
  Sentence found;
  for (const Format& one : kFormats)  // a later one is more exact
    if (head.size() > one.at && head.substr(one.at).starts_with(one.start)) found = sentenceOf(one.pattern, one.name);
  return found;
}

Sentence notOpened(Sentence what) {
  return phrase(TRANSLATE_NOOP("problem",
                               "This is %1. Underact opens scenes, sessions, arm files, meshes, points of curves, "
                               "lessons, lists of figures and notebooks."),
                {std::move(what)});
}

std::string_view xmlRoot(std::string_view head) {
  for (;;) {
    head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n\xEF\xBB\xBF"), head.size()));
    if (head.starts_with("<!--"))
      head = behind(head, "-->", 4);
    else if (head.starts_with("<?") || head.starts_with("<!"))
      head = behind(head, ">", 2);
    else
      break;
  }
  if (!head.starts_with('<')) return {};
  head.remove_prefix(1);
  return head.substr(0, head.find_first_of(" \t\r\n/>"));
}

}  // namespace underact
