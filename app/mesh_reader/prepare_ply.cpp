#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "app/mesh_reader/numbers.h"
#include "app/mesh_reader/prepare.h"
#include "core/base/translate.h"
#include "core/mesh_file/ply_header.h"

namespace underact::mesh_reader {
namespace {

using mesh_file::PlyElement;
using mesh_file::PlyEncoding;
using mesh_file::PlyHeader;
using mesh_file::PlyProperty;

constexpr std::uint64_t kMaxCornersOfAPlyFace = 5000;

bool isCoordinate(const PlyProperty& property) {
  return property.name == "x" || property.name == "y" || property.name == "z";
}

int axisOf(const PlyProperty& property) {
  return property.name == "x" ? 0 : property.name == "y" ? 1 : 2;
}

bool isCornerList(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool isKept(const PlyElement& element, const PlyProperty& property) {
  return element.name == "vertex" ? isCoordinate(property) : element.name == "face" && isCornerList(property);
}

std::string plainHeader(const PlyHeader& header) {
  std::string text = "ply\nformat ";
  text += header.encoding == PlyEncoding::Text        ? "ascii"
          : header.encoding == PlyEncoding::BigEndian ? "binary_big_endian"
                                                      : "binary_little_endian";
  text += " 1.0\n";
  for (const PlyElement& element : header.elements) {
    if (element.name != "vertex" && element.name != "face") continue;
    text += "element " + element.name + ' ' + std::to_string(element.count) + '\n';
    for (const PlyProperty& property : element.properties) {
      if (!isKept(element, property)) continue;
      text += "property ";
      if (property.is_list) text += "list " + property.length_type + ' ';
      text += property.type + ' ' + property.name + '\n';
    }
  }
  return text + "end_header\n";
}

/// Reads the body: each function returns false where it ends or is not valid. What is not needed is skipped.
class TextBody {
 public:
  TextBody(std::string_view body, Shift& shift) : words_(body), shift_(shift) {}
  bool number(const PlyProperty& property, bool kept, std::string& to) {
    const std::string_view word = words_.word();
    return kept ? addNumber(word, to, &shift_, axisOf(property)) : !word.empty();
  }
  bool list(const PlyProperty& /*property*/, bool kept, std::string& to) {
    std::uint64_t count = 0;
    if (!mesh_file::readInteger(words_.word(), count)) return false;
    if (kept && count > kMaxCornersOfAPlyFace) return false;
    if (kept) to += std::to_string(count) + ' ';
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::string_view word = words_.word();
      std::int64_t index = 0;
      if (word.empty() || (kept && !mesh_file::readInteger(word, index))) return false;
      if (kept) to += std::to_string(index < 0 || index > INT32_MAX ? INT32_MAX : index) + ' ';
    }
    return true;
  }
  static void endRow(std::string& to) { to += '\n'; }

 private:
  mesh_file::Scan words_;
  Shift& shift_;
};

class BinaryBody {
 public:
  BinaryBody(std::string_view body, bool is_big, Shift& shift) : body_(body), is_big_(is_big), shift_(shift) {}
  bool number(const PlyProperty& property, bool kept, std::string& to) {
    const std::size_t place = to.size();
    if (!take(static_cast<std::uint64_t>(property.bytes), kept, to)) return false;
    if (kept && property.bytes == 4) move<float, std::uint32_t>(axisOf(property), to.data() + place);
    if (kept && property.bytes == 8) move<double, std::uint64_t>(axisOf(property), to.data() + place);
    return true;
  }
  bool list(const PlyProperty& property, bool kept, std::string& to) {
    const auto width = static_cast<std::uint64_t>(property.length_bytes);
    if (body_.size() < width) return false;
    std::uint64_t count = 0;
    for (std::uint64_t byte = 0; byte < width; ++byte) {
      count = count << 8U | static_cast<unsigned char>(body_[is_big_ ? byte : width - 1 - byte]);
    }
    if (kept && count > kMaxCornersOfAPlyFace) return false;
    return take(width, kept, to) && take(count * static_cast<std::uint64_t>(property.bytes), kept, to);
  }
  static void endRow(std::string& /*to*/) {}

 private:
  bool take(std::uint64_t bytes, bool kept, std::string& to) {
    if (body_.size() < bytes) return false;
    if (kept) to += body_.substr(0, bytes);
    body_.remove_prefix(bytes);
    return true;
  }
  /// A coordinate that is a number is moved where it stands.
  template <class Number, class Bits>
  void move(int axis, char* at) {
    Bits bits = 0;
    for (std::size_t byte = 0; byte < sizeof bits; ++byte) {
      bits = bits << 8U | static_cast<unsigned char>(at[is_big_ ? byte : sizeof bits - 1 - byte]);
    }
    const auto value = std::bit_cast<Number>(bits);
    if (!(std::abs(value) < static_cast<Number>(mesh_file::kBeyondAll))) return;
    shift_.is_single = shift_.is_single || sizeof(Number) == sizeof(float);
    const auto moved = static_cast<Number>(shift_.take(axis, static_cast<double>(value)));
    if (moved == value) return;
    bits = std::bit_cast<Bits>(moved);
    for (std::size_t byte = 0; byte < sizeof bits; ++byte) {
      at[is_big_ ? sizeof bits - 1 - byte : byte] = static_cast<char>(bits >> (8U * byte) & 0xFFU);
    }
  }
  std::string_view body_;
  bool is_big_;
  Shift& shift_;
};

/// The row of an element at which the body breaks off; -1: none.
template <class Body>
std::int64_t copyRows(const PlyElement& element, Body& body, std::string& to) {
  const bool any_kept = element.name == "vertex" || element.name == "face";
  for (std::uint64_t row = 0; row < element.count; ++row) {
    for (const PlyProperty& property : element.properties) {
      const bool kept = isKept(element, property);
      const bool is_ok = property.is_list ? body.list(property, kept, to) : body.number(property, kept, to);
      if (!is_ok) return static_cast<std::int64_t>(row);
    }
    if (any_kept) body.endRow(to);
    if (element.properties.empty()) break;  // rows without properties are skipped at once
  }
  return -1;
}

template <class Body>
void copyBody(const PlyHeader& header, Body body, Prepared& prepared) {
  for (const PlyElement& element : header.elements) {
    const std::int64_t row = copyRows(element, body, prepared.bytes);
    if (row >= 0) {
      const char* pattern =
          element.name == "vertex" ? TRANSLATE_NOOP("problem", "The file is damaged: vertex %1 of %2 cannot be read.")
          : element.name == "face" ? TRANSLATE_NOOP("problem", "The file is damaged: face %1 of %2 cannot be read.")
                                   : TRANSLATE_NOOP("problem", "The file is damaged: row %1 of %2 cannot be read.");
      prepared.problem = phrase(pattern, {std::to_string(row + 1), std::to_string(element.count)});
      return;
    }
    if (element.name == "vertex") prepared.corners = element.count;
    if (element.name == "face") prepared.faces = element.count;
  }
}

}  // namespace

Prepared preparePly(const std::string& bytes, Shift& shift) {
  Prepared prepared;
  const Result<PlyHeader> header = mesh_file::readPlyHeader(bytes);
  if (!header) {
    prepared.problem = header.problems()[0].sentence;
    return prepared;
  }
  prepared.bytes.reserve(bytes.size() + 64);
  prepared.bytes = plainHeader(header.value());
  const std::string_view body = std::string_view(bytes).substr(header.value().bytes);
  if (header.value().encoding == PlyEncoding::Text) {
    copyBody(header.value(), TextBody(body, shift), prepared);
  } else {
    copyBody(header.value(), BinaryBody(body, header.value().encoding == PlyEncoding::BigEndian, shift), prepared);
  }
  return prepared;
}

}  // namespace underact::mesh_reader
