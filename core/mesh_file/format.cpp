#include "core/mesh_file/format.h"

#include <array>
#include <cstring>
#include <filesystem>

#include "core/base/foreign_file.h"
#include "core/base/translate.h"
#include "core/mesh_file/off_header.h"
#include "core/mesh_file/ply_header.h"
#include "core/mesh_file/scan.h"
#include "core/mesh_file/stl_binary.h"

namespace underact::mesh_file {
namespace {

struct Words {
  const char* word;
  const char* name;
};
constexpr std::array<Words, kFormats> kWords{
    {{"stl-binary", "binary STL"}, {"stl-text", "STL as text"}, {"obj", "OBJ"}, {"ply", "PLY"}, {"off", "OFF"}}};

std::string extensionOf(const std::string& path) {
  return lowered(std::filesystem::path(path).extension().string());
}

/// Whether a line among the first of them is a corner of an OBJ file.
bool hasObjCorner(std::string_view head) {
  Scan lines(head);
  while (!lines.atEnd()) {
    Scan words(lines.line());
    if (words.word() == "v") {
      double value = 0.0;
      const std::string_view word = words.word();
      return std::from_chars(word.data(), word.data() + word.size(), value).ec == std::errc();
    }
  }
  return false;
}

Problem tooShort(const Sentence& states, const std::string& path) {
  return {
      phrase(TRANSLATE_NOOP("problem", "The file is truncated or damaged: it declares %1, but is too short for that."),
             {states}),
      {path}};
}

Sentence cornersText(std::uint64_t count) {
  return phrase(TRANSLATE_NOOP("problem", "%1 vertices"), {std::to_string(count)});
}

Sentence facesText(std::uint64_t count) {
  return phrase(TRANSLATE_NOOP("problem", "%1 faces"), {std::to_string(count)});
}

Sentence both(const Sentence& one, const Sentence& other) {
  return phrase(TRANSLATE_NOOP("problem", "%1 and %2"), {one, other});
}

}  // namespace

const char* wordOf(Format format) {
  return kWords[static_cast<std::size_t>(format)].word;
}

const char* nameOf(Format format) {
  return kWords[static_cast<std::size_t>(format)].name;
}

Result<Format> formatOf(std::string_view head, std::uint64_t file_bytes, const std::string& path) {
  if (file_bytes == 0) return Problems{{phrase(TRANSLATE_NOOP("problem", "The file is empty.")), {path}}};
  const std::string extension = extensionOf(path);
  const std::string first = lowered(Scan(head).word());
  if (isWholeStlBinary(head, file_bytes)) return Format::StlBinary;
  if (Sentence foreign = foreignKind(head); !foreign.empty()) return Problems{{std::move(foreign), {path}}};
  if (first == "ply") return Format::Ply;
  if (isOffKeyword(Scan(head).word())) return Format::Off;
  const std::string start = lowered(head.substr(0, 4096));
  if (first.starts_with("solid") && head.find('\0') == std::string_view::npos &&
      (start.find("facet") != std::string::npos || start.find("endsolid") != std::string::npos)) {
    return Format::StlText;
  }
  if (extension == ".obj") return Format::Obj;
  const bool is_text = head.find('\0') == std::string_view::npos;
  if ((extension == ".stl" && !is_text) || extension == ".stlb") return Format::StlBinary;
  if (extension == ".ply")
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "This is not a PLY file: it does not begin with \"ply\".")), {path}}};
  if (extension == ".off")
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "This is not an OFF file: it does not begin with \"OFF\".")), {path}}};
  if (is_text && hasObjCorner(head)) return Format::Obj;
  return Problems{
      {phrase(TRANSLATE_NOOP("problem", "This is not a mesh that can be read. Use an STL, OBJ, PLY or OFF file.")),
       {path}}};
}

Problems checkHead(Format format, std::string_view head, std::uint64_t file_bytes, const std::string& path) {
  const auto size = static_cast<double>(file_bytes);
  if (format == Format::StlBinary) {
    const std::uint64_t count = stlBinaryCount(head);
    if (file_bytes < kStlHeadBytes) return {tooShort(phrase(TRANSLATE_NOOP("problem", "a binary STL mesh")), path)};
    const std::uint64_t rest = file_bytes - kStlHeadBytes;
    if (rest > 0 && rest % kStlFaceBytes == 0) return {};  // whole faces, whatever their stated number
    if (count * kStlFaceBytes > rest) return {tooShort(facesText(count), path)};
    if (count == 0) return {{phrase(TRANSLATE_NOOP("problem", "The file contains no faces.")), {path}}};
  } else if (format == Format::Ply) {
    const Result<PlyHeader> header = readPlyHeader(head);
    if (!header) return {{header.problems()[0].sentence, {path}}};
    const double min = static_cast<double>(header.value().bytes) + minBytes(header.value());
    if (min > size) {
      Sentence states;
      for (const PlyElement& element : header.value().elements) {
        if (element.name != "vertex" && element.name != "face") continue;
        const Sentence text = element.name == "vertex" ? cornersText(element.count) : facesText(element.count);
        states = states.empty() ? text : both(states, text);
      }
      return {tooShort(states, path)};
    }
  } else if (format == Format::Off) {
    const Result<OffHeader> header = readOffHeader(head);
    if (!header) return {{header.problems()[0].sentence, {path}}};
    const auto corners = static_cast<double>(header.value().corners), faces = static_cast<double>(header.value().faces);
    // "0 0 0" and "0", each with the end of its line, but for the last.
    if (static_cast<double>(header.value().bytes) + 6.0 * corners + 2.0 * faces - 1.0 > size) {
      return {tooShort(both(cornersText(header.value().corners), facesText(header.value().faces)), path)};
    }
  }
  return {};
}

}  // namespace underact::mesh_file
