#include "app/gui/model/file_kind.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/base/foreign_file.h"
#include "core/base/translate.h"
#include "core/json/text.h"
#include "core/mesh_file/format.h"
#include "core/mesh_file/scan.h"
#include "core/mesh_file/stl_binary.h"
#include "core/system/file.h"
#include "core/system/named_file.h"

namespace underact::gui {
namespace {

constexpr std::string_view kHdf5 = "\x89HDF\r\n\x1A\n";

/// The keys of the object, or of the objects of the list, that a JSON text begins with, right or wrong.
std::set<std::string, std::less<>> keysOf(std::string_view text) {
  std::set<std::string, std::less<>> keys;
  const int wanted = text.starts_with('[') ? 2 : 1;
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '{' || text[at] == '[') ++depth;
    if (text[at] == '}' || text[at] == ']') --depth;
    if (text[at] != '"') continue;
    const std::size_t first = at + 1;
    for (++at; at < text.size() && text[at] != '"'; ++at) at += text[at] == '\\' ? 1 : 0;
    const std::size_t next = text.find_first_not_of(" \t\r\n", std::min(at + 1, text.size()));
    if (depth == wanted && next != std::string_view::npos && text[next] == ':')
      keys.emplace(text.substr(first, at - first));
  }
  return keys;
}

Result<FileKind> kindOfJson(std::string_view text, bool is_whole, bool is_named_so, const std::string& path) {
  const auto keys = keysOf(text);
  const auto has = [&keys](const char* key) { return keys.contains(key); };
  if (has("underact_scene")) return FileKind::Scene;
  if (has("underact_lesson")) return FileKind::Lesson;
  if (has("underact_arm")) return FileKind::Arm;
  if (has("nbformat") || has("cells")) return FileKind::Notebook;
  if (text.starts_with('[') && has("figure") && has("numbers")) return FileKind::Figures;
  const auto own = keys.lower_bound("underact_");
  if (own != keys.end() && own->starts_with("underact_"))
    return Problems{{phrase(TRANSLATE_NOOP("problem",
                                           "This is a file of Underact with the key %1. The window does not open it; "
                                           "the guide says what it is for."),
                            {json::shown(*own)}),
                     {path}}};
  // A scene whose key was forgotten, or comes late, or a slip right at the beginning: the reader of scenes says so.
  if (is_named_so && (!is_whole || keys.empty() || has("constraints"))) return FileKind::Scene;
  return Problems{
      {phrase(
           TRANSLATE_NOOP("problem",
                          "This JSON is none of Underact's: a scene has the key %1, an arm file %2 and a lesson %3."),
           {"underact_scene", "underact_arm", "underact_lesson"}),
       {path}}};
}

Result<FileKind> kindOfXml(std::string_view text, std::string_view root, const std::string& path) {
  if (root != "robot")
    return Problems{
        {phrase(TRANSLATE_NOOP("problem",
                               "This XML begins with the element %1. Underact opens only URDF, which begins with %2."),
                {json::shown(root), json::shown("robot")}),
         {path}}};
  if (text.find("<xacro:") != std::string_view::npos)
    return Problems{{phrase(TRANSLATE_NOOP("problem",
                                           "This is a xacro file, from which URDF is made. Run \"xacro FILE > "
                                           "robot.urdf\", and open robot.urdf.")),
                     {path}}};
  return FileKind::Arm;
}

enum class PointLines { None, Some, Points };

/// Whether the first lines of a text, comments aside, are points, or at least begin with a number.
PointLines pointLinesOf(std::string_view text) {
  constexpr int kLines = 20, kHead = 2;  // names of columns, the number of points
  PointLines found = PointLines::None;
  mesh_file::Scan lines(text);
  for (int seen = 0; seen < kLines && !lines.atEnd();) {
    std::string line(lines.line());
    line.resize(std::min(line.find('#'), line.size()));
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
    mesh_file::Scan words(line);
    int fields = 0, numbers = 0;
    for (std::string_view word = words.word(); !word.empty(); word = words.word(), ++fields) {
      double number = 0.0;
      const char* const end = word.data() + word.size();
      const auto read = std::from_chars(word.data() + (word[0] == '+' ? 1 : 0), end, number);
      numbers += read.ptr == end ? 1 : 0;
      if (fields == 0 && read.ptr == end) found = PointLines::Some;
    }
    if (seen <= kHead && fields >= 3 && numbers == fields) return PointLines::Points;
    seen += fields > 0 ? 1 : 0;
  }
  return found;
}

bool isOneOf(const std::string& extension, std::initializer_list<const char*> which) {
  return std::find(which.begin(), which.end(), extension) != which.end();
}

}  // namespace

Result<FileKind> fileKindOf(std::string_view head, std::uint64_t file_bytes, const std::string& path) {
  const std::string ending = mesh_file::lowered(std::filesystem::path(path).extension().string());
  const auto refuse = [&path](Sentence sentence) { return Problems{{std::move(sentence), {path}}}; };
  if (file_bytes == 0) return refuse(phrase(TRANSLATE_NOOP("problem", "The file is empty.")));
  if (head.starts_with(kHdf5)) return FileKind::Session;
  if (mesh_file::isWholeStlBinary(head, file_bytes)) return FileKind::Mesh;
  if (Sentence foreign = foreignKind(head); !foreign.empty()) return refuse(std::move(foreign));
  const std::string_view text = head.substr(std::min(head.find_first_not_of(" \t\r\n\xEF\xBB\xBF"), head.size()));
  const bool is_text = head.find('\0') == std::string_view::npos;
  if (is_text && (text.starts_with('{') || text.starts_with('[')))
    return kindOfJson(text, head.size() == file_bytes, ending == ".json", path);
  if (const std::string_view root = xmlRoot(text); is_text && !root.empty()) return kindOfXml(text, root, path);
  const Result<mesh_file::Format> mesh = mesh_file::formatOf(head, file_bytes, path);
  if (mesh) return FileKind::Mesh;
  if (isOneOf(ending, {".stl", ".ply", ".off"})) return mesh.problems();
  if (isOneOf(ending, {".h5", ".hdf5"})) return FileKind::Session;  // damaged, or not one: its reader says which
  if (!is_text) return refuse(notOpened(phrase(TRANSLATE_NOOP("problem", "binary data of an unknown format"))));
  if (ending == ".json") return FileKind::Scene;
  if (isOneOf(ending, {".urdf", ".xacro"})) return FileKind::Arm;
  const PointLines numbers = pointLinesOf(text);
  if (numbers == PointLines::Points) return FileKind::Curve;
  if (!isOneOf(ending, {".txt", ".csv", ".tsv", ".xyz", ".pts", ".asc", ".dat"}))
    return refuse(notOpened(phrase(TRANSLATE_NOOP("problem", "a text"))));
  if (numbers == PointLines::Some) return FileKind::Curve;
  return refuse(
      phrase(TRANSLATE_NOOP("problem", "This is a text without the points of a curve: no line begins with a number.")));
}

Result<FileKind> kindOfFile(const std::string& path) {
  if (const auto status = system::statusOf(path); status && status->kind == system::FileKind::Folder)
    return Problems{{phrase(TRANSLATE_NOOP("problem", "This is a folder. Open one of the files in it.")), {path}}};
  const Result<system::NamedFile> file =
      system::NamedFile::open(path, phrase(TRANSLATE_NOOP("problem", "a file for Underact")));
  if (!file) return file.problems();
  std::string head(mesh_file::kHeadBytes, '\0');
  const Result<std::size_t> count = file.value().read(head);
  if (!count) return count.problems();
  head.resize(count.value());
  return fileKindOf(head, file.value().bytes(), path);
}

}  // namespace underact::gui
