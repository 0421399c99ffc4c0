#include "core/mesh_file/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/translate.h"
#include "core/mesh_file/scan.h"

namespace underact::mesh_file {
namespace {

constexpr std::size_t kMaxElements = 64;
constexpr std::size_t kMaxProperties = 256;

struct Type {
  const char* word;
  const char* known;  // OpenMesh knows only some of the words
  const char* known_length;
  int bytes;
};

// A length of 2^31 or more does not fit into any file that is read here, so signed and unsigned are equivalent.
constexpr std::array<Type, 16> kTypes{{{"char", "char", "uchar", 1},
                                       {"int8", "char", "uchar", 1},
                                       {"uchar", "uchar", "uchar", 1},
                                       {"uint8", "uchar", "uchar", 1},
                                       {"short", "short", "uint16", 2},
                                       {"int16", "short", "uint16", 2},
                                       {"ushort", "ushort", "uint16", 2},
                                       {"uint16", "ushort", "uint16", 2},
                                       {"int", "int", "int", 4},
                                       {"int32", "int", "int", 4},
                                       {"uint", "uint", "int", 4},
                                       {"uint32", "uint", "int", 4},
                                       {"float", "float", nullptr, 4},
                                       {"float32", "float", nullptr, 4},
                                       {"double", "double", nullptr, 8},
                                       {"float64", "double", nullptr, 8}}};

const Type* typeOf(std::string_view word) {
  const auto found = std::find_if(kTypes.begin(), kTypes.end(), [word](const Type& type) { return word == type.word; });
  return found == kTypes.end() ? nullptr : &*found;
}

Problems damaged(const char* pattern, const std::string& what = {}) {
  return {{phrase(pattern, {what}), {}}};
}

bool readProperty(Scan& words, PlyElement& element) {
  std::string_view word = words.word();
  PlyProperty property;
  if (word == "list") {
    const Type* length = typeOf(words.word());
    if (length == nullptr || length->known_length == nullptr) return false;
    property.is_list = true;
    property.length_type = length->known_length;
    property.length_bytes = length->bytes;
    word = words.word();
  }
  const Type* type = typeOf(word);
  property.name = words.word();
  if (type == nullptr || property.name.empty() || element.properties.size() >= kMaxProperties) return false;
  property.type = type->known;
  property.bytes = type->bytes;
  element.properties.push_back(std::move(property));
  return true;
}

bool readElement(Scan& words, PlyHeader& header) {
  PlyElement element;
  element.name = words.word();
  if (!readInteger(words.word(), element.count) || header.elements.size() >= kMaxElements) return false;
  header.elements.push_back(std::move(element));
  return true;
}

const PlyElement* elementOf(const PlyHeader& header, const char* name) {
  const auto found = std::find_if(header.elements.begin(), header.elements.end(),
                                  [name](const PlyElement& element) { return element.name == name; });
  return found == header.elements.end() ? nullptr : &*found;
}

bool isTwice(const PlyHeader& header, const char* name) {
  return std::count_if(header.elements.begin(), header.elements.end(),
                       [name](const PlyElement& element) { return element.name == name; }) > 1;
}

/// Empty where the header is of a surface.
Problems checkSurface(const PlyHeader& header) {
  const PlyElement* corners = elementOf(header, "vertex");
  const PlyElement* faces = elementOf(header, "face");
  if (corners == nullptr)
    return {{phrase(TRANSLATE_NOOP("problem", "The PLY file contains no vertices (element vertex).")), {}}};
  if (elementOf(header, "tristrips") != nullptr) {
    return {{phrase(TRANSLATE_NOOP(
                 "problem", "The PLY file contains triangle strips, which cannot be read. Save it with single faces.")),
             {}}};
  }
  if (faces == nullptr || faces->count == 0) {
    return {
        {phrase(TRANSLATE_NOOP("problem",
                               "The PLY file contains points but no faces. A surface needs faces: create them in the "
                               "program that made the points.")),
         {}}};
  }
  if (isTwice(header, "vertex") || isTwice(header, "face"))
    return damaged(TRANSLATE_NOOP("problem", "The PLY header is damaged: it declares vertices or faces twice."));
  for (const char* axis : {"x", "y", "z"}) {
    const auto is = [axis](const PlyProperty& property) { return property.name == axis; };
    const auto& properties = corners->properties;
    const auto found = std::find_if(properties.begin(), properties.end(), is);
    if (found == properties.end() || std::count_if(properties.begin(), properties.end(), is) != 1) {
      return damaged(TRANSLATE_NOOP("problem", "The PLY header is damaged: the vertices do not have exactly one %1."),
                     axis);
    }
    if (found->is_list || (found->type != "float" && found->type != "double")) {
      return {
          {phrase(
               TRANSLATE_NOOP(
                   "problem",
                   "The PLY file contains %1 of its vertices as integers. Save it with float or double coordinates."),
               {axis}),
           {}}};
    }
  }
  const auto lists = std::count_if(faces->properties.begin(), faces->properties.end(), [](const PlyProperty& property) {
    return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
  });
  if (lists != 1)
    return damaged(TRANSLATE_NOOP(
        "problem", "The PLY header is damaged: the faces do not have exactly one list of vertices (vertex_indices)."));
  return {};
}

}  // namespace

Result<PlyHeader> readPlyHeader(std::string_view head) {
  Scan lines(head);
  PlyHeader header;
  if (lowered(Scan(lines.line()).word()) != "ply")
    return damaged(TRANSLATE_NOOP("problem", "The PLY header is damaged: it does not begin with \"ply\"."));
  bool has_format = false;
  while (!lines.atEnd()) {
    Scan words(lines.line());
    const std::string_view key = words.word();
    if (key == "end_header") {
      header.bytes = lines.place();
      if (!has_format)
        return damaged(TRANSLATE_NOOP("problem", "The PLY header is damaged: it has no line \"format\"."));
      Problems problems = checkSurface(header);
      if (!problems.empty()) return problems;
      return header;
    }
    bool is_ok = true;
    if (key == "format") {
      const std::string_view encoding = words.word();
      has_format = encoding == "ascii" || encoding == "binary_little_endian" || encoding == "binary_big_endian";
      header.encoding = encoding == "ascii"               ? PlyEncoding::Text
                        : encoding == "binary_big_endian" ? PlyEncoding::BigEndian
                                                          : PlyEncoding::LittleEndian;
      is_ok = has_format;
    } else if (key == "element") {
      is_ok = readElement(words, header);
    } else if (key == "property") {
      is_ok = !header.elements.empty() && readProperty(words, header.elements.back());
    } else if (key != "comment" && key != "obj_info" && !key.empty()) {
      is_ok = false;
    }
    if (!is_ok)
      return damaged(TRANSLATE_NOOP("problem", "The PLY header is damaged: line %1 is not valid."),
                     std::to_string(lines.lineNumber() - 1));
  }
  return damaged(TRANSLATE_NOOP("problem", "The PLY header is damaged: it has no end."));
}

double minBytes(const PlyHeader& header) {
  double bytes = 0.0;
  for (const PlyElement& element : header.elements) {
    double each = 0.0;
    for (const PlyProperty& property : element.properties) {
      // In text: a digit and a blank.
      each += header.encoding == PlyEncoding::Text ? 2.0 : property.is_list ? property.length_bytes : property.bytes;
    }
    bytes += each * static_cast<double>(element.count);
  }
  // The last line need not end.
  return header.encoding == PlyEncoding::Text ? bytes - 1.0 : bytes;
}

}  // namespace underact::mesh_file
